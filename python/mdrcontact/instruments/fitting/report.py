# SPDX-License-Identifier: GPL-3.0-or-later
"""Results as one HTML file that needs nothing else: no network, no further files."""

from __future__ import annotations

import base64
import hashlib
import platform
from collections.abc import Iterable, Mapping, Sequence
from datetime import datetime, timezone
from html import escape
from typing import Any

import numpy as np

from ..._boundary import native
from ..._text import html_table
from ..._units import practical, shown
from ...panels import Figure
from ...panels.matplotlib import png
from .quantities import dimension_of, measured, plain, probability, words_of

_STYLE = """
body { font: 15px/1.5 system-ui, sans-serif; color: #1a1a1a; max-width: 62em; margin: 2em auto; padding: 0 1em; }
h1 { font-size: 1.5em; } h2 { font-size: 1.1em; margin-top: 2em; border-bottom: 1px solid #ccc; }
table { border-collapse: collapse; } th, td { text-align: left; padding: 0.25em 1.2em 0.25em 0; vertical-align: top; }
td:not(:last-child) { white-space: nowrap; }
th { border-bottom: 1px solid #888; } tr:nth-child(even) td { background: #f6f6f6; }
.doubt { color: #a33c00; font-weight: bold; } img { max-width: 100%; } footer { margin-top: 3em; color: #666; font-size: 0.85em; }
"""


def page(title: str, blocks: Iterable[str]) -> str:
    """A page from its blocks, with the versions of what made it at its end."""
    number = int(native.version())
    versions = [
        f"mdrcontact {number // 10000}.{number // 100 % 100}.{number % 100}",
        f"NumPy {np.__version__}",
        f"Python {platform.python_version()}",
        f"{platform.system()} {platform.machine()}",
    ]
    now = datetime.now(timezone.utc).strftime("%Y-%m-%d %H:%M UTC")
    return (
        f'<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta '
        f'charset="utf-8">\n<title>{escape(title)}</title>\n<style>{_STYLE}</style>\n'
        f"</head>\n<body>\n<h1>{escape(title)}</h1>\n" + "\n".join(blocks) + f"\n<footer>{escape(', '.join(versions))}; "
        f"{now}</footer>\n"
        "</body>\n</html>\n"
    )


def heading(words: str) -> str:
    """The title of a section."""
    return f"<h2>{escape(words)}</h2>"


def paragraph(words: str, doubt: bool = False) -> str:
    """A paragraph; `doubt` highlights it as a warning."""
    return f'<p class="doubt">{escape(words)}</p>' if doubt else f"<p>{escape(words)}</p>"


def items(lines: Iterable[str], doubt: bool = False) -> str:
    """A list."""
    kind = ' class="doubt"' if doubt else ""
    return "<ul>" + "".join(f"<li{kind}>{escape(line)}</li>" for line in lines) + "</ul>"


def preformatted(words: str) -> str:
    """Text as it is."""
    return f"<pre>{escape(words)}</pre>"


def origin(files: Mapping[str, bytes], problem: str, command: str = "") -> list[str]:
    """Where a result comes from: files that were read, by name, the text of the problem file, and the command."""
    rows = [[name, str(len(content)), hashlib.sha256(content).hexdigest()] for name, content in files.items()]
    blocks = [heading("Origin"), html_table([["file", "bytes", "SHA-256"], *rows])]
    blocks += [paragraph("Command:"), preformatted(command)] if command else []
    return [*blocks, paragraph("Problem file:"), preformatted(problem)]


def picture(figure: Figure, words: str) -> str:
    """A figure inside the page."""
    return f'<img alt="{escape(words)}" src="data:image/png;base64,{base64.b64encode(png(figure)).decode()}">'


def blocks_of(result: Any, notes: Sequence[str] = (), level: float = 0.95) -> list[str]:
    """Everything about one fit: estimates, picture, warnings, what was read and what was assumed."""
    blocks = []
    if result.describes_data is False:
        blocks.append(paragraph(f"The model {result.misfit_words()}: read the warnings before the numbers.", doubt=True))
    if not result.converged:
        blocks.append(paragraph("The search did not converge: these are the best values found.", doubt=True))
    blocks += [html_table(estimates_of(result, level)), picture(result.plot(), "data, fit and residuals")]
    blocks += [heading("Warnings"), items(result.warnings, doubt=True) if result.warnings else paragraph("None.")]
    if notes:
        blocks += [heading("What was read"), items(notes)]
    blocks += [heading("What was assumed"), assumptions(result)]
    blocks += [heading("Quality of the fit"), items(_quality(result))]
    return blocks


def blocks_of_gel(result: Any, notes: Sequence[str] = ()) -> list[str]:
    """Everything about one fit of a gel: estimates, picture, notes, what was read and what was assumed."""
    rows = [["", "estimate", "95 % interval"]]
    for name, value in result.values.items():
        unit = practical(dimension_of(name), [value])
        low, high = (f"{end / unit.factor:.5g}" for end in result.intervals[name])
        ends = f"{low} to {high} {unit.symbol}".rstrip()
        rows.append([f"{words_of(name)} ({name})", measured(name, value, result.errors[name]), ends])
    blocks = [
        html_table(rows),
        picture(result.plot(), "data, fit and residuals"),
        heading("Warnings"),
        items(result.notes, doubt=True),
    ]
    blocks += [heading("What was read"), items(notes)] if notes else []
    assumed = [
        f"medium: {result.medium!r}",
        f"drainage: {result.drainage}",
        f"{result.points} readings of the same standard deviation",
    ]
    return [*blocks, heading("What was assumed"), items(assumed)]


def estimates_of(result: Any, level: float = 0.95) -> list[list[str]]:
    """Rows of the estimates of a fit with their intervals, below the titles."""
    rows = [["", "estimate", f"{100.0 * level:g} % interval", "known beforehand", "doubts"]]
    for name in result.names:
        ends = result.interval_as_text(name, level)
        prior = result.problem.free[name].prior
        known = "in a joint prior" if _in_joint_prior(result, name) else measured(name, *prior) if prior else ""
        doubts = "; ".join(result.doubts(name))
        rows.append([f"{words_of(name)} ({name})", result.as_text(name), ends, known, doubts])
    return rows


def _in_joint_prior(result: Any, name: str) -> bool:
    return bool(np.any(result.problem.weights[:, result.problem.names.index(name)] != 0.0))


def assumptions(result: Any) -> str:
    """Assumptions of the fit: bodies, noise, and every fixed number."""
    if result.data.sd is None:
        noise = "the noise is the same for all readings and estimated from the residuals"
    elif result.noise_is_known:
        noise = "the standard deviations of the readings are those given"
    else:
        noise = "of the standard deviations of the readings the ratios are known, their size is estimated"
    lines = [
        f"indenter: {result.indenter!r}",
        f"medium: {result.medium!r}",
        f"instrument: {result.instrument!r}",
        noise,
        *result.contact_depth_words(),
        "standard errors allow for correlated residuals by the restricted likelihood of a first-order autoregression",
    ]
    return items(lines) + html_table(_fixed(result))


def _fixed(result: Any) -> list[list[str]]:
    rows = [["held fixed", "value"]]
    for name, value in result.values.items():
        if name not in result.names and np.isfinite(value):
            rows.append([f"{words_of(name)} ({name})", shown(value, dimension_of(name), 6)])
    return rows


def _quality(result: Any) -> list[str]:
    dof = result.degrees_of_freedom
    lines = [f"{len(result.data)} points, {result.iterations} iterations, {result.evaluations} evaluations of the model"]
    lines.append(f"the model {result.misfit_words()}")
    if result.noise_is_known and dof >= 1.0:
        lines.append(f"chi-square {plain(result.chi_square)} for {plain(dof)} degrees of freedom")
    if len(result.data) > 2:
        lines.append(
            f"residuals in order along the curve: correlation of neighbours {result.lag_correlation:.2f}, random with "
            f"{probability(result.pattern_probability)}"
        )
        lines.append(f"AIC {plain(result.aic)}, BIC {plain(result.bic)}")
    names = result.names
    correlation = result.correlation
    for i, one in enumerate(names):
        lines += [f"correlation of {words_of(one)} and {words_of(names[j])}: {correlation[i, j]:+.3f}" for j in range(i)]
    return lines
