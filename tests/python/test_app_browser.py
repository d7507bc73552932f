# SPDX-License-Identifier: GPL-3.0-or-later
"""The page of `mdrcontact app` in a browser, as its users drive it. Set MDRCONTACT_PICTURES to a folder to keep its pictures."""

from __future__ import annotations

import contextlib
import csv
import io
import json
import os
import random
import threading
import time
from pathlib import Path

import numpy as np
import pytest
from conftest import ROOT

import mdrcontact as mdr
from mdrcontact import problem, studies
from mdrcontact._units import parse, with_micro
from mdrcontact.cli import main
from mdrcontact.instruments import schema as measured
from mdrcontact.problem import edit, schema

for name in ("dash", "dash_ag_grid", "dash_bootstrap_components", "tomlkit", "matplotlib", "selenium", "axe_core_python", "PIL"):
    pytest.importorskip(name)

import axe_core_python  # noqa: E402
from browser import CHROMIUM, DRIVER, Page, chromium, resize  # noqa: E402
from PIL import Image  # noqa: E402
from selenium.webdriver.common.action_chains import ActionChains  # noqa: E402
from selenium.webdriver.common.by import By  # noqa: E402
from selenium.webdriver.common.keys import Keys  # noqa: E402
from selenium.webdriver.support.ui import Select  # noqa: E402

from mdrcontact.app import Session, design, make_app  # noqa: E402
from mdrcontact.app.server import listen  # noqa: E402

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(
        CHROMIUM is None or DRIVER is None, reason="needs chromium and chromedriver: apt-get install chromium-driver"
    ),
    pytest.mark.filterwarnings("ignore::ResourceWarning"),
]

PROBLEMS, FITS = ROOT / "examples" / "problems", ROOT / "examples" / "fit"
AXE = Path(axe_core_python.__file__).parent / "axe.min.js"
PICTURES = os.environ.get("MDRCONTACT_PICTURES")


@pytest.fixture(scope="module")
def driver():
    found = chromium()
    yield found
    found.quit()


@pytest.fixture
def open_page(driver):
    """Opens a page; at its end nothing is in its console, and no other machine was asked."""
    pages = []

    def opened(text="", files=None, port=0):
        pages.append(Page(driver, text, files, port))
        return pages[-1]

    resize(driver, 1360, 1000)
    yield opened
    for page in pages:
        errors, hosts = page.errors(), page.hosts()
        page.close()
        assert not errors and not hosts


def picture(page, name):
    """Keep a picture for the guide."""
    if PICTURES:
        Path(PICTURES).mkdir(exist_ok=True)
        page.driver.save_screenshot(str(Path(PICTURES) / f"app_{name}.png"))


def text_of(name):
    return (PROBLEMS / f"{name}.toml").read_text(encoding="utf-8")


def command_line(*arguments):
    """The output of a command."""
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        assert main([*map(str, arguments)]) == 0
    return printed.getvalue()


def check_access(driver):
    """Fail where a rule of axe for those who cannot see, hear or point well is broken."""
    driver.execute_script(AXE.read_text(encoding="utf-8"))
    found = driver.execute_async_script("const done = arguments[0]; axe.run().then(done, one => done({violations: [String(one)]}))")
    words = [f"{one['id']}: {[node['html'][:200] for node in one['nodes'][:3]]}" for one in found["violations"]]
    assert not words, "\n".join(words)
    assert len(found["passes"]) > 15


class Keyboard:
    """Keys alone; the browser says what has the focus."""

    def __init__(self, page):
        self.page, self.driver = page, page.driver

    @property
    def focus(self):
        return self.driver.switch_to.active_element

    def send(self, *keys):
        """Press keys one after the other, the first one held if it is Ctrl or Alt."""
        chain = ActionChains(self.driver)
        if keys[0] in (Keys.CONTROL, Keys.ALT):
            chain.key_down(keys[0]).send_keys(*keys[1:]).key_up(keys[0]).perform()
        else:
            chain.send_keys(*keys).perform()

    def go(self, dom_id):
        """Press Tab until a component has the focus."""
        for _ in range(500):
            if self.focus.get_attribute("id") == dom_id:
                return
            self.send(Keys.TAB)
        raise AssertionError(f"the focus never comes to {dom_id}")

    def type(self, path, value):
        self.go(self.page.dom_id(path))
        self.send(Keys.CONTROL, "a")
        self.send(value, Keys.ENTER)
        self.page.idle()


def test_a_design_by_the_keyboard_alone(open_page):
    page = open_page()
    page.idle()
    keys = Keyboard(page)
    assert page.numbers()["force"] == "17.107 mN"
    for _ in range(3):  # the list takes the first letters for an example that begins with them
        keys.go("design-example")
        keys.send("tin_on_st")
        page.idle()
        if "on steel" in page.text:
            break
    keys.go(page.dom_id("indenter/shape"))
    keys.send("parab")
    page.idle()
    assert keys.focus.get_attribute("id") == page.dom_id("indenter/shape")
    keys.type("indenter/radius", "20 um")
    keys.go(page.dom_id("add/medium/layer", "act"))
    keys.send(Keys.ENTER)
    page.idle()
    assert keys.focus.get_attribute("id") == page.dom_id("add/medium/layer", "act")
    keys.type("medium/layer/0/E", "300 GPa")
    keys.type("medium/layer/0/thickness", "100 nm")
    keys.type("compute/max_depth", "20 nm")
    own = problem.read_text(page.text)
    force = float(own.contact().at_depth(20e-9).force)
    assert parse(page.numbers()["force"], mdr._units.FORCE) == pytest.approx(force, rel=1e-4)
    layers = edit.value(page.text, ("medium", "layer"))
    assert [one["thickness"] for one in layers] == ["100 nm", "2 um"] and own.indenter == mdr.Paraboloid(20e-6)
    picture(page, "keyboard")
    # what is not entered yet is undone in its field, then the last change of the form
    keys.go(page.dom_id("compute/points"))
    keys.send("7")
    keys.send(Keys.CONTROL, "z")
    assert keys.focus.get_attribute("value") == "100"
    keys.send(Keys.TAB)
    keys.send(Keys.CONTROL, "z")
    page.idle()
    assert problem.read_text(page.text).control.values[-1] == pytest.approx(50e-9)
    # tabs by arrows
    for _ in range(300):
        if keys.focus.get_attribute("name") == "design-tab" or "design-tab" in (keys.focus.get_attribute("id") or ""):
            break
        keys.send(Keys.TAB)
    keys.send(Keys.ARROW_RIGHT)
    page.idle()
    assert page.said == "Models computed" and page.numbers()["spread"]


def test_keys_undo_every_change_and_remove_a_message(open_page):
    first = text_of("sio2_on_si")
    page = open_page(first)
    page.idle()
    keys = Keyboard(page)
    for path, value in (("compute/max_depth", "40 nm"), ("indenter/radius", "ten")):
        page.type(path, value)
    assert "ten" in page.alert
    keys.send(Keys.ESCAPE)
    page.wait(lambda: not page.alert, "no message")
    for _ in range(2):
        keys.send(Keys.CONTROL, "z")
        page.idle()
    assert page.text == first and not page.alert and page.field("compute/max_depth").get_attribute("value") == "100 nm"
    keys.send(Keys.CONTROL, "z")
    page.idle()
    assert page.text == first


def test_a_new_command_on_the_same_port_shows_its_own_file(open_page, driver):
    page = open_page(text_of("sio2_on_si"))
    page.type("compute/max_depth", "40 nm")
    page.tab("Models")
    driver.get(page.base + page.session.secret)  # the same address again
    page.wait(lambda: page.all(".form fieldset"))
    page.idle()
    assert page.field("compute/max_depth").get_attribute("value") == "40 nm"
    assert page.said == "Models computed"
    page.close()
    new = open_page(text_of("tin_on_steel"), port=page.server.port)
    new.idle()
    assert new.field("indenter/radius").get_attribute("value") == "100 \u00b5m" and new.said == "Curves computed"
    new.tab("Models")
    new.driver.refresh()
    new.wait(lambda: new.all("#design-said"))
    new.wait(lambda: new.said == "Models computed", "the tab is kept")


def test_a_server_that_is_gone_or_another_is_an_error(driver):
    page = Page(driver, text_of("sio2_on_si"))
    page.idle()

    def alert_after(value):
        Keyboard(page).send(Keys.ESCAPE)
        page.wait(lambda: not page.alert, "no message")
        page.field("compute/max_depth").send_keys(Keys.CONTROL + "a")
        page.field("compute/max_depth").send_keys(value, Keys.TAB)
        return page.wait(lambda: page.alert, "an error")

    words = "mdrcontact app no longer answers. Start it again and open the address that it prints."
    page.close()
    assert alert_after("40 nm") == words
    with contextlib.closing(Session()) as other:
        server = listen(make_app(other), page.server.port)
        threading.Thread(target=server.serve_forever, daemon=True).start()
        assert alert_after("50 nm") == words
        server.shutdown()
        server.server_close()
    driver.get("about:blank")
    assert driver.get_log("browser") and driver.get_log("performance")  # of no other test


def test_files_of_no_use_are_errors_and_the_next_one_is_read(open_page, tmp_path):
    page = open_page()
    page.tab("Measure")
    wrong = {"picture.png": bytes(range(256)), "empty.csv": b"", "words.txt": b"hello\nthere\n", "bad.toml": b"[indenter\n"}
    for name, content in wrong.items():
        (tmp_path / name).write_bytes(content)
        before = page.alert
        page.give("drop", tmp_path / name)
        page.wait(lambda before=before: page.alert not in ("", before), name)
        assert not page.text and ("not valid TOML" if name == "bad.toml" else name) in page.alert
    page.give("drop", FITS / "sphere_on_oxide.csv")
    page.wait(lambda: page.text and not page.alert, "a file is read")
    page.idle()


def test_the_same_file_can_be_opened_again(open_page):
    page = open_page()
    for _ in range(2):
        page.give("open", PROBLEMS / "tin_on_steel.toml")
        page.wait(lambda: page.text == text_of("tin_on_steel"), "the file")
        page.wait(lambda: page.field("compute/max_depth").get_attribute("value") == "50 nm", "its form")
        page.type("compute/max_depth", "33 nm")
        page.wait(lambda: "33 nm" in page.text, "the change")


def test_a_fit_has_what_is_typed_right_before_the_click(open_page):
    page = open_page()
    page.tab("Measure")
    page.drop(FITS / "sphere_on_oxide.csv", FITS / "sphere_on_oxide.toml")
    field = page.field("medium/substrate/E")
    field.send_keys(Keys.CONTROL + "a")
    field.send_keys("150 GPa")
    page.fit()
    assert "150 GPa" in page.text and page.session.jobs.latest.key[1].count("150 GPa") == 1
    assert not page.one("results").get_attribute("class")


def test_a_reload_while_it_computes_continues(open_page, monkeypatch):
    go, begun = threading.Event(), []

    def stress(problem, progress, **options):
        begun.append(problem)
        go.wait(60)
        return studies.stress(problem, progress=progress, **options)

    monkeypatch.setitem(design.STUDIES, "Stress", design.STUDIES["Stress"]._replace(study=stress))
    page = open_page()
    page.idle()
    page.driver.find_element(By.XPATH, "//label[text()='Stress']").click()
    page.wait(lambda: page.one("busy").is_displayed())
    page.driver.refresh()
    page.wait(lambda: page.all("#design-busy") and page.one("busy").is_displayed())
    go.set()
    page.wait(lambda: page.said == "Stress computed")
    page.idle()
    assert len(begun) == 1 and page.numbers()


def test_a_dark_system_has_legible_figures(open_page, driver):
    """Chromium would turn the page dark, but not the axes of figures."""
    page = open_page()
    page.idle()
    pictures = []
    for dark in (True, False):
        features = [{"name": "prefers-color-scheme", "value": "dark" if dark else ""}]
        driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": features})
        driver.execute_cdp_cmd("Emulation.setAutoDarkModeOverride", {"enabled": dark})
        pictures.append(Image.open(io.BytesIO(driver.get_screenshot_as_png())).convert("L"))
    assert np.median(np.asarray(pictures[0])) > 230


def test_a_problem_file_is_opened_and_the_first_change_is_undone(open_page):
    first, other = text_of("sio2_on_si"), text_of("tin_on_steel")
    page = open_page(first)
    page.idle()
    page.driver.find_element(By.CSS_SELECTOR, "#design-open input").send_keys(str(PROBLEMS / "tin_on_steel.toml"))
    page.wait(lambda: page.text == other, "a file is opened")
    page.idle()
    expected = studies.curve(problem.read_text(other), pressures=True, references=True)
    assert page.numbers() == {name: with_micro(str(number)) for name, number in expected.numbers.items()}
    page.driver.find_element(By.ID, "undo").click()
    page.wait(lambda: page.text == first, "the file is undone")
    page.idle()


def test_a_dropped_table_to_a_modulus_within_its_interval(open_page, tmp_path):
    page = open_page()
    page.tab("Measure")
    page.drop(FITS / "sphere_on_oxide.csv")
    assert not page.alert and "Not in the file" in page.one("results").text
    picture(page, "data")
    check_access(page.driver)
    page.type("indenter/radius", "10 um")
    page.choose("medium/type", "coated")
    assert "no number of this problem" in page.one("sought").text
    for path, value in {
        "medium/coating/E": "60 GPa",
        "medium/coating/nu": "0.17",
        "medium/coating/thickness": "500 nm",
        "medium/substrate/E": "163 GPa",
        "medium/substrate/nu": "0.22",
    }.items():
        page.type(path, value)
    for fold in page.all("details"):
        page.driver.execute_script("arguments[0].open = true", fold)
    page.type("data/relative_sd", "0.01")
    page.type("data/min_depth", "3 nm")
    for name in ("E", "coating.E", "thickness"):
        for box in page.driver.find_elements(By.XPATH, f"//*[@id='{page.dom_id(f'#free/{name}')}']"):
            if box.is_selected() != (name != "E"):
                box.click()
                page.idle()
    page.type("#prior/thickness", "10 nm")
    page.fit()
    rows = {row[0]: row for row in page.rows()}
    low, high = (float(end) for end in rows["film modulus E"][2].removesuffix(" GPa").split(" to "))
    assert low < 72.0 < high and high - low < 6.0
    assert rows["film thickness h"][1].endswith("nm") and "describes the data" in page.all(".verdict")[0].text
    picture(page, "fit")
    # the same file by the command
    path = tmp_path / "problem.toml"
    path.write_text(page.text, encoding="utf-8")
    assert rows["film modulus E"][1] in command_line("fit", FITS / "sphere_on_oxide.csv", "--problem", path)


def made_curves(folder):
    """24 files of a sphere on a film of 72 GPa, of which one is broken and one is bad."""
    noise, depth = np.random.default_rng(3), np.linspace(2e-9, 100e-9, 80)
    film = mdr.Coated(mdr.Elastic(72e9, 0.17), 500e-9, mdr.Elastic(163e9, 0.22))
    force = np.asarray(mdr.Contact(mdr.Sphere(10e-6), film).at_depth(depth).force)
    for i in range(24):
        measured = force * (1.0 + 0.01 * noise.standard_normal(80)) * (1.0 + 0.6 * np.sin(depth / 4e-9) if i == 7 else 1.0)
        rows = [f"{d * 1e9:.4f},{f * 1e3:.6f}" for d, f in zip(depth, measured, strict=True)]
        words = ["this file is broken"] if i == 15 else rows
        (folder / f"test_{i + 1:02d}.csv").write_text("\n".join(["depth [nm],load [mN]", *words]), encoding="utf-8")
    return sorted(folder.iterdir())


def test_many_curves_of_which_one_is_broken_and_one_bad(open_page, tmp_path):
    page = open_page()
    page.tab("Measure")
    page.drop(*made_curves(tmp_path), FITS / "sphere_on_oxide.toml")
    page.one("start").click()
    page.wait(lambda: page.all("#many-grid .ag-row"))
    page.idle()
    words = page.one("results").text
    assert "23 of 24 curves fitted" in words and "1 curve is left out of the mean" in words and "test_08.csv: misses by" in words
    assert "test_16.csv: not fitted" in words and "there is no table of numbers in it" in words and str(tmp_path) not in words
    assert "mdrcontact-" not in words  # no folder of the page
    found = page.session.jobs.latest.result
    assert found.numbers["in the mean"].value == 22
    # in the order of the command, whatever the browser has read first
    assert [one.name for one in found.curves] == sorted(one.name for one in found.curves)
    mean = next(row for row in page.rows() if row[0].startswith("film modulus"))
    low, high = map(float, mean[2].split(" to "))
    assert low < 72.0 < high
    picture(page, "many")
    check_access(page.driver)
    # a row that is not ticked is left out, and can be ticked again
    row = next(one for one in page.all("#many-grid .ag-row") if "test_03.csv" in one.text)
    row.find_element(By.CSS_SELECTOR, "input[type=checkbox]").click()
    page.wait(lambda: "22 of 23 curves fitted" in page.one("results").text)
    page.idle()
    row = page.wait(lambda: [one for one in page.all("#many-grid .ag-row") if "test_02.csv" in one.text][0])
    row.find_elements(By.CSS_SELECTOR, ".ag-cell")[-1].click()
    page.wait(lambda: page.all("#many-one .panels"))
    assert "test_02.csv" in page.driver.find_element(By.ID, "many-one").text


def test_an_error_is_at_its_field_and_old_results_stay(open_page):
    page = open_page()
    page.idle()
    force = page.numbers()["force"]
    page.type("medium/coating/E", "-1 GPa")
    assert page.alert.startswith("[medium.coating]: E = '-1 GPa': ")
    assert page.field("medium/coating/E", "error").text and not page.field("medium/coating/nu", "error").text
    assert page.one("results").get_attribute("class") == "dimmed" and page.numbers()["force"] == force
    picture(page, "error")
    page.type("medium/coating/E", "80 GPa")
    assert not page.alert and not page.field("medium/coating/E", "error").text and page.numbers()["force"] != force
    page.type("indenter/radius", "ten")
    assert "ten" in page.alert and page.field("indenter/radius", "error").text
    page.tab("File")
    area = page.all("textarea")[0]
    area.send_keys(Keys.CONTROL + "a")
    area.send_keys("no toml", Keys.TAB)
    page.idle()
    page.tab("Curves")
    assert "it is not valid TOML" in page.alert


def test_too_large_a_drop_is_an_error(open_page, tmp_path):
    page = open_page()
    page.tab("Measure")
    for name in ("a.csv", "b.csv"):
        with (tmp_path / name).open("wb") as file:
            file.truncate(150_000_000)
    both = "\n".join(str(tmp_path / name) for name in ("a.csv", "b.csv"))
    page.driver.find_element(By.CSS_SELECTOR, "#measure-drop input").send_keys(both)
    page.wait(lambda: page.alert, "an error")
    assert page.alert == "files: together they have more than 290 MB. Drop fewer or smaller files." and not page.session.files
    # the page reads the next drop
    page.drop(FITS / "sphere_on_oxide.csv")
    assert not page.alert and [*page.session.files] == ["sphere_on_oxide.csv"]


def test_a_text_names_no_file_of_the_machine(open_page):
    page = open_page(edit.changed(text_of("tin_on_steel"), ("friction",), {"coefficient": 0.3, "path": "/etc/passwd"}))
    page.tab("Friction")
    assert "/etc/passwd" in page.alert and "root:x:" not in page.driver.page_source


@pytest.mark.parametrize("name", sorted(path.stem for path in PROBLEMS.glob("*.toml")))
def test_every_choice_shows_what_is_computed(open_page, name):
    page = open_page()
    page.example(name)
    chosen = {json.loads(one.get_attribute("id"))["set"]: one for one in page.all(".form select[id*='set']")}
    assert "indenter/shape" in chosen and len(chosen) > 2
    tables = problem.toml.parse_text(page.text)
    for path, select in chosen.items():
        shown, *inside = Select(select).first_selected_option.get_attribute("value"), *path.split("/")
        if inside[-1].startswith("#"):
            continue
        value, table = tables, schema.PROBLEM
        for step in inside[:-1]:
            value = value[int(step) if step.isdigit() else step]
            table = table if step.isdigit() else table.field(step).table
        expected = value.get(inside[-1], table.field(inside[-1]).default)
        assert shown == ("" if expected is None else str(expected).lower() if isinstance(expected, bool) else expected), path


def test_a_reload_keeps_text_files_tab_and_result(open_page):
    page = open_page()
    page.type("compute/max_depth", "40 nm")
    page.tab("Models")
    page.tab("Measure")
    page.drop(FITS / "sphere_on_oxide.csv", FITS / "sphere_on_oxide.toml")
    page.fit()
    before = page.rows()
    page.driver.refresh()
    page.wait(lambda: page.all("#measure-results .verdict"))
    page.idle()
    assert page.rows() == before and page.field("medium/coating/E").get_attribute("value") == "60 GPa"
    page.tab("Design")
    assert page.field("compute/max_depth").get_attribute("value") == "40 nm" and page.numbers()["spread"]


def test_a_narrow_window(open_page, driver):
    resize(driver, 400, 900)
    page = open_page()
    page.idle()
    wide = "return document.documentElement.scrollWidth"
    for width in (680, 320, 400):  # 1360 pixels at 200 %, and the narrowest of WCAG 2.2 (1.4.10)
        resize(driver, width, 900)
        for tab in ("Curves", "Models", "File"):
            page.tab(tab)
            assert driver.execute_script(wide) <= width
    page.tab("Curves")
    picture(page, "narrow")
    driver.execute_script("arguments[0].scrollIntoView()", page.one("results"))
    picture(page, "narrow_results")
    page.tab("Measure")
    page.drop(FITS / "sphere_on_oxide.csv", FITS / "sphere_on_oxide.toml")
    page.fit()
    assert driver.execute_script(wide) <= 400


VIEWS = {
    "design": lambda page: page.example("tin_on_steel"),
    "models": lambda page: (page.example("sio2_on_si"), page.tab("Models")),
    "stress": lambda page: (page.example("tin_on_steel"), page.tab("Stress")),
    "adhesion": lambda page: (page.example("afm_on_pdms"), page.tab("Adhesion")),
    "friction": lambda page: (page.example("tin_on_steel"), page.tab("Friction")),
    "wear": lambda page: (page.example("tin_on_steel"), page.tab("Wear")),
    "imprint": lambda page: (page.example("aluminium_on_silicon"), page.tab("Imprint")),
    "time": lambda page: (page.example("creep_of_coating"), page.tab("Time")),
    "heat": lambda page: (page.example("heat_through_silica"), page.tab("Heat")),
    "file": lambda page: page.tab("File"),
    "error": lambda page: page.type("indenter/radius", "-1 um"),
    "measure": lambda page: page.tab("Measure"),
    "unloading": lambda page: (
        page.tab("Measure"),
        page.drop(FITS / "indent_on_oxide.txt", FITS / "indent_on_oxide.toml"),
        page.fit(),
    ),
    "gel": lambda page: (page.tab("Measure"), page.drop(FITS / "gel_in_time.csv", FITS / "gel_in_time.toml"), page.fit()),
}


@pytest.mark.parametrize("name", VIEWS)
def test_everyone_can_use_it(open_page, driver, name):
    """No violation of the rules of axe."""
    page = open_page()
    VIEWS[name](page)
    picture(page, f"view_{name}")
    check_access(driver)


@pytest.fixture
def endless_stress(monkeypatch):
    """Let the first computation of stresses end by a cancel only: a fast machine is ready before the click."""
    begun = []

    def stress(problem, progress, **options):
        begun.append(problem)
        while len(begun) == 1:
            progress.step(1, 2, "states")
            time.sleep(0.01)
        return studies.stress(problem, progress=progress, **options)

    monkeypatch.setitem(design.STUDIES, "Stress", design.STUDIES["Stress"]._replace(study=stress))


@pytest.mark.usefixtures("endless_stress")
def test_long_work_is_cancelled(open_page):
    page = open_page(text_of("tin_on_steel"))
    page.idle()
    page.driver.find_element(By.XPATH, "//label[text()='Stress']").click()
    page.wait(lambda: page.one("busy").is_displayed() and page.one("progress").text)
    page.one("cancel").click()
    page.wait(lambda: page.alert == "The work was cancelled.")
    page.idle()
    assert page.alert and not page.session.jobs.latest.is_alive() and not page.one("busy").is_displayed()
    page.tab("Curves")
    page.tab("Stress")
    assert page.said == "Stress computed" and not page.alert


@pytest.mark.usefixtures("endless_stress")
def test_work_of_the_other_tab_ends_the_work_before(open_page):
    page = open_page(text_of("tin_on_steel"))
    page.tab("Measure")
    page.drop(FITS / "sphere_on_oxide.csv", FITS / "sphere_on_oxide.toml")
    page.tab("Design")
    page.driver.find_element(By.XPATH, "//label[text()='Stress']").click()
    page.wait(lambda: page.one("busy").is_displayed())
    page.driver.find_element(By.XPATH, "//label[text()='Measure']").click()
    page.page = "measure"
    page.fit()
    assert not page.alert and page.rows()
    page.page = "design"
    page.wait(lambda: not page.one("busy").is_displayed())
    assert page.one("alert").get_attribute("textContent") in ("The work was cancelled.", "")


TABS = {"compare": "Models", "curve": "Curves", "stress": "Stress", "adhesion": "Adhesion", "friction": "Friction", "wear": "Wear"}
TABS |= {"history": "Time", "conduction": "Heat", "imprint": "Imprint"}
with (ROOT / "tests" / "data" / "examples.csv").open(encoding="utf-8") as file:
    PINNED = list(csv.DictReader(line for line in file if not line.startswith("#")))
DESIGNS = sorted({row["problem"] for row in PINNED if row["command"] in TABS})
MEASURED = sorted({row["problem"] for row in PINNED} - {*DESIGNS})


def numbers_pinned(name, command):
    return {row["name"]: float(row["value"]) for row in PINNED if (row["problem"], row["command"]) == (name, command)}


@pytest.mark.parametrize("name", DESIGNS)
def test_the_page_has_the_numbers_of_the_commands(open_page, name, tmp_path):
    page = open_page()
    page.example(name)
    for command in sorted({row["command"] for row in PINNED if row["problem"] == name}):
        page.tab(TABS[command])
        assert not page.alert, (command, page.alert)
        shown, pinned = page.numbers(), numbers_pinned(name, command)
        assert shown.keys() == pinned.keys()
        found = page.session.jobs.find(("design", TABS[command], page.text))
        for key, value in pinned.items():
            assert found.numbers[key].value == pytest.approx(value, rel=1e-9, abs=1e-300), (command, key)
            assert shown[key] == with_micro(str(found.numbers[key]))
        # every table of the command is that of the page
        path = tmp_path / f"{command}.csv"
        if command != "compare":
            command_line(command, PROBLEMS / f"{name}.toml", "--csv", path)
            assert path.read_bytes() in [mdr.cli.table.as_csv(table) for table in found.tables.values()]


@pytest.mark.parametrize("name", MEASURED)
def test_the_page_has_the_estimates_of_the_command(open_page, name, tmp_path):
    data = next(path for path in FITS.iterdir() if path.stem == name and path.suffix in (".csv", ".txt"))
    page = open_page()
    page.tab("Measure")
    page.drop(data, FITS / f"{name}.toml")
    assert page.text == (FITS / f"{name}.toml").read_text(encoding="utf-8")
    page.fit()
    assert not page.alert
    found = page.session.jobs.latest.result[0]
    for key, value in numbers_pinned(name, "fit").items():
        assert found.numbers[key].value == pytest.approx(value, rel=1e-6), key
    command_line("fit", data, "--problem", FITS / f"{name}.toml", "--json", tmp_path / "fit.json")
    told = json.loads((tmp_path / "fit.json").read_text(encoding="utf-8"))
    told.pop("file", None)
    assert told == json.loads(json.dumps(found.to_dict()))


@pytest.mark.parametrize("seed", [1, 2])
def test_the_order_of_clicks_changes_nothing(open_page, seed):
    page, order = open_page(), random.Random(seed)
    page.example("tin_on_steel")
    names = ["Curves", "Models", "Stress", "Friction", "Wear"]
    expected = {}
    for name in names:
        page.tab(name)
        expected[name] = page.numbers()
    text = page.text
    for _ in range(4):
        name = order.choice(names)
        page.tab(name)
        page.type("compute/max_depth", "30 nm")
        assert page.numbers() != expected[name]
        page.tab(order.choice(names))
        page.type("compute/max_depth", "50 nm")
        page.tab(name)
        assert page.numbers() == expected[name] and page.text == text


def test_a_range_is_dragged_across_a_curve(open_page):
    page = open_page()
    page.tab("Measure")
    page.drop(FITS / "sphere_on_oxide.csv")
    plot = page.wait(lambda: page.all("#measure-results .nsewdrag")[0])
    start = ActionChains(page.driver).move_to_element_with_offset(plot, -60, 0).click_and_hold()
    start.move_by_offset(60, 5).move_by_offset(60, 5).release().perform()
    page.wait(lambda: "min_depth" in page.text)
    page.idle()
    low, high = (parse(edit.value(page.text, ("data", key)), mdr._units.LENGTH) for key in ("min_depth", "max_depth"))
    assert 10e-9 < low < 50e-9 < high < 90e-9
    assert page.field("data/min_depth").get_attribute("value") == edit.value(page.text, ("data", "min_depth"))


def test_fields_of_a_fit_show_the_file(open_page):
    page = open_page()
    page.tab("Measure")
    page.drop(FITS / "csm_on_oxide.csv", FITS / "csm_on_oxide.toml")
    tables = problem.toml.parse_text(page.text)
    assert page.field("data/kind").get_attribute("value") == tables["data"]["kind"]
    free = tables["fit"]["free"]
    boxes = page.all(".form input[type=checkbox][id*='#free']")
    assert {json.loads(one.get_attribute("id"))["set"].removeprefix("#free/") for one in boxes if one.is_selected()} == {*free}
    assert measured.FIT.field("data")
