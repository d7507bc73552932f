# SPDX-License-Identifier: GPL-3.0-or-later
"""The C reference: every function is described, and its example compiles and runs."""

from __future__ import annotations

import os
import re
import subprocess
import sys

import pytest
from conftest import ROOT

sys.path.insert(0, str(ROOT / "docs"))

import c_reference  # noqa: E402

HEADERS = c_reference.read()
FUNCTIONS = c_reference.functions(HEADERS)
WARNINGS = ("-Wall", "-Wextra", "-Werror", "-Wno-unused-variable", "-Wno-unused-but-set-variable", "-Wno-unused-function")
PROGRAM = """\
#include "c_examples.h"

{functions}

int main(void)
{{
    static const struct {{ const char *name; int (*run)(void); }} examples[] = {{{table}}};
    int failures = 0;
    if (make_contacts() || make_others() || make_problem()) {{
        printf("the objects: %s\\n", mdr_last_error());
        return 2;
    }}
    for (size_t i = 0; i < sizeof examples / sizeof *examples; i++) {{
        if (examples[i].run()) {{
            printf("FAILED %s: %s\\n", examples[i].name, mdr_last_error());
            failures++;
        }}
    }}
    return failures > 0;
}}
"""


def program(functions):
    """A C program that runs the examples of functions, each in a function of its own."""
    bodies = [
        f"static int example_{entity.name}(void)\n{{\nint status = MDR_SUCCESS;\n{entity.example}\nreturn status;\n}}\n"
        for entity in functions
    ]
    table = ", ".join(f'{{"{entity.name}", example_{entity.name}}}' for entity in functions)
    return PROGRAM.format(functions="\n".join(bodies), table=table)


def arguments_of(entity):
    """Names of the arguments in the declaration of a function."""
    inside = entity.declaration.partition("(")[2]
    return [name for name in re.findall(r"(\w+)(?:\[[^\]]*\])*(?=[,)])", inside) if name != "void"]


@pytest.mark.parametrize("entity", FUNCTIONS, ids=lambda entity: entity.name)
def test_every_function_has_a_description_and_an_example(entity):
    assert len(entity.text) > 20 and entity.text[0].isupper()
    assert re.match(r"[A-Z][a-z]+[ .]", entity.text), "the first word is a verb: Create, Compute, Return"
    assert list(entity.parameters) == arguments_of(entity)
    assert all(entity.parameters.values())
    assert re.search(rf"\b{entity.name}\(", entity.example)
    result = entity.declaration.partition(" ")[0]
    assert result != "int" or entity.name == "mdr_version" or re.search(rf"status = {entity.name}\(", entity.example)


def test_every_entity_is_described():
    described = {entity.name for header in HEADERS for entity in header.entities}
    for header in HEADERS:
        text = re.sub(r"/\*.*?\*/", "", (ROOT / "include" / header.name).read_text(encoding="utf-8"), flags=re.DOTALL)
        declared = re.findall(r"^typedef struct (\w+)", text, re.MULTILINE) + re.findall(r"^enum (\w+) \{", text, re.MULTILINE)
        declared += re.findall(r"^(?:const )?\w+ \*?(mdr_\w+)\([^)]*\);", text, re.MULTILINE)
        assert set(declared) <= described, header.name
    members = [
        (entity.name, name)
        for header in HEADERS
        for entity in header.entities
        for name, words in entity.members.items()
        if not words
    ]
    assert not members


def test_links_of_the_pages_lead_somewhere():
    pages = c_reference.pages(HEADERS)
    anchors = {name: set(re.findall(r"^### (\w+)$", text.lower(), re.MULTILINE)) for name, text in pages.items()}
    for name, text in pages.items():
        for target, anchor in re.findall(r"\]\((\w+\.md)#(\w+)\)", text):
            assert anchor in anchors[target], (name, target, anchor)
    assert sum(text.count("](contact.md#") for text in pages.values()) > 50


def test_all_functions_are_listed_by_task_once():
    rows = [line for line in (ROOT / "docs" / "c-api.md").read_text(encoding="utf-8").splitlines() if line.startswith("| ")]
    listed = re.findall(r"`(mdr_\w+)\(\)`", "\n".join(rows))
    assert sorted(listed) == sorted(entity.name for entity in FUNCTIONS)


@pytest.mark.slow
def test_examples_run(installed, tmp_path):
    assert run(program(FUNCTIONS), installed, tmp_path) == ""


@pytest.mark.slow
def test_a_wrong_example_is_found(installed, tmp_path):
    broken = c_reference.Entity("", "function", "mdr_profile_sphere", "", "", example="status = mdr_profile_sphere(-1.0, &ball);")
    assert "FAILED mdr_profile_sphere: " in run(program([broken]), installed, tmp_path)


def run(text, prefix, folder):
    """Compile a program without a warning and run it; return the lines of what failed."""
    (folder / "examples.c").write_text(text, encoding="utf-8")
    flags = [f"-I{ROOT / 'tests' / 'headers'}", f"-I{ROOT / 'include'}", f"-L{prefix / 'lib'}", f"-Wl,-rpath,{prefix / 'lib'}"]
    command = ["gcc", "-std=c11", *WARNINGS, *flags, "examples.c", "-o", "examples", "-lmdrcontact", "-lm"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    done = subprocess.run([folder / "examples"], cwd=folder, capture_output=True, text=True, check=False, env=os.environ)
    assert done.returncode in (0, 1), done.stdout + done.stderr
    return "\n".join(line for line in done.stdout.splitlines() if line.startswith("FAILED"))
