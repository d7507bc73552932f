# SPDX-License-Identifier: GPL-3.0-or-later
"""The code in docs/fitting.md runs as it stands."""

from __future__ import annotations

import re

from conftest import ROOT


def test_the_tutorial_runs(monkeypatch, capsys):
    monkeypatch.chdir(ROOT)
    blocks = re.findall(r"```python\n(.*?)```", (ROOT / "docs" / "fitting.md").read_text(), flags=re.S)
    assert len(blocks) == 3
    space: dict[str, object] = {}
    for block in blocks:
        exec(compile(block, "docs/fitting.md", "exec"), space)
    assert "converged" in capsys.readouterr().out
