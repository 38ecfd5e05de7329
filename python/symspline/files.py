"""Reading and writing files of splines and meshes."""

from ._symspline import (
    dumps,
    formats,
    loads,
    read,
    write,
)
