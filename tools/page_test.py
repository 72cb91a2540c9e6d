#!/usr/bin/env python3
"""Uses the page in a real Chromium, as its users do, and says what it saw.

usage: page_test.py [--folder target/web/page] [--shots FOLDER] [--scenes native.txt] [names of checks]

Needs Chromium and its driver (Debian: chromium, chromium-driver), and nothing else.
`--scenes` holds the engine's hashes in the browser against those of this machine, as
`cargo run --release -p lole_web --example scenes` prints them.
"""

import argparse
import base64
import functools
import http.server
import json
import pathlib
import subprocess
import sys
import tempfile
import threading
import time
import urllib.request

SIZE = (1280, 800)
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
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), serve)
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
        server.shutdown()
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


CHECKS = {"scenes": scenes, "cold": cold}

main()
