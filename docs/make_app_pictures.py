# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the pictures of app.md by the tests of the page in a browser. python docs/make_app_pictures.py [FOLDER]

FOLDER is docs/pictures by default. It needs chromium, chromedriver and what tests/python/test_app_browser.py imports.
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from pathlib import Path

from PIL import Image

DOCS = Path(__file__).resolve().parent
TESTS = DOCS.parent / "tests" / "python" / "test_app_browser.py"
PICTURES = {"app_view_design": "everyone and design", "app_view_stress": "everyone and stress", "app_error": "an_error"}
PICTURES |= {"app_fit": "dropped_table", "app_many": "many_curves"}
"""Pictures of the guide, and the tests that leave them."""
WIDTH = 1000
"""Largest width of a picture in pixels."""


def main(folder: Path) -> None:
    """Run the tests, and keep smaller copies of their pictures."""
    with tempfile.TemporaryDirectory() as made:
        tests = " or ".join(f"({one})" for one in PICTURES.values())
        command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", TESTS, "-k", tests]
        subprocess.run(command, env={**os.environ, "MDRCONTACT_PICTURES": made}, check=True)
        for name in PICTURES:
            picture = Image.open(Path(made) / f"{name}.png").convert("RGB")
            picture.thumbnail((WIDTH, WIDTH), Image.Resampling.LANCZOS)
            file = folder / f"{name}.png"
            picture.quantize(128, method=Image.Quantize.MAXCOVERAGE, kmeans=1, dither=Image.Dither.NONE).save(file, optimize=True)
            print(f"written: {file.name}, {file.stat().st_size / 1000:.0f} kB")


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else DOCS / "pictures")
