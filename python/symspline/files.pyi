"""Reading and writing files of splines and meshes."""

from collections.abc import Mapping, Sequence
from os import PathLike
from typing import Any

from typing_extensions import TypeAlias

from .mesh import Mesh
from .typing import ArrayLike, Shape

_Value: TypeAlias = Shape | Mesh | ArrayLike
_Values: TypeAlias = _Value | Mapping[str, _Value] | Sequence[_Value] | Sequence[tuple[str | None, _Value]]

def read(path: str | PathLike[str]) -> list[tuple[str | None, Any]]: ...
def write(path: str | PathLike[str], values: _Values) -> None: ...
def loads(content: str | bytes, format: str = "json") -> list[tuple[str | None, Any]]: ...
def dumps(values: _Values, format: str = "json") -> bytes: ...
def formats() -> list[tuple[str, bool, bool]]: ...
