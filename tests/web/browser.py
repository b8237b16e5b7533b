# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# A browser without a window, controlled by the DevTools protocol through a pipe. It needs only Python.
#   with Browser() as browser:
#     page = browser.page("file:///…/page.html", size=(800, 600), dark=False)
#     page.ask("document.title")       returns the value of an expression; waits for promises
#     page.until("ready === true")     waits until an expression is true
#     page.key("ArrowLeft", shift=True); page.type("text"); page.mouse("mousePressed", x, y)
#     page.picture("out.png"); page.said     `said` has the log and the exceptions of the page
import base64, json, os, shutil, subprocess, tempfile, threading, time
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer


def find_browser():
    names = [os.environ.get("BROWSER", ""), "chromium", "chromium-browser", "google-chrome"]
    return next(filter(None, map(shutil.which, filter(None, names))), None)


class Browser:
    def __init__(self, *flags, webgl=True):
        self.folder = tempfile.mkdtemp(prefix="betwixt-web-")
        here, to = os.pipe()
        back, there = os.pipe()
        graphics = ("--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader") if webgl else (
            "--disable-gpu", "--disable-3d-apis")
        words = [find_browser(), "--headless=new", "--no-sandbox", "--disable-quic", "--no-first-run", "--hide-scrollbars",
                 "--disable-background-networking", "--disable-component-update", "--disable-sync",
                 "--remote-debugging-pipe", f"--user-data-dir={self.folder}/profile", *graphics, *flags, "about:blank"]

        def at_three_and_four():  # moves the pipes to 3 and 4, where the browser expects them; one may be there already
            a, b = os.dup(here), os.dup(there)
            a, b = (os.dup(f) if f in (3, 4) else f for f in (a, b))
            os.dup2(a, 3), os.dup2(b, 4)

        self.process = subprocess.Popen(words, preexec_fn=at_three_and_four, close_fds=False,
                                        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(here), os.close(there)
        self.to, self.back = to, os.fdopen(back, "rb", buffering=0)
        self.number, self.answers, self.pages = 0, {}, {}
        self.news = threading.Condition()
        threading.Thread(target=self.listen, daemon=True).start()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        try:
            self.call("Browser.close")
            self.process.wait(10)
        except Exception:
            self.process.kill()
        shutil.rmtree(self.folder, ignore_errors=True)

    def listen(self):
        held = b""
        while more := self.back.read(1 << 16):
            *whole, held = (held + more).split(b"\0")
            with self.news:
                for message in map(json.loads, whole):
                    if "id" in message:
                        self.answers[message["id"]] = message
                    elif page := self.pages.get(message.get("sessionId")):
                        page.hear(message)
                self.news.notify_all()
        with self.news:
            self.answers = None
            self.news.notify_all()

    def call(self, method, session=None, patience=60, **what):
        with self.news:
            self.number += 1
            number = self.number
        message = {"id": number, "method": method, "params": what, **({"sessionId": session} if session else {})}
        data = json.dumps(message).encode() + b"\0"
        while data:
            data = data[os.write(self.to, data):]
        with self.news:
            if not self.news.wait_for(lambda: self.answers is None or number in self.answers, patience):
                raise TimeoutError(f"{method}: no answer in {patience} s")
            if self.answers is None:
                raise RuntimeError("the browser has ended")
            answer = self.answers.pop(number)
        if "error" in answer:
            raise RuntimeError(f"{method}: {answer['error']['message']}")
        return answer["result"]

    def page(self, url="about:blank", **how):
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        return Page(self, target, session, url, **how)


class Page:
    def __init__(self, browser, target, session, url, size=(1000, 700), dark=False, calm=False, ratio=1, touch=False):
        self.browser, self.target, self.session = browser, target, session
        self.said, self.loaded = [], False
        browser.pages[session] = self
        for domain in ("Page", "Runtime", "Log"):
            self.call(f"{domain}.enable")
        self.show(size, dark, calm, ratio, touch)
        self.go(url)

    def call(self, method, **what):
        return self.browser.call(method, self.session, **what)

    def hear(self, message):
        method, what = message["method"], message["params"]
        if method == "Page.loadEventFired":
            self.loaded = True
        elif method == "Runtime.exceptionThrown":
            thrown = what["exceptionDetails"]
            self.said.append("threw " + thrown.get("exception", {}).get("description", thrown["text"]))
        elif method == "Runtime.consoleAPICalled":
            self.said.append(" ".join(str(a.get("value", a.get("description", ""))) for a in what["args"]))
        elif method == "Log.entryAdded":
            self.said.append(what["entry"]["text"])

    def show(self, size=None, dark=None, calm=None, ratio=1, touch=False):  # touch: a phone
        if size:
            self.call("Emulation.setDeviceMetricsOverride", width=size[0], height=size[1], deviceScaleFactor=ratio, mobile=touch)
            self.call("Emulation.setTouchEmulationEnabled", enabled=touch, maxTouchPoints=5)
        media = {"prefers-color-scheme": dark and "dark" or "light", "prefers-reduced-motion": calm and "reduce" or "no-preference"}
        self.call("Emulation.setEmulatedMedia", features=[{"name": n, "value": v} for n, v in media.items()])

    def go(self, url):
        self.loaded = False
        self.call("Page.navigate", url=url)
        with self.browser.news:
            if not self.browser.news.wait_for(lambda: self.loaded, 60):
                raise TimeoutError(f"{url} has not been loaded in a minute")

    def ask(self, expression, patience=60):
        answer = self.call("Runtime.evaluate", expression=f"(async () => ({expression}))()", awaitPromise=True,
                           returnByValue=True, userGesture=True, patience=patience)
        if "exceptionDetails" in answer:
            thrown = answer["exceptionDetails"]
            raise RuntimeError(f"{expression}: " + thrown.get("exception", {}).get("description", thrown["text"]))
        return answer["result"].get("value")

    def do(self, statements, patience=60):
        return self.ask(f"await (async () => {{ {statements} }})()", patience)

    def until(self, expression, patience=30):
        end = time.monotonic() + patience
        while not (value := self.ask(expression)):
            if time.monotonic() > end:
                raise TimeoutError(f"{expression} is not so in {patience} s; the page said {self.said[-3:]}")
            time.sleep(0.05)
        return value

    codes = {"Enter": 13, "Escape": 27, "Tab": 9, "Backspace": 8, "ArrowLeft": 37, "ArrowUp": 38, "ArrowRight": 39,
             "ArrowDown": 40, "Home": 36, "End": 35, "Delete": 46}

    def key(self, name, shift=False, ctrl=False):
        text = {"Enter": "\r"}.get(name, name if len(name) == 1 and not ctrl else "")
        code = self.codes.get(name) or (ord(name.upper()) if name.isalnum() or name == " " else 0)
        for kind in ("keyDown" if text else "rawKeyDown", "keyUp"):
            self.call("Input.dispatchKeyEvent", type=kind, key=name, windowsVirtualKeyCode=code,
                      code=f"Key{name.upper()}" if len(name) == 1 and name.isalpha() else name,
                      modifiers=8 * shift + 2 * ctrl, **({"text": text} if text and kind == "keyDown" else {}))

    def type(self, text):
        for c in text:
            self.key("Enter" if c == "\n" else c)

    def mouse(self, kind, x, y, button="left"):
        self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button=button, clickCount=1)

    def click(self, x, y):
        self.mouse("mouseMoved", x, y, "none"), self.mouse("mousePressed", x, y), self.mouse("mouseReleased", x, y)

    def picture(self, path, whole=False):
        data = self.call("Page.captureScreenshot", format="png", captureBeyondViewport=whole)["data"]
        with open(path, "wb") as out:
            out.write(base64.b64decode(data))

    def close(self):
        self.browser.call("Target.closeTarget", targetId=self.target)


# Serves a folder over HTTP, with chosen headers for each file. `as` gives the address.
class Served:
    def __init__(self, folder, **headers):
        def end_headers(handler):
            for name, value in headers.items():
                handler.send_header(name.replace("_", "-"), value)
            SimpleHTTPRequestHandler.end_headers(handler)
        quiet = type("Quiet", (SimpleHTTPRequestHandler,), {"log_message": lambda *_: None, "end_headers": end_headers})
        handler = partial(quiet, directory=folder)
        self.server = ThreadingHTTPServer(("127.0.0.1", 0), handler)

    def __enter__(self):
        threading.Thread(target=self.server.serve_forever, daemon=True).start()
        return f"http://127.0.0.1:{self.server.server_port}"

    def __exit__(self, *_):
        self.server.shutdown()
        self.server.server_close()
