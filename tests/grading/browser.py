"""A real browser without a window, told what to do over DevTools' pipe: JSON between zero bytes."""

from __future__ import annotations

import base64
import io
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any  # what DevTools answers

import numpy as np
from PIL import Image

NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome")
FLAGS = (
    "--headless",
    "--remote-debugging-pipe",
    "--no-first-run",
    "--disable-gpu",
    "--hide-scrollbars",
    "--disable-dev-shm-usage",  # small in containers
    "--disable-background-networking",
    "--disable-component-update",
    "--force-color-profile=srgb",
)
# DevTools reads from descriptor 3 and writes to 4. First out of the way: an end may be 3 or 4.
PUT_PIPES = """
import fcntl, os, sys
ends = [fcntl.fcntl(int(end), fcntl.F_DUPFD, 10) for end in sys.argv[1:3]]
for end, place in zip(ends, (3, 4)):
    os.dup2(end, place)
os.execvp(sys.argv[3], sys.argv[3:])
"""


def find_browser() -> str:
    """Return Chromium's program, whichever name it goes by."""
    for name in NAMES:
        if path := shutil.which(name):
            return path
    raise AssertionError(
        f"No browser to look at pages with: none of {', '.join(NAMES)} is installed. "
        "bash install.sh --dev installs Chromium."
    )


class Browser:
    """Chromium with one page; what the page did wrong is kept.

    Attributes
    ----------
    requests : list of str
        Addresses that were asked for, without those that hold their data themselves.
    faults : list of str
        Uncaught exceptions, messages of the console, and what the page's policy refused.
    """

    def __init__(self, profile: Path) -> None:
        self._answers = b""
        self._count = 0
        self._session = ""
        self._is_loaded = False
        self.requests: list[str] = []
        self.faults: list[str] = []
        self._start([find_browser(), *FLAGS, f"--user-data-dir={profile}", "about:blank"])
        try:
            target = self.send("Target.createTarget", url="about:blank")["targetId"]
            answer = self.send("Target.attachToTarget", targetId=target, flatten=True)
            self._session = answer["sessionId"]
            for domain in ("Page", "Runtime", "Network", "Log"):
                self.send(f"{domain}.enable")
        except BaseException:
            self.close()
            raise

    def _start(self, command: list[str]) -> None:
        if os.geteuid() == 0:
            command.append("--no-sandbox")  # Chromium refuses to sandbox what root starts
        ours, its_output = os.pipe()
        its_input, self._to_it = os.pipe()
        ends = (its_input, its_output)
        self._process = subprocess.Popen(
            [sys.executable, "-ISc", PUT_PIPES, *map(str, ends), *command],
            pass_fds=ends,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        for end in ends:
            os.close(end)
        self._from_it = os.fdopen(ours, "rb")

    def close(self) -> None:
        """End the browser."""
        self._process.kill()
        self._process.wait()
        self._from_it.close()
        os.close(self._to_it)

    def send(self, method: str, **params: object) -> Any:
        """Return the answer to a command."""
        self._count += 1
        message = {"id": self._count, "method": method, "params": params}
        if self._session:
            message["sessionId"] = self._session
        os.write(self._to_it, json.dumps(message).encode() + b"\0")
        while (answer := self._receive()).get("id") != self._count:
            self._note(answer)
        if "error" in answer:
            raise AssertionError(f"{method}: {answer['error']['message']}")
        return answer["result"]

    def open(self, page: Path, width: int = 1280, height: int = 800, scheme: str = "light") -> None:
        """Open a file in a window of a size, and wait until all of it is there."""
        self.requests.clear()
        self.faults.clear()
        self.resize(width, height, scheme)
        self._is_loaded = False
        self.send("Page.navigate", url=page.as_uri())
        while not self._is_loaded:
            self._note(self._receive())
        self.requests.remove(page.as_uri())

    def resize(self, width: int, height: int, scheme: str = "light") -> None:
        """Give the window a size in CSS pixels, and its user a colour scheme."""
        metrics = {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": width < 600}
        self.send("Emulation.setDeviceMetricsOverride", **metrics)
        feature = {"name": "prefers-color-scheme", "value": scheme}
        self.send("Emulation.setEmulatedMedia", features=[feature])

    def value(self, expression: str) -> Any:
        """Return what a JavaScript expression of the page comes to."""
        answer = self.send(
            "Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True
        )
        assert "exceptionDetails" not in answer, answer["exceptionDetails"]
        return answer["result"].get("value")

    def click(self, selector: str) -> None:
        """Click the middle of an element with the mouse."""
        x, y = self.value(
            f"(() => {{ const e = document.querySelector({json.dumps(selector)});"
            "e.scrollIntoView({block: 'center'}); const r = e.getBoundingClientRect();"
            "return [r.x + r.width / 2, r.y + r.height / 2]; })()"
        )
        for kind in ("mousePressed", "mouseReleased"):
            self.send("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", clickCount=1)

    def write(self, text: str) -> None:
        """Type a text into what has the focus."""
        self.send("Input.insertText", text=text)

    def press(self, key: str) -> None:
        """Press a key: "ArrowRight", "Tab"."""
        for kind in ("keyDown", "keyUp"):
            code = {"ArrowRight": 39, "ArrowLeft": 37, "Tab": 9}[key]
            self.send("Input.dispatchKeyEvent", type=kind, key=key, windowsVirtualKeyCode=code)

    def picture(self, *, is_whole_page: bool = False) -> np.ndarray:
        """Return what is to be seen, (h, w, 3) uint8."""
        answer = self.send("Page.captureScreenshot", captureBeyondViewport=is_whole_page)
        data = base64.b64decode(answer["data"])
        return np.asarray(Image.open(io.BytesIO(data)).convert("RGB"))

    def _receive(self) -> Any:
        while b"\0" not in self._answers:
            data = os.read(self._from_it.fileno(), 1 << 20)
            if not data:
                raise AssertionError("The browser has ended by itself.")
            self._answers += data
        message, _, self._answers = self._answers.partition(b"\0")
        return json.loads(message)

    def _note(self, event: Any) -> None:
        details = event.get("params", {})
        match event.get("method"):
            case "Page.loadEventFired":
                self._is_loaded = True
            case "Network.requestWillBeSent" if not details["request"]["url"].startswith("data:"):
                self.requests.append(details["request"]["url"])
            case "Runtime.exceptionThrown":
                self.faults.append(details["exceptionDetails"]["text"])
            case "Runtime.consoleAPICalled":
                self.faults.append(str(details["args"]))
            case "Log.entryAdded":
                self.faults.append(details["entry"]["text"])
