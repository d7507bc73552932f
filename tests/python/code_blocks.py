# SPDX-License-Identifier: GPL-3.0-or-later
"""The code blocks of a Markdown page, and running them in order as a reader would.

Each block says its language, and every language has one way to be run; a block of `text` right after a block that runs is
what that block prints. `file=NAME` after the language puts the block into a file of this name first.
"""

from __future__ import annotations

import contextlib
import io
import os
import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

from conftest import ROOT
from markdown_it import MarkdownIt

from mdrcontact.instruments.files.fit_file import load_fit_file
from mdrcontact.problem import load, load_map, read

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

WARNINGS = ("-Wall", "-Wextra", "-Werror")


class Block(NamedTuple):
    """A code block, and what the page says that it prints."""

    page: str
    line: int
    language: str
    file: str | None
    text: str
    output: str | None

    @property
    def place(self) -> str:
        """Where the block stands."""
        return f"{self.page}, line {self.line}"


def blocks(path: Path) -> list[Block]:
    """All code blocks of a page. One that would not be run is an error."""
    found: list[Block] = []
    previous = None
    for token in MarkdownIt("commonmark").enable("table").parse(path.read_text(encoding="utf-8")):
        line = token.map[0] + 1 if token.map else 0
        assert token.type != "code_block", f"{path.name}, line {line}: an indented block of code: fence it and say its language"
        assert "<pre" not in token.content or token.type == "fence", f"{path.name}, line {line}: <pre>: fence it"
        if token.type == "fence":
            words = re.fullmatch(r"(\w+)(?: file=(\S+))?", token.info.strip())
            assert words, f"{path.name}, line {line}: the block must say its language: ```{token.info}"
            language, file = words[1], words[2]
            assert language in RUN, f"{path.name}, line {line}: there is no way to run {language!r}; there are {', '.join(RUN)}"
            if language == "text" and not file and previous == "fence" and found[-1].language != "text":
                found[-1] = found[-1]._replace(output=token.content)
            found.append(Block(path.name, line, language, file, token.content, None))
        previous = token.type
    return found


class Reader:
    """Works through a page in a folder of its own, with the library installed under ~/.local."""

    def __init__(self, folder: Path, prefix: Path) -> None:
        self.folder, self.prefix = folder, prefix
        self.variables: dict[str, Any] = {"__name__": "__main__"}
        self.objects: list[Path] = []
        self.environment = {**os.environ, "HOME": str(folder), "PATH": f"{Path(sys.executable).parent}:{os.environ['PATH']}"}
        self.environment["PKG_CONFIG_PATH"] = str(prefix / "lib" / "pkgconfig")
        (folder / ".local").symlink_to(prefix)
        (folder / "examples").symlink_to(ROOT / "examples")

    def run(self, block: Block) -> None:
        """Runs a block and compares what it prints."""
        if block.file:
            (self.folder / block.file).write_text(block.text, encoding="utf-8")
        try:
            printed = RUN[block.language](self, block)
        except Exception as problem:
            raise AssertionError(f"{block.place}: {problem}") from problem
        if block.output is not None:
            assert same_output(block.output, printed), f"{block.place} prints\n{printed}\nand not\n{block.output}"

    def command(self, *words: str | Path) -> str:
        """Runs a command; returns what it prints."""
        done = subprocess.run(
            [str(word) for word in words], cwd=self.folder, env=self.environment, capture_output=True, text=True, check=False
        )
        assert done.returncode == 0, f"{words} ends with status {done.returncode}\n{done.stdout}{done.stderr}"
        return done.stdout

    def python(self, block: Block) -> str:
        """All blocks of a page are one session."""
        with contextlib.redirect_stdout(io.StringIO()) as printed:
            exec(compile(block.text, block.place, "exec"), self.variables)
        return printed.getvalue()

    def shell(self, block: Block) -> str:
        """All lines must succeed."""
        return self.command("bash", "-euo", "pipefail", "-c", block.text)

    def compiled(self, block: Block, suffix: str, options: tuple[str, ...], main: str) -> str:
        """Compiles without a warning; a main program is linked with the blocks before it, and run."""
        stem = Path(block.file).stem if block.file else f"block_{block.line}"
        source, target = self.folder / (block.file or stem + suffix), self.folder / f"{stem}.o"
        source.write_text(block.text, encoding="utf-8")
        compiler = {".c": "gcc", ".cpp": "g++"}.get(suffix, "gfortran")
        package = "mdrcontact-static" if compiler == "gfortran" else "mdrcontact"
        flags = self.command("pkg-config", "--cflags", "--libs", package).split()
        self.command(compiler, *options, *WARNINGS, "-c", source, "-o", target, *flags)
        if not re.search(main, block.text, flags=re.MULTILINE | re.IGNORECASE):
            self.objects.append(target)
            return ""
        program = self.folder / f"{stem}.out"
        others = [] if suffix == ".cpp" else self.objects
        self.command("gfortran" if others else compiler, target, *others, "-o", program, *flags, "-lm",
                     f"-Wl,-rpath,{self.prefix / 'lib'}")  # fmt: skip
        return self.command(program)

    def toml(self, block: Block) -> str:
        """The reader of its kind of file takes it; a part of a problem file stands in a ready-made one."""
        table = tomllib.loads(block.text)
        path = self.folder / (block.file or "block.toml")
        path.write_text(block.text, encoding="utf-8")
        if "structure" in table:
            load_map(path)
        elif "fit" in table or "data" in table:
            load_fit_file(path)
        elif {"indenter", "medium", "compute"} <= set(table):
            load(path)
        else:
            whole = tomllib.loads((ROOT / "examples" / "problems" / "sio2_on_si.toml").read_text(encoding="utf-8"))
            read({**whole, **table}, folder=self.folder)
        return ""

    def cmake(self, block: Block) -> str:
        """The project configures and builds."""
        (self.folder / "CMakeLists.txt").write_text(block.text, encoding="utf-8")
        self.command("cmake", "-S", ".", "-B", "build_check", f"-DCMAKE_PREFIX_PATH={self.prefix}")
        return self.command("cmake", "--build", "build_check")


RUN: dict[str, Callable[[Reader, Block], str]] = {
    "python": Reader.python,
    "sh": Reader.shell,
    "c": lambda reader, block: reader.compiled(block, ".c", ("-std=c11",), r"^int main\("),
    "cpp": lambda reader, block: reader.compiled(block, ".cpp", ("-std=c++17",), r"^int main\("),
    "fortran": lambda reader, block: reader.compiled(block, ".f90", ("-std=f2018",), r"^\s*program "),
    "fortranfixed": lambda reader, block: reader.compiled(block, ".f", ("-std=legacy",), r"^\s*program "),
    "toml": Reader.toml,
    "cmake": Reader.cmake,
    "text": lambda reader, block: "",
}
"""How a block of each language is run. `text` is what is printed, or no code at all."""

_NUMBER = re.compile(r"(?<![\w.])[-+]?\d+(?:\.\d*)?(?:[eE][-+]?\d+)?")


def same_output(said: str, printed: str) -> bool:
    """Whether the words are the same and the numbers agree to a unit of the last digit said. A line `...` stands for any lines."""
    parts = [part.splitlines() for part in re.split(r"^\.\.\.\n", said, flags=re.MULTILINE)]
    lines = printed.rstrip().splitlines()
    at = 0
    for i, part in enumerate(parts):
        last = len(lines) - len(part)
        if i == 0:
            places = [0]
        elif i == len(parts) - 1:
            places = [last] if last >= at else []
        else:
            places = list(range(at, last + 1))
        fitting = next((p for p in places if p <= last and _same_lines(part, lines[p : p + len(part)])), None)
        if fitting is None or len(parts) == 1 and len(part) != len(lines):
            return False
        at = fitting + len(part)
    return True


def _same_lines(said: list[str], printed: list[str]) -> bool:
    return all(_same_line(*pair) for pair in zip(said, printed, strict=True))


def _same_line(said: str, printed: str) -> bool:
    def words(line: str) -> list[str]:
        return _NUMBER.sub("#", line).split()

    numbers = _NUMBER.findall(said), _NUMBER.findall(printed)
    if words(said) != words(printed):
        return False
    return all(abs(float(a) - float(b)) <= 1.0001 * _unit(a) for a, b in zip(*numbers, strict=True))


def _unit(number: str) -> float:
    """One unit of the last digit."""
    mantissa, _, exponent = number.lower().partition("e")
    decimals = len(mantissa.partition(".")[2])
    if not exponent and "." not in mantissa:
        return 0.0  # a count
    return 10.0 ** (int(exponent or 0) - decimals)
