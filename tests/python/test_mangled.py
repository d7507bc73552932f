# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of measurements, damaged in the ways of instruments, spreadsheets and people: each is refused in one sentence, fitted
rightly, or fitted with a warning that the sound file does not have.

What no reading can show is left out: a whole column in another unit within a factor of 300, or rows of a smooth curve shifted."""

from __future__ import annotations

import random
import warnings

import pytest
from conftest import ROOT

import mdrcontact as mdr
import mdrcontact.instruments as mdi
from mdrcontact.instruments.files.fit_file import load_fit_file

FOLDER = ROOT / "examples" / "fit"
FILES = {
    "sphere_on_oxide.csv": 72e9,
    "afm_on_rubber.csv": 2e6,
    "csm_on_oxide.csv": 72e9,
    "indent_on_oxide.txt": 72e9,
    "raw_afm_on_rubber.txt": 2e6,
}
"""Film moduli in examples/fit/make_data.py."""
DAMAGES = {}


def damage(function):
    """Damages: (random, titles, rows, separator) -> text."""
    DAMAGES[function.__name__] = function
    return function


def join(titles, rows, separator):
    return separator.join(titles) + "\n" + "".join(separator.join(row) + "\n" for row in rows)


def part_of(draw, rows, low=0.5, high=0.9):
    """A value between its smallest and its largest one of the last column."""
    values = [float(row[-1]) for row in rows]
    return min(values) + (max(values) - min(values)) * draw.uniform(low, high)


@damage
def cut_at_the_end(draw, titles, rows, separator):
    return join(titles, rows[: draw.randrange(5, len(rows))], separator)


@damage
def cut_at_the_start(draw, titles, rows, separator):
    return join(titles, rows[draw.randrange(1, len(rows) - 5) :], separator)


@damage
def cut_within_a_line(draw, titles, rows, separator):
    return join(titles, rows[: draw.randrange(len(rows) // 2, len(rows))], separator)[: -draw.randrange(2, 7)]


@damage
def cut_within_the_table(draw, titles, rows, separator):
    first = draw.randrange(1, len(rows) - 2)
    return join(titles, rows[:first] + rows[first + draw.randrange(1, len(rows) // 2) :], separator)


@damage
def backwards(draw, titles, rows, separator):
    return join(titles, rows[::-1], separator)


@damage
def shuffled(draw, titles, rows, separator):
    return join(titles, draw.sample(rows, len(rows)), separator)


@damage
def decimal_commas(draw, titles, rows, separator):
    return join(titles, rows, separator.replace(",", ";")).replace(".", ",")


@damage
def decimal_commas_here_and_there(draw, titles, rows, separator):
    mixed = [[cell.replace(".", ",") for cell in row] if draw.random() < 0.5 else row for row in rows]
    return join(titles, mixed, separator.replace(",", ";"))


@damage
def decimal_commas_between_commas(draw, titles, rows, separator):
    return join(titles, [[cell.replace(".", ",") for cell in row] for row in rows], ",")


@damage
def groups_of_thousands(draw, titles, rows, separator):
    return join(titles, [[f"{float(cell):,.4f}" for cell in row] for row in rows], separator.replace(",", "\t"))


@damage
def rows_of_nan(draw, titles, rows, separator):
    rows = [["nan"] * len(row) if draw.random() < 0.03 else row for row in rows]
    return join(titles, rows, separator)


@damage
def cells_without_numbers(draw, titles, rows, separator):
    words = ["", "---", "#N/A", "1.#QNAN", "inf", "NaN", "-"]
    return join(titles, [[draw.choice(words) if draw.random() < 0.03 else cell for cell in row] for row in rows], separator)


@damage
def a_line_of_words_inside(draw, titles, rows, separator):
    first = draw.randrange(5, len(rows) - 5)
    return join(titles, rows[:first] + [["Segment 2"]] + rows[first:], separator)


@damage
def titles_again_inside(draw, titles, rows, separator):
    first = draw.randrange(5, len(rows) - 5)
    return join(titles, rows[:first] + [titles] + rows[first:], separator)


@damage
def twice(draw, titles, rows, separator):
    return join(titles, rows + rows, separator)


@damage
def a_block_twice(draw, titles, rows, separator):
    first = draw.randrange(len(rows) - 20)
    return join(titles, rows[: first + 20] + rows[first:], separator)


@damage
def the_first_row_50_times(draw, titles, rows, separator):
    return join(titles, rows[:1] * 50 + rows[1:], separator)


@damage
def stuck(draw, titles, rows, separator):
    first = draw.randrange(len(rows) // 3, len(rows) - 10)
    return join(titles, rows[:first] + [rows[first]] * (len(rows) - first), separator)


@damage
def a_column_less(draw, titles, rows, separator):
    j = draw.randrange(len(titles))
    return join(titles[:j] + titles[j + 1 :], [row[:j] + row[j + 1 :] for row in rows], separator)


@damage
def cells_less(draw, titles, rows, separator):
    j, first = draw.randrange(len(titles)), draw.randrange(len(rows))
    return join(titles, rows[:first] + [row[:j] + row[j + 1 :] for row in rows[first:]], separator)


@damage
def cells_more(draw, titles, rows, separator):
    return join(titles, [[*row, "1.0"] if draw.random() < 0.5 else row for row in rows], separator)


@damage
def a_title_less(draw, titles, rows, separator):
    return join(titles[1:], rows, separator)


@damage
def a_column_of_indices(draw, titles, rows, separator):
    return join(titles, [[str(i), *row] for i, row in enumerate(rows)], separator)


@damage
def titles_swapped(draw, titles, rows, separator):
    i, j = draw.sample(range(len(titles)), 2)
    titles = list(titles)
    titles[i], titles[j] = titles[j], titles[i]
    return join(titles, rows, separator)


@damage
def columns_swapped_inside(draw, titles, rows, separator):
    first = draw.randrange(len(rows) // 4, 3 * len(rows) // 4)
    return join(titles, rows[:first] + [row[:-2] + [row[-1], row[-2]] for row in rows[first:]], separator)


@damage
def another_kind_of_unit(draw, titles, rows, separator):
    j = draw.randrange(len(titles) - 2, len(titles))
    title = titles[j].replace("mN", "nm") if "mN" in titles[j] else titles[j].replace("nm", "mN").replace("N_per_m", "nm")
    return join([*titles[:j], title.replace("nN", "um"), *titles[j + 1 :]], rows, separator)


@damage
def a_row_of_wrong_units(draw, titles, rows, separator):
    return join(titles, [[draw.choice(["um", "N", "-"])] * len(titles), *rows], separator)


@damage
def the_last_column_negative(draw, titles, rows, separator):
    return join(titles, [[*row[:-1], str(-float(row[-1]))] for row in rows], separator)


@damage
def saturated(draw, titles, rows, separator):
    top = part_of(draw, rows)
    return join(titles, [[*row[:-1], f"{min(float(row[-1]), top):.5g}"] for row in rows], separator)


@damage
def saturated_below(draw, titles, rows, separator):
    least = part_of(draw, rows, 0.1, 0.5)
    return join(titles, [[*row[:-1], f"{max(float(row[-1]), least):.5g}"] for row in rows], separator)


@damage
def zeros_at_the_end(draw, titles, rows, separator):
    return join(titles, rows + [["0"] * len(titles)] * 20, separator)


@damage
def zeros_inside(draw, titles, rows, separator):
    return join(titles, [["0"] * len(row) if draw.random() < 0.02 else row for row in rows], separator)


@damage
def a_column_that_ends_in_zeros(draw, titles, rows, separator):
    first = draw.randrange(len(rows) // 2, len(rows) - 10)
    return join(titles, rows[:first] + [[*row[:-1], "0"] for row in rows[first:]], separator)


@damage
def a_spike(draw, titles, rows, separator):
    i, factor = draw.randrange(len(rows) // 2, len(rows) - 3), draw.choice([1000.0, 10.0, -1.0, 0.1])
    return join(titles, [*rows[:i], [*rows[i][:-1], str(factor * float(rows[i][-1]))], *rows[i + 1 :]], separator)


@damage
def lost_points(draw, titles, rows, separator):
    return join(titles, [[cell.replace(".", "") if draw.random() < 0.1 else cell for cell in row] for row in rows], separator)


@damage
def lost_separators(draw, titles, rows, separator):
    first = draw.randrange(len(rows))
    return join(titles, rows[:first] + [["".join(row)] for row in rows[first:]], separator)


@damage
def lost_signs_of_exponents(draw, titles, rows, separator):
    return join(titles, [[f"{float(cell):.4e}".replace("e-", "e+") for cell in row] for row in rows], separator)


@damage
def quotes(draw, titles, rows, separator):
    return join([f'"{title}"' for title in titles], [[f'"{cell}"' for cell in row] for row in rows], separator)


@damage
def no_titles(draw, titles, rows, separator):
    return join(rows[0], rows[1:], separator)


@damage
def a_preamble_with_numbers(draw, titles, rows, separator):
    return f"Test 12 3.4\nDate 2024-01-02\n1.0{separator}2.0\nOperator: A B\n" + join(titles, rows, separator)


@damage
def separators_at_the_end(draw, titles, rows, separator):
    return join([*titles, ""], [[*row, ""] for row in rows], separator).replace("\n", "\r\n")


@damage
def spaces(draw, titles, rows, separator):
    return join(titles, rows, "  ")


@damage
def two_digits(draw, titles, rows, separator):
    return join(titles, [[f"{float(cell):.2g}" for cell in row] for row in rows], separator)


@damage
def constant(draw, titles, rows, separator):
    j = draw.randrange(len(titles) - 2, len(titles))
    return join(titles, [[*row[:j], rows[0][j], *row[j + 1 :]] for row in rows], separator)


def fitted(folder, name, change=None):
    """The film's modulus and its standard error, and the warnings of a fit."""
    path = folder / name
    text = (FOLDER / name).read_text()
    if change is not None:
        separator = "," if name.endswith(".csv") else "\t"
        titles, *rows = [line.split(separator) for line in text.splitlines()]
        text = change(titles, rows, separator)
    path.write_text(text)
    problem = load_fit_file((FOLDER / name).with_suffix(".toml"))
    data, _ = problem.read_data(path)
    result = mdi.fit(data, problem.indenter, problem.medium, problem.free, instrument=problem.instrument, **problem.options)
    return result.estimates["coating.E"], result.standard_errors["coating.E"], result.warnings


@pytest.fixture(scope="module")
def usual(tmp_path_factory):
    """The first words of the warnings of each sound file: whatever numbers follow, they speak of no damage."""
    folder = tmp_path_factory.mktemp("sound")
    shown = {name: {words[:20] for words in fitted(folder, name)[2]} for name in FILES}
    assert set().union(*shown.values()) == {"the tip is taken as ", "1 reading cannot sho"}
    return shown


@pytest.mark.parametrize("kind", DAMAGES)
def test_damaged_files_are_refused_or_right_or_warned_of(kind, usual, tmp_path):
    draw = random.Random(kind)
    for name in draw.sample(list(FILES), 3):
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            try:
                value, error, words = fitted(tmp_path, name, lambda *table: DAMAGES[kind](draw, *table))
            except mdr.MDRError as refusal:
                assert "\n" not in str(refusal)
                continue
        if not {w[:20] for w in words} - usual[name]:
            assert abs(value - FILES[name]) < max(3.5 * error, 0.01 * FILES[name]), name
