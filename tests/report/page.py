#!/usr/bin/env python3
"""Opens a report in headless Chromium and uses it: hovers over points, moves the divide between two pictures, chooses
filters, saves tables. Fails where the page does not follow, or where the browser logs an error.

usage: page.py [--screenshot FILE.png] [--size WIDTHxHEIGHT] REPORT.html
--screenshot keeps the top of the page as a picture. docs/images/report.png was made so from a report of everything.
The exit code is 77 where Chromium or chromedriver is not installed. The script speaks the WebDriver protocol itself, so
that it needs nothing but Debian's packages chromium and chromium-driver.
"""
import argparse
import base64
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time
import urllib.error
import urllib.request

SKIPPED = 77


class Driver:
    """A browser that chromedriver steers. chromedriver chooses its port and prints it."""

    def __init__(self, folder):
        self.process = subprocess.Popen(
            ["chromedriver", "--port=0"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        for line in self.process.stdout:
            if "was started successfully on port" in line:
                self.url = "http://127.0.0.1:" + line.rsplit(" ", 1)[1].strip().rstrip(".")
                break
        arguments = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
                     "--window-size=1100,900", "--user-data-dir=" + folder]
        capabilities = {"browserName": "chrome", "goog:loggingPrefs": {"browser": "ALL"},
                        "goog:chromeOptions": {"args": arguments, "binary": shutil.which("chromium")}}
        self.session = ""
        self.session = "/session/" + self.call("POST", "/session", {
            "capabilities": {"alwaysMatch": capabilities}})["sessionId"]

    def call(self, method, path, body=None):
        data = None if body is None else json.dumps(body).encode()
        request = urllib.request.Request(self.url + self.session + path, data, {"Content-Type": "application/json"},
                                         method=method)
        try:
            with urllib.request.urlopen(request, timeout=120) as answer:
                return json.load(answer)["value"]
        except urllib.error.HTTPError as error:
            raise SystemExit(f"{path}: {error.read().decode()[:2000]}")

    def run(self, script):
        return self.call("POST", "/execute/sync", {"script": script, "args": []})

    def mouse(self, *steps):
        """Moves the mouse. A step is a point of the window to move to, or "down" or "up" for the button."""
        actions = []
        for step in steps:
            if step in ("down", "up"):
                actions.append({"type": "pointerDown" if step == "down" else "pointerUp", "button": 0})
            else:
                actions.append({"type": "pointerMove", "duration": 50, "x": round(step[0]), "y": round(step[1])})
        self.call("POST", "/actions", {"actions": [
            {"type": "pointer", "id": "mouse", "parameters": {"pointerType": "mouse"}, "actions": actions}]})

    def screenshot(self, path, width, height):
        self.run("window.scrollTo(0, 0); document.documentElement.style.overflow = 'hidden'")
        self.mouse([1, 1])
        self.call("POST", "/window/rect", {"width": width, "height": height})
        # The browser's own frame takes part of the window, so the window is made larger by that much.
        inner = self.run("return [window.innerWidth, window.innerHeight]")
        self.call("POST", "/window/rect", {"width": 2 * width - inner[0], "height": 2 * height - inner[1]})
        time.sleep(0.5)  # the charts need a moment to take the new width
        pathlib.Path(path).write_bytes(base64.b64decode(self.call("GET", "/screenshot")))

    def close(self):
        if self.session:
            self.call("DELETE", "")
        self.process.terminate()
        self.process.wait()


def check(good, what):
    """Prints what was checked, and ends the script where it is not so."""
    print(("ok      " if good else "FAILED  ") + what)
    if not good:
        raise SystemExit(1)


def wait_for(driver, script):
    for _ in range(100):
        if driver.run(script):
            return True
        time.sleep(0.1)
    return False


def hover(driver, chart):
    """Moves the mouse over the first point of a chart and returns the text of the tooltip that appears."""
    point = driver.run(f"""
        const chart = wrinkleReport.charts.{chart};
        chart.canvas.scrollIntoView({{block: 'center', behavior: 'instant'}});
        const set = chart.data.datasets.findIndex(d => d.data.length > 0);
        const at = chart.getDatasetMeta(set).data[0].getCenterPoint(), box = chart.canvas.getBoundingClientRect();
        return [box.left + at.x, box.top + at.y];""")
    driver.mouse([point[0] - 40, point[1] - 40], point)
    return driver.run(f"""
        const tooltip = wrinkleReport.charts.{chart}.tooltip;
        return tooltip.opacity > 0 ? tooltip.body.flatMap(b => b.lines).join(' ') : '';""")


# A number that changes with the picture on the page.
PICTURE_HASH = """
    const canvas = document.getElementById('picture-canvas');
    const data = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
    let hash = 0;
    for (let i = 0; i < data.length; i += 4) hash = (hash * 31 + data[i]) | 0;
    return hash;"""


def drag_divide(driver, share):
    """Drags the divide to a share of its length and returns the value that the slider has then."""
    box = driver.run("""
        const slider = document.getElementById('picture-split');
        slider.scrollIntoView({block: 'center', behavior: 'instant'});
        const box = slider.getBoundingClientRect();
        return [box.left, box.top + box.height / 2, box.width, slider.value / 100];""")
    inset = 8  # half of the handle
    x = lambda s: box[0] + inset + s * (box[2] - 2 * inset)
    driver.mouse([x(box[3]), box[1]], "down", [x(share), box[1]], "up")
    return float(driver.run("return document.getElementById('picture-split').value"))


def choose(driver, select, value):
    driver.run(f"""
        const select = document.getElementById({json.dumps(select)});
        select.value = {json.dumps(value)};
        select.dispatchEvent(new Event('input'));""")


TABLE_ROWS = "return document.querySelectorAll('#trade-table tbody tr').length"


def look_at_filters(driver):
    """Every value of every filter shows the runs that have it, and no others."""
    filters = driver.run("""
        return [...document.querySelectorAll('#trade-filters select')].map(s => [s.id, [...s.options].map(o => [
            o.value, wrinkleReport.runs.filter(c => o.value === 'all' || c.choices[s.dataset.key] === o.value).length])]);""")
    check({"trade-datapath", "trade-normalizer_n"} <= {name for name, _ in filters}, "the page filters by datapath and by normalizer")
    for name, values in filters:
        check(len(values) > 1 and all(count > 0 for _, count in values),
              f"filter {name} offers only values that a run has: {', '.join(v for v, _ in values)}")
        for value, count in values:
            choose(driver, name, value)
            if driver.run(TABLE_ROWS) != count:
                check(False, f"filter {name} = {value} shows the {count} runs that have this value")
        choose(driver, name, "all")
    points = "return wrinkleReport.charts.trade.data.datasets.reduce((n, d) => n + d.data.length, 0)"
    all_points = driver.run(points)
    if all_points > 0:
        values = [value for value, _ in dict(filters)["trade-datapath"] if value != "all"]
        each = []
        for value in values:
            choose(driver, "trade-datapath", value)
            each.append(driver.run(points))
        choose(driver, "trade-datapath", "all")
        check(sum(each) == all_points and driver.run(points) == all_points,
              f"the chart shows the points of one datapath at a time: {dict(zip(values, each))}")


COLUMN_ROWS = """
    return [...document.querySelectorAll('#picture-columns tbody tr')].map(tr => [...tr.cells].map(td => td.textContent))"""


def look_at_columns(driver):
    """Under the pointer the page shows the colours of both pictures, and the values that they were made of."""
    names = driver.run("return [...document.getElementById('picture-a').options].map(o => o.value)")
    golden = next(name for name in names if name.endswith(", golden"))
    exact = golden.removesuffix("golden") + "exact"
    choose(driver, "picture-a", golden)
    choose(driver, "picture-b", exact)
    at = driver.run("""
        const canvas = document.getElementById('picture-canvas');
        canvas.scrollIntoView({block: 'center', behavior: 'instant'});
        const box = canvas.getBoundingClientRect();
        return [box.left + box.width / 2, box.top + box.height / 2];""")
    driver.mouse([at[0] - 5, at[1]], at)
    check(wait_for(driver, COLUMN_ROWS + ".length > 6"), "the pixel under the pointer shows its values")
    rows = {row[0]: row[1:] for row in driver.run(COLUMN_ROWS)}
    check({"red", "N.x", "N.z", "L.x", "NL", "diffuse"} <= set(rows), f"these values are shown: {', '.join(rows)}")
    length = sum(float(rows["N." + axis][0]) ** 2 for axis in "xyz") ** 0.5
    check(abs(length - 1) < 0.01, f"N of {golden} has the length {length:.4f}")
    cosine = sum(float(rows["N." + axis][1]) * float(rows["L." + axis][1]) for axis in "xyz")
    check(abs(max(cosine, 0) - float(rows["NL"][1])) < 0.001, f"N.L of {exact} is {cosine:.4f}, and is shown as {rows['NL'][1]}")
    for name, (left, right, difference) in rows.items():
        check(abs(float(left) - float(right) - float(difference)) < 0.0002, f"{name}: {left} - {right} = {difference}")


def look_at_runs(driver):
    """Each run has its own chart of errors by stage, and of speeds where there are any."""
    for select, chart in (("budget-run", "budget"), ("speed-run", "speed")):
        runs = driver.run(f"return [...document.getElementById('{select}').options].map(o => o.value)")
        drawn = []
        for run in runs:
            choose(driver, select, run)
            drawn.append(str(driver.run(f"return wrinkleReport.charts.{chart}.data.datasets[0].data")))
        check(len(set(drawn)) == len(runs), f"the chart '{chart}' is another for each of the runs {runs}")


def look_at_narrow(driver):
    """On a telephone nothing is wider than the screen but tables, which scroll by themselves."""
    driver.call("POST", "/goog/cdp/execute", {"cmd": "Emulation.setDeviceMetricsOverride", "params": {
        "width": 390, "height": 800, "deviceScaleFactor": 1, "mobile": True}})
    driver.run("location.reload()")
    check(wait_for(driver, "return document.readyState === 'complete' && typeof wrinkleReport === 'object' && "
                           "document.getElementById('picture-text').textContent !== ''"), "the page opens at 390 pixels")
    width = driver.run("return [window.innerWidth, document.documentElement.scrollWidth]")
    check(width == [390, 390], f"the page is as wide as the screen: {width}")
    picture = driver.run("const box = document.getElementById('picture-canvas').getBoundingClientRect(); "
                         "return [box.width, box.height]")
    check(picture[0] <= 390 and abs(picture[0] - picture[1]) < 2, f"the picture scales, in its shape: {picture}")
    legends = driver.run("""
        return Object.entries(wrinkleReport.charts).filter(([, c]) => c.legend.options.display && c.data.datasets.length > 1 &&
            !c.canvas.closest('[hidden]')).map(([name, c]) => [name, c.legend.height, c.chartArea.height]);""")
    check(all(legend > 0 and area > 100 for _, legend, area in legends), f"charts keep their legends: {legends}")
    tables = driver.run("""
        return [...document.querySelectorAll('.wide table')].filter(t => t.offsetWidth > 0 &&
            t.parentElement.scrollWidth > t.parentElement.clientWidth).length;""")
    check(tables > 0, f"{tables} tables are wider than the screen and scroll by themselves")
    driver.call("POST", "/goog/cdp/execute", {"cmd": "Emulation.clearDeviceMetricsOverride", "params": {}})
    driver.run("location.reload()")
    wait_for(driver, "return document.readyState === 'complete' && document.getElementById('picture-text').textContent !== ''")


def look_at_paper(driver):
    """The section on the paper: Fig. 5, 6 and 7 in pairs, and the errors of the method."""
    pairs = driver.run("""
        return [...document.querySelectorAll('#pairs-table tbody tr')].slice(0, 3).map(
            tr => [...tr.cells].slice(0, 2).map(td => td.textContent));""")
    for name, decibels in pairs:
        check(20 < float(decibels) < 60, f"the table gives {name} as {decibels} dB")
    check(len(pairs) == 3, "the table has Fig. 5, 6 and 7 in three pairs")
    table = "return document.getElementById('tessellation-table').textContent"
    before = driver.run(table)
    other = driver.run("const s = document.getElementById('tessellation-filtering'); "
                       "return [...s.options].map(o => o.value).find(v => v !== s.value)")
    choose(driver, "tessellation-filtering", other)
    check(driver.run(table) != before, "the errors of the method change with the choice of filtering")


def look_at_downloads(driver):
    """Each link that saves the tables brings a text of its format."""
    for name, start in (("csv", "table,row,column,value"), ("markdown", "# Report"), ("json", "{")):
        text = driver.call("POST", "/execute/async", {"args": [], "script": f"""
            fetch(document.getElementById('save-{name}').href).then(r => r.text()).then(arguments[0]);"""})
        check(text.startswith(start) and len(text) > 200, f"the link saves {name}, {len(text)} characters")


def look(driver, page):
    """Uses every part of the page as a reader would."""
    driver.call("POST", "/url", {"url": pathlib.Path(page).resolve().as_uri()})
    check(wait_for(driver, "return typeof wrinkleReport === 'object' && Object.keys(wrinkleReport.charts).length >= 2"),
          "the page has drawn its charts")
    charts = driver.run("""
        return Object.entries(wrinkleReport.charts)
            .filter(([, chart]) => chart.data.datasets.some(d => d.data.length > 0)).map(([name]) => name);""")
    check(charts, f"these charts have points: {', '.join(charts)}")
    for chart in charts:
        text = hover(driver, chart)
        check(text != "", f"a point of the chart '{chart}' shows: {text}")

    check(wait_for(driver, "return document.getElementById('picture-text').textContent !== ''"), "the page shows pictures")
    before = driver.run(PICTURE_HASH)
    value = drag_divide(driver, 0.1)
    check(value < 30, f"the divide was dragged to {value:.0f} %")
    check(driver.run(PICTURE_HASH) != before, "the picture changes with the divide")
    divided = driver.run(PICTURE_HASH)
    driver.run("document.getElementById('picture-difference').click()")
    check(driver.run(PICTURE_HASH) != divided, "the difference of two pictures is a picture of its own")
    driver.run("document.getElementById('picture-difference').click()")

    choose(driver, "picture-zoom", "4")
    sizes = driver.run("const c = document.getElementById('picture-canvas'); "
                       "return [c.width, c.getBoundingClientRect().width]")
    check(sizes[1] == 4 * sizes[0], "zoom 4 shows each pixel four times as wide")
    choose(driver, "picture-zoom", "1")
    choose(driver, "picture-split", "50")

    look_at_columns(driver)
    look_at_runs(driver)
    look_at_filters(driver)
    if driver.run("return !document.getElementById('paper').hidden"):
        look_at_paper(driver)
    look_at_downloads(driver)
    look_at_narrow(driver)
    errors = [entry for entry in driver.call("POST", "/se/log", {"type": "browser"}) if entry["level"] == "SEVERE"]
    check(not errors, f"the browser logged no error {errors}")


def main():
    parser = argparse.ArgumentParser(description="opens a report in headless Chromium and checks that it works")
    parser.add_argument("report")
    parser.add_argument("--screenshot", metavar="FILE")
    parser.add_argument("--size", default="1160x1500", help="size of the screenshot, WIDTHxHEIGHT")
    arguments = parser.parse_args()
    if not shutil.which("chromium") or not shutil.which("chromedriver"):
        print("skipped: chromium or chromedriver is not installed")
        return SKIPPED
    with tempfile.TemporaryDirectory() as folder:
        driver = Driver(folder)
        try:
            look(driver, arguments.report)
            if arguments.screenshot:
                driver.screenshot(arguments.screenshot, *map(int, arguments.size.split("x")))
        finally:
            driver.close()
    return 0


sys.exit(main())
