# SPDX-License-Identifier: GPL-3.0-or-later
"""Rust declarations of all that is in mdrcontact.h: declare.py HEADER > mdrcontact.rs. Called by build.rs."""

import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "python" / "src"))
from wrap_header import enumerations, prototypes, structures, without_comments  # noqa: E402

KINDS = {"int": "c_int", "double": "f64", "char": "c_char", "size_t": "usize", "void": "c_void", "address": "*const c_void"}
RESERVED = {"in": "r#in", "type": "r#type"}  # words of the language


def argument(words):
    """One argument of a function: `const double d[]` as `d: *const f64`."""
    constant, kind, stars, inner, name, array = re.fullmatch(r"(const )?(\w+) (\**)(const )?(\w+)(\[\d*\])?", words).groups()
    pointers = len(stars) + bool(array)
    rust = KINDS.get(kind, kind)
    for level in range(pointers):
        rust = f"*{'const' if (inner if level else constant) else 'mut'} {rust}"
    return f"{RESERVED.get(name, name)}: {rust}"


def declarations(text):
    """The lines of the file."""
    found = structures(text)
    yield from ("use std::os::raw::{c_char, c_int, c_void};", "")
    for enumeration in enumerations(text):
        yield from (f"pub const MDR_{name}: c_int = {value};" for name, value in enumeration)
    for name in re.findall(r"typedef struct (\w+) \w+;", text):
        yield f"#[repr(C)] pub struct {name} {{ _private: [u8; 0] }}"
    for name, members in found.items():
        fields = (f"pub {member}: {f'[{KINDS[kind]}; {length}]' if length else KINDS[kind]}" for kind, member, length in members)
        yield f"#[repr(C)] #[derive(Clone, Copy)] pub struct {name} {{ {', '.join(fields)} }}"
    for name, words in re.findall(r"typedef int \(\*(\w+)\)\(([^)]*)\);", text):
        taken = ", ".join(argument(" ".join(word.split())) for word in words.split(","))
        yield f'pub type {name} = Option<unsafe extern "C" fn({taken}) -> c_int>;'
    yield 'extern "C" {'
    for result, name, words in prototypes(text):
        returned = "" if result == "void" else " -> " + argument(f"{result} it".replace("* ", "*")).removeprefix("it: ")
        yield f"    pub fn {name}({', '.join(map(argument, words))}){returned};"
    yield "}"


if __name__ == "__main__":
    print("\n".join(declarations(without_comments(sys.argv[1]))))
