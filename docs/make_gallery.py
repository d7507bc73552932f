# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the figures of gallery.md by the scripts of examples/python. python docs/make_gallery.py [FOLDER]

FOLDER is docs/pictures by default.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
from pathlib import Path

from PIL import Image

DOCS = Path(__file__).resolve().parent
SCRIPTS = sorted((DOCS.parent / "examples" / "python").glob("*.py"))
WIDTH = 800
"""Largest width of a figure in pixels."""


def main(folder: Path) -> None:
    """Run every script in an empty folder and keep a smaller copy of its figure."""
    folder.mkdir(exist_ok=True)
    for script in SCRIPTS:
        with tempfile.TemporaryDirectory() as work:
            subprocess.run([sys.executable, script], cwd=work, check=True, stdout=subprocess.DEVNULL)
            figure = Image.open(Path(work) / f"{script.stem}.png").convert("RGB")
        figure.thumbnail((WIDTH, WIDTH), Image.Resampling.LANCZOS)
        file = folder / f"gallery_{script.stem}.png"
        figure.quantize(64).save(file, optimize=True)
        print(f"written: {file.name}, {file.stat().st_size / 1000:.0f} kB")


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else DOCS / "pictures")
