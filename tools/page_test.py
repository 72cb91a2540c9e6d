#!/usr/bin/env python3
"""Uses the page in a real Chromium, as its users do, and says what it saw.

usage: page_test.py [--folder target/web/page] [--shots FOLDER] [--scenes native.txt] [names of checks]

Needs Chromium and its driver (Debian: chromium, chromium-driver), and nothing else.
`--scenes` holds the engine's hashes in the browser against those of this machine, as
`cargo run --release -p lole_stage --example scenes` prints them.
"""

import argparse
import base64
import functools
import http.server
import io
import json
import pathlib
import struct
import subprocess
import sys
import tempfile
import threading
import time
import urllib.error
import urllib.request
import zipfile
import zlib

SIZE = (1280, 800)
# Whoever serves the page, until a check ends it.
SERVER = None
KINDS = {".js": "text/javascript", ".wasm": "application/wasm", ".webmanifest": "application/manifest+json"}


class Served(http.server.SimpleHTTPRequestHandler):
    extensions_map = http.server.SimpleHTTPRequestHandler.extensions_map | KINDS

    def end_headers(self):
        self.send_header("Cross-Origin-Opener-Policy", "same-origin")
        self.send_header("Cross-Origin-Embedder-Policy", "require-corp")
        self.send_header("Cache-Control", "no-cache")
        super().end_headers()

    def log_message(self, *_):
        pass


class Browser:
    """A Chromium by way of WebDriver."""

    def __init__(self, downloads, language="ja"):
        self.port = free_port()
        self.driver = subprocess.Popen(["chromedriver", f"--port={self.port}", "--log-level=SEVERE"])
        self.base = f"http://127.0.0.1:{self.port}"
        wait(lambda: self.call("GET", "/status")["ready"], 20, "chromedriver")
        arguments = ["--headless=new", "--no-sandbox", "--disable-quic", "--no-first-run", "--disable-sync",
                     "--disable-background-networking", "--disable-component-update", "--hide-scrollbars",
                     "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
                     "--ignore-gpu-blocklist", f"--window-size={SIZE[0]},{SIZE[1]}", f"--lang={language}",
                     f"--accept-lang={language}"]
        options = {"args": arguments, "prefs": {"download.default_directory": str(downloads),
                                                "download.prompt_for_download": False,
                                                "intl.accept_languages": language}}
        wanted = {"browserName": "chrome", "goog:chromeOptions": options, "goog:loggingPrefs": {"browser": "ALL"}}
        session = self.call("POST", "/session", {"capabilities": {"alwaysMatch": wanted}})
        self.base += f"/session/{session['sessionId']}"
        self.call("POST", "/timeouts", {"script": 3600_000, "pageLoad": 300_000})
        self.devtools("Browser.setDownloadBehavior", behavior="allow", downloadPath=str(downloads))
        self.devtools("Emulation.setDeviceMetricsOverride", width=SIZE[0], height=SIZE[1], deviceScaleFactor=1,
                      mobile=False)

    def call(self, method, path, body=None):
        data = None if body is None else json.dumps(body).encode()
        request = urllib.request.Request(self.base + path, data, {"Content-Type": "application/json"}, method=method)
        try:
            with urllib.request.urlopen(request, timeout=3700) as answer:
                return json.load(answer)["value"]
        except urllib.error.HTTPError as error:
            raise SystemExit(f"{path}: {error.read().decode()[:400]}") from error
        except OSError:
            if path == "/status":
                return {"ready": False}
            raise

    def devtools(self, command, **parameters):
        return self.call("POST", "/goog/cdp/execute", {"cmd": command, "params": parameters})

    def open(self, address):
        self.call("POST", "/url", {"url": address})

    def run(self, script):
        return self.call("POST", "/execute/sync", {"script": script, "args": []})

    def noted(self, what):
        return self.run(f"return document.documentElement.getAttribute('data-{what}')")

    def reached(self, what, seconds):
        """When the page came to `what` [ms]; ends at once where it says that it cannot be opened."""
        def look():
            if wrong := self.noted("failed"):
                raise SystemExit(f"the page says that it failed: {wrong}")
            return self.noted(what)
        return wait(look, seconds, f"the page was not {what}")

    def click(self, x, y):
        self.drag([(x, y)])

    def drag(self, places):
        """Presses at the first place, goes to the others, lets go."""
        move = lambda x, y, ms: {"type": "pointerMove", "x": round(x), "y": round(y), "duration": ms}
        actions = [move(*places[0], 0), {"type": "pause", "duration": 150}, {"type": "pointerDown", "button": 0},
                   {"type": "pause", "duration": 100}]
        actions += [move(x, y, 200) for x, y in places[1:]]
        actions += [{"type": "pause", "duration": 100}, {"type": "pointerUp", "button": 0}]
        source = {"type": "pointer", "id": "mouse", "parameters": {"pointerType": "mouse"}, "actions": actions}
        self.call("POST", "/actions", {"actions": [source]})

    def keys(self, text):
        actions = []
        for letter in text:
            actions += [{"type": "keyDown", "value": letter}, {"type": "keyUp", "value": letter}]
        self.call("POST", "/actions", {"actions": [{"type": "key", "id": "keys", "actions": actions}]})

    def shot(self, path):
        picture = base64.b64decode(self.call("GET", "/screenshot"))
        pathlib.Path(path).write_bytes(picture)
        return picture

    def errors(self):
        log = self.call("POST", "/se/log", {"type": "browser"})
        return [line["message"] for line in log if line["level"] == "SEVERE"]

    def close(self):
        try:
            self.call("DELETE", "")
        finally:
            self.driver.terminate()
            self.driver.wait()


def free_port():
    import socket

    with socket.socket() as asked:
        asked.bind(("127.0.0.1", 0))
        return asked.getsockname()[1]


def wait(is_done, seconds, what):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        if found := is_done():
            return found
        time.sleep(0.2)
    raise SystemExit(f"{what}: not after {seconds} s")


def main():
    words = argparse.ArgumentParser()
    words.add_argument("--folder", default="target/web/page")
    words.add_argument("--shots", default=tempfile.mkdtemp(prefix="lole-page-"))
    words.add_argument("--scenes")
    words.add_argument("checks", nargs="*")
    asked = words.parse_args()
    shots = pathlib.Path(asked.shots)
    shots.mkdir(parents=True, exist_ok=True)
    serve = functools.partial(Served, directory=asked.folder)
    global SERVER
    SERVER = server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), serve)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    address = f"http://127.0.0.1:{server.server_port}/"
    downloads = pathlib.Path(tempfile.mkdtemp(prefix="lole-downloads-"))
    checks = {name: check for name, check in CHECKS.items() if not asked.checks or name in asked.checks}
    browser, failed = Browser(downloads), False
    try:
        for name, check in checks.items():
            try:
                said = check(browser, address, shots, downloads, asked)
            except SystemExit as error:
                failed, said = True, f"FAILED: {error}; {browser.run('return document.body.innerText')[:300]!r}"
                browser.shot(shots / f"{name}-failed.png")
            wrong = browser.errors()
            failed |= bool(wrong)
            print(f"{name}: {said}" + "".join(f"\n  console: {line}" for line in wrong), flush=True)
    finally:
        browser.close()
    print(f"pictures are in {shots}")
    sys.exit(failed)


def scenes(browser, address, _shots, _downloads, asked):
    """The engine comes to the same bits as on this machine."""
    browser.open(f"{address}?scenes")
    rows = wait(lambda: browser.run("return document.getElementById('scenes')?.textContent"), 3000, "scenes")
    known = {}
    if asked.scenes:
        for line in pathlib.Path(asked.scenes).read_text().splitlines():
            name, hash_, median = line[:16].strip(), *line[16:].split()[:2]
            known[name] = (hash_, float(median))
    said, wrong = ["in the browser, and how many times as long as on this machine"], 0
    for line in rows.splitlines():
        name, hash_, median = line[:16].strip(), *line[16:].split()[:2]
        native = known.get(name)
        same = "" if native is None else "same bits" if native[0] == hash_ else "OTHER BITS"
        wrong += same == "OTHER BITS"
        times = "" if native is None else f"{float(median) / native[1]:.2f}"
        said.append(f"  {name:16} {hash_} {median:>9} ms {times:>6} {same}")
    if wrong:
        raise SystemExit("\n".join(said))
    return "\n".join(said)


def cold(browser, address, shots, *_):
    """A first visit: nothing kept, the first page, then the dance."""
    browser.open(address)
    opened = browser.reached("lole", 240)
    settling = browser.reached("settling", 180)
    first = browser.reached("drawn", 60)
    dancing = browser.reached("dancing", 300)
    browser.shot(shots / "cold.png")
    return f"open after {opened} ms, sewn after {settling} ms, she is seen after {first} ms and dances after {dancing} ms"


# Places in the window [CSS pixel], which is always of SIZE.
BEGIN, UNDO, PAUSE, HIP, CLOTH, PAPER, GROUP = (660, 569), (200, 23), (372, 737), (192, 493), (265, 73), (150, 115), (265, 115)
BOOKLET, PATTERN, MODEL = (155, 250), (155, 332), (155, 413)
CHOOSE_LIST, ORDER, PICTURES = (155, 170), (155, 636), (18, 511)
OWN_CLOTH, OWN_NAME, NOWHERE = (110, 514), (203, 711), (640, 23)
SKIRT = (340, 60, 930, 640)


def begun(browser, address):
    """The page with nothing kept, the first question answered, and the dance stopped."""
    browser.open("about:blank")
    browser.devtools("Storage.clearDataForOrigin", origin=address.rstrip("/"), storageTypes="local_storage,indexeddb")
    browser.open(address)
    browser.reached("drawn", 240)
    browser.click(*BEGIN)
    browser.click(*PAUSE)


def pixels(png):
    """Rows of a PNG of 8 bits without interlace, as bytes, and how many bytes a pixel has."""
    place, packed, width, depth = 8, b"", 0, 0
    while place < len(png):
        length, kind = struct.unpack(">I4s", png[place:place + 8])
        data = png[place + 8:place + 8 + length]
        if kind == b"IHDR":
            width, depth = struct.unpack(">I", data[:4])[0], {2: 3, 6: 4}[data[9]]
        packed += data if kind == b"IDAT" else b""
        place += 12 + length
    raw, stride = zlib.decompress(packed), width * depth
    above = bytes(stride)
    for start in range(0, len(raw), stride + 1):
        kind, row = raw[start], bytearray(raw[start + 1:start + 1 + stride])
        for at in range(stride) if kind else ():
            left = row[at - depth] if depth <= at else 0
            up, corner = above[at], above[at - depth] if depth <= at else 0
            if kind == 4:
                guess = left + up - corner
                far = abs(guess - left), abs(guess - up), abs(guess - corner)
                add = (left, up, corner)[far.index(min(far))]
            else:
                add = (0, left, up, (left + up) // 2)[kind]
            row[at] = (row[at] + add) & 255
        yield row, depth
        above = row


def skirt(browser):
    """How many pixels of the picture have the strong reds and yellows of the built-in print."""
    x, y, width, height = SKIRT
    clip = {"x": x, "y": y, "width": width, "height": height, "scale": 1}
    png = base64.b64decode(browser.devtools("Page.captureScreenshot", format="png", clip=clip)["data"])
    return sum(110 < row[at] - row[at + 2] for row, depth in pixels(png) for at in range(0, len(row), depth))


def kept(browser):
    return browser.run("return localStorage.getItem('lole.work') || ''")


def changes_hip(browser, address, shots, *_):
    """A wider hip is a wider skirt in the picture, and undo brings the old one back."""
    begun(browser, address)
    before = skirt(browser)
    browser.click(*HIP)
    browser.keys("130\ue007")
    wide = wait(lambda: (now := skirt(browser)) > 1.15 * before and now, 240, "a wider skirt")
    wait(lambda: "hip_cm = 130" in kept(browser), 20, "130 cm are kept")
    browser.shot(shots / "hip.png")
    browser.click(*UNDO)
    again = wait(lambda: (now := skirt(browser)) < 1.05 * before and now, 240, "the old skirt")
    if "hip_cm = 130" in kept(browser).split("\n[", 1)[0] or again < 0.9 * before:
        raise SystemExit(f"undo left something: {before} pixels before, {again} after")
    return f"{before} pixels of cloth, {wide} at a hip of 130 cm, {again} after undo"


def seen(browser, place, size=(200, 34)):
    """The picture around a place, with the pointer away, as bytes."""
    browser.click(*NOWHERE)
    time.sleep(1)
    x, y = place[0] - size[0] / 2, place[1] - size[1] / 2
    clip = {"x": x, "y": y, "width": size[0], "height": size[1], "scale": 1}
    return browser.devtools("Page.captureScreenshot", format="png", clip=clip)["data"]


def writes_japanese(browser, address, shots, *_):
    """Japanese comes in through a composition, and is what the same text is that was pasted."""
    begun(browser, address)
    browser.click(*CLOTH)
    browser.click(*OWN_CLOTH)
    time.sleep(1)
    empty = seen(browser, OWN_NAME)
    browser.click(*OWN_NAME)
    for part in ["は", "はな", "花", "花の布"]:
        browser.devtools("Input.imeSetComposition", text=part, selectionStart=len(part), selectionEnd=len(part))
        time.sleep(0.3)
    browser.shot(shots / "japanese-composing.png")
    browser.devtools("Input.insertText", text="花の布")
    time.sleep(0.5)
    browser.shot(shots / "japanese.png")
    composed = seen(browser, OWN_NAME)
    browser.click(*OWN_NAME)
    browser.keys("\ue003" * 6)
    cleared = seen(browser, OWN_NAME)
    browser.click(*OWN_NAME)
    browser.devtools("Input.insertText", text="花の布")
    pasted = seen(browser, OWN_NAME)
    if composed == empty or cleared != empty or pasted != composed:
        raise SystemExit(f"written: {composed != empty}, cleared: {cleared == empty}, as pasted: {pasted == composed}")
    return "composed and pasted text look alike, and can be deleted"


def finds_design(browser, address, shots, *_):
    """A page that was shut without saving comes back as it was."""
    begun(browser, address)
    usual = seen(browser, HIP, (90, 30))
    browser.click(*HIP)
    browser.keys("130\ue007")
    wait(lambda: "hip_cm = 130" in kept(browser), 20, "130 cm are kept")
    before = seen(browser, HIP, (90, 30))
    browser.open(address)
    browser.reached("drawn", 240)
    after = seen(browser, HIP, (90, 30))
    browser.shot(shots / "found.png")
    if usual == before or before != after or "hip_cm = 130" not in kept(browser):
        raise SystemExit(f"shown before: {usual != before}, and after: {before == after}")
    return "130 cm are there after a reload"


def downloaded(folder, ending, seconds):
    """The bytes of the newest download with an ending, once it is whole; it is taken away."""
    def whole():
        found = [path for path in folder.iterdir() if path.name.endswith(ending)]
        return found and not list(folder.glob("*.crdownload")) and found[0]
    path = wait(whole, seconds, f"a download *{ending}")
    content = path.read_bytes()
    path.unlink()
    return content


def is_pdf(content):
    return content.startswith(b"%PDF-1.") and content.rstrip().endswith(b"%%EOF") and b"/FontFile3" in content


def makes_paper(browser, address, _shots, downloads, _asked):
    """Booklet, patterns and the 3D file come as downloads that are what they are called."""
    begun(browser, address)
    browser.click(*PAPER)
    browser.click(*BOOKLET)
    booklet = downloaded(downloads, ".pdf", 300)
    browser.click(*PATTERN)
    archive = zipfile.ZipFile(io.BytesIO(downloaded(downloads, ".zip", 300)))
    browser.click(*MODEL)
    model = downloaded(downloads, ".glb", 1200)
    if not is_pdf(booklet):
        raise SystemExit(f"the booklet is no whole PDF: {booklet[:8]}")
    if archive.testzip() or not {".svg", ".pdf", ".dxf"} <= {pathlib.Path(name).suffix for name in archive.namelist()}:
        raise SystemExit(f"patterns: {archive.namelist()}")
    magic, version, length, size, kind = struct.unpack("<4sII I4s", model[:20])
    if (magic, version, length, kind) != (b"glTF", 2, len(model), b"JSON"):
        raise SystemExit(f"the 3D file is no whole glTF 2: {model[:20]}")
    scene = json.loads(model[20:20 + size])
    if not scene["meshes"] or not scene["animations"]:
        raise SystemExit("the 3D file shows nothing or does not move")
    return (f"booklet {len(booklet)} bytes, {len(archive.namelist())} files of patterns, "
            f"3D file {len(model)} bytes with {len(scene['meshes'])} meshes")


def makes_order(browser, address, shots, downloads, _asked):
    """An order for three dancers is one archive with everything on paper."""
    begun(browser, address)
    browser.click(*GROUP)
    browser.click(*CHOOSE_LIST)
    list_ = pathlib.Path(tempfile.mkdtemp(prefix="lole-list-")) / "halau.csv"
    list_.write_text("name,stature,hip\nNani,150,85\nMalia,160,95\nケイコ,155,100\n")
    chooser = browser.call("POST", "/element", {"using": "css selector", "value": "#chooser"})
    browser.call("POST", f"/element/{next(iter(chooser.values()))}/value", {"text": str(list_)})
    time.sleep(2)
    browser.shot(shots / "order.png")
    browser.click(*PICTURES)
    browser.click(*ORDER)
    archive = zipfile.ZipFile(io.BytesIO(downloaded(downloads, ".zip", 600)))
    names = archive.namelist()
    broken = archive.testzip()
    order = json.loads(archive.read("order.json"))
    if broken or not all(is_pdf(archive.read(name)) for name in ["order.pdf", "booklet.pdf"]):
        raise SystemExit(f"the archive is not whole: {broken} {names}")
    dancers = [dancer["name"] for dancer in order["dancers"]]
    if dancers != ["Nani", "Malia", "ケイコ"]:
        raise SystemExit(f"the order is for {dancers}")
    return f"{len(names)} files for {', '.join(dancers)}: {', '.join(names)}"


def loses_graphics(browser, address, _shots, *_):
    """Where the browser takes the graphics away, the page comes back with the design."""
    begun(browser, address)
    browser.click(*HIP)
    browser.keys("130\ue007")
    wait(lambda: "hip_cm = 130" in kept(browser), 20, "130 cm are kept")
    before = browser.run("return performance.timeOrigin")
    browser.run("document.getElementById('studio').getContext('webgl2').getExtension('WEBGL_lose_context').loseContext()")
    wait(lambda: browser.run("return performance.timeOrigin") != before, 60, "the page opened again")
    drawn = browser.reached("drawn", 240)
    if "hip_cm = 130" not in kept(browser):
        raise SystemExit("the design is gone")
    browser.errors()
    return f"opened again, and drawn after {drawn} ms"


def opens_offline(browser, address, shots, *_):
    """After the first visit the page needs no server: it opens, dances and has its fonts for paper."""
    browser.open(address)
    wait(lambda: browser.run("return !!navigator.serviceWorker?.controller"), 120, "the offline worker")
    fonts = "const done = arguments[0]; caches.match('paper-bold.otf').then((found) => done(!!found))"
    wait(lambda: browser.call("POST", "/execute/async", {"script": fonts, "args": []}), 120, "fonts are kept")
    SERVER.shutdown()
    SERVER.server_close()
    browser.open(address)
    drawn = browser.reached("drawn", 240)
    dancing = browser.reached("dancing", 240)
    browser.shot(shots / "offline.png")
    return f"without a server she is seen after {drawn} ms and dances after {dancing} ms"


# The last one ends the server.
CHECKS = {"cold": cold, "hip": changes_hip, "japanese": writes_japanese, "found": finds_design, "paper": makes_paper,
          "order": makes_order, "lost": loses_graphics, "scenes": scenes, "offline": opens_offline}

if __name__ == "__main__":
    main()
