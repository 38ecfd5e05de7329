"""Shrinks the pictures that the gallery shows: 1000 pixels wide at most, 160 colours."""

import re
from pathlib import Path

from PIL import Image

folder = Path(__file__).parent
shown = re.findall(r"\(gallery/(\w+)\.png\)", (folder.parent / "gallery.md").read_text())
for name in shown:
    picture = Image.open(folder.parents[1] / "target" / f"{name}.png").convert("RGB")
    picture.thumbnail((1000, 4000), Image.LANCZOS)
    picture.quantize(160, dither=Image.Dither.NONE).save(folder / f"{name}.png", optimize=True)
