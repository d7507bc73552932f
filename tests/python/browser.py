# SPDX-License-Identifier: GPL-3.0-or-later
"""The page of `mdrcontact app` in Debian's Chromium, for tests. Chromium finds no other machine than this one."""

from __future__ import annotations

import json
import os
import shutil
import threading
import time

from selenium import webdriver
from selenium.common.exceptions import StaleElementReferenceException
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import Select

from mdrcontact.app import Session, make_app
from mdrcontact.app.server import listen

CHROMIUM, DRIVER = shutil.which("chromium"), shutil.which("chromedriver")
_PATIENCE = 150.0
_SPY = """performance.setResourceTimingBufferSize(100000); window.errors = []; const own = console.error;
console.error = (...words) => { window.errors.push(words.map(one => one && one.message || String(one)).join(" ")); own(...words); };
window.addEventListener("error", one => window.errors.push(String(one.message)));"""


def chromium(width: int = 1360, height: int = 1000):
    options = webdriver.ChromeOptions()
    options.binary_location = CHROMIUM
    sealed = "--host-resolver-rules=MAP * ~NOTFOUND , EXCLUDE 127.0.0.1"
    for one in ("--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--hide-scrollbars", sealed):
        options.add_argument(one)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    driver = webdriver.Chrome(options=options, service=Service(DRIVER))
    driver.execute_cdp_cmd("Page.addScriptToEvaluateOnNewDocument", {"source": _SPY})
    resize(driver, width, height)
    return driver


def resize(driver, width, height):
    metrics = {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False}
    driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", metrics)


class Page:
    """A page with a server of its own, driven as a user does. page : "design" or "measure" """

    def __init__(self, driver, text="", files=None, port=0):
        self.driver, self.session, self.page = driver, Session(text, files), "design"
        self.server = listen(make_app(self.session), port)
        threading.Thread(target=self.server.serve_forever, daemon=True).start()
        self.base = f"http://{self.server.host}:{self.server.port}/"
        driver.get(self.base + self.session.secret)
        self.wait(lambda: self.all(".form fieldset, .drop"))

    def close(self):
        self.server.shutdown()
        self.server.server_close()
        self.session.close()

    def wait(self, truth, what=""):
        """Wait until something is true, and return it."""
        end = time.monotonic() + _PATIENCE
        while time.monotonic() < end:
            try:
                if found := truth():
                    return found
            except (StaleElementReferenceException, IndexError):
                pass
            time.sleep(0.05)
        if folder := os.environ.get("MDRCONTACT_PICTURES"):
            self.driver.save_screenshot(os.path.join(folder, "failed.png"))
        raise AssertionError(f"{what or truth}: {self.alert!r}, {self.driver.execute_script('return window.errors')}")

    def all(self, selector):
        return self.driver.find_elements(By.CSS_SELECTOR, selector)

    def one(self, name):
        return self.driver.find_element(By.ID, f"{self.page}-{name}")

    @property
    def alert(self):
        return self.one("alert").text

    @property
    def said(self):
        return self.one("said").get_attribute("textContent")

    @property
    def text(self):
        """The text of the problem file, as the browser keeps it."""
        kept = self.driver.execute_script(f"return sessionStorage.getItem('{self.page}')")
        return json.loads(kept)["text"] if kept else ""

    def dom_id(self, path, what="set"):
        return json.dumps({"form": self.page, what: path}, sort_keys=True, separators=(",", ":"))

    def field(self, path, what="set"):
        return self.wait(lambda: self.driver.find_elements(By.XPATH, f"//*[@id='{self.dom_id(path, what)}']")[0], path)

    def idle(self):
        """Wait until nothing is computed or drawn."""
        quiet = "return !document.querySelector('[data-dash-is-loading=\"true\"]') && document.title !== 'Updating'"
        since = None
        for _ in range(int(_PATIENCE / 0.05)):
            busy = not self.driver.execute_script(quiet) or self.one("busy").is_displayed() or self.pending()
            since = None if busy else since or time.monotonic()
            if since and time.monotonic() - since > 0.3:
                return
            time.sleep(0.05)
        raise AssertionError("the page does not come to rest")

    def pending(self):
        """Whether the server works on a request of the page."""
        return self.driver.execute_script(
            "return performance.getEntriesByType('resource').length !== (window.seen || 0) "
            "&& ((window.seen = performance.getEntriesByType('resource').length), true)"
        )

    def type(self, path, value):
        """Type a value into a field, and leave it."""
        field = self.field(path)
        field.send_keys(Keys.CONTROL + "a")
        field.send_keys(value, Keys.TAB)
        self.idle()

    def choose(self, path, word):
        Select(self.field(path)).select_by_value(word)
        self.idle()

    def press(self, path):
        self.driver.execute_script("arguments[0].scrollIntoView({block: 'center'})", self.field(path, "act"))
        self.field(path, "act").click()
        self.idle()

    def tab(self, name):
        """Choose a tab by its name."""
        label = self.driver.find_element(By.XPATH, f"//nav[contains(@class, 'tabs')]//label[text()='{name}']")
        label.click()
        if name in ("Design", "Measure"):
            self.page = name.lower()
        self.idle()

    def example(self, name):
        Select(self.one("example")).select_by_value(name)
        self.idle()

    def give(self, name, *paths):
        """Choose files, as after a click, which forgets those chosen before."""
        place = self.driver.find_element(By.CSS_SELECTOR, f"#{self.page}-{name} input")
        self.driver.execute_script("arguments[0].value = null", place)
        place.send_keys("\n".join(map(str, paths)))

    def drop(self, *paths):
        self.give("drop", *paths)
        self.wait(lambda: self.text, "a file is read")
        self.idle()

    def fit(self):
        self.one("start").click()
        self.wait(lambda: self.said == "fit computed" or self.alert, "a fit")
        self.idle()

    def numbers(self):
        """The numbers on top of the results."""
        names, values = (self.all(f"#{self.page}-results .numbers {tag}") for tag in ("dt", "dd"))
        return dict(zip((one.text for one in names), (one.text for one in values), strict=True))

    def rows(self, selector="table"):
        """The cells of the first table of the results."""
        found = self.all(f"#{self.page}-results {selector}")[0].find_elements(By.TAG_NAME, "tr")
        return [[cell.text for cell in row.find_elements(By.CSS_SELECTOR, "th, td")] for row in found]

    def errors(self):
        """What the console of the page has."""
        severe = [one["message"] for one in self.driver.get_log("browser") if one["level"] == "SEVERE"]
        return [*severe, *self.driver.execute_script("return window.errors")]

    def hosts(self):
        """Other machines that the page asked."""
        sent = [json.loads(one["message"])["message"] for one in self.driver.get_log("performance")]
        urls = [one["params"]["request"]["url"] for one in sent if one["method"] == "Network.requestWillBeSent"]
        return [url for url in urls if not url.startswith((self.base, "data:", "blob:", "chrome:"))]
