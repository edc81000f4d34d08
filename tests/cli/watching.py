"""Runs `overstrike watch` in a terminal of its own, and reads what it draws."""

import fcntl
import os
import pty
import re
import select
import struct
import subprocess
import termios
import time

OVERSTRIKE = os.environ["OVERSTRIKE"]
TERMINAL = {**os.environ, "TERM": "xterm-256color", "LC_ALL": "C.UTF-8", "COLORTERM": "", "NO_COLOR": ""}
STATUS = re.compile(rb"\033\[7m[^\033]*\033\[0m\033\[K\Z")  # the last of a screen
PATIENCE = 60  # seconds; nothing takes so long


def picture(scene, columns, lines, *words):
    """What a window of that size shows of the scene, a line being left for the state of things."""
    out = subprocess.run([OVERSTRIKE, "render", str(scene), "-d", "terminal", "-o", "-", "--size",
                          f"{columns}x{lines - 1}", *words], env=TERMINAL, capture_output=True, check=True)
    return out.stdout.replace(b"\n", b"\r\n")


class Watching:
    def __init__(self, scene, *words, columns=40, lines=12):
        self.fd, window = pty.openpty()
        self.resize(columns, lines)
        self.modes = termios.tcgetattr(window)
        self.process = subprocess.Popen([OVERSTRIKE, "watch", str(scene), *words], stdin=window,
                                        stdout=window, stderr=window, env=TERMINAL, start_new_session=True,
                                        preexec_fn=lambda: fcntl.ioctl(0, termios.TIOCSCTTY, 0))
        self.window = window

    def resize(self, columns, lines):
        fcntl.ioctl(self.fd, termios.TIOCSWINSZ, struct.pack("HHHH", lines, columns, 0, 0))

    def read_until(self, *wanted):
        """Everything up to a whole screen with all of it, or what came before patience ended."""
        seen, end = b"", time.monotonic() + PATIENCE
        while not (STATUS.search(seen) and all(one in seen for one in wanted)):
            if not select.select([self.fd], [], [], max(0, end - time.monotonic()))[0]:
                break
            seen += os.read(self.fd, 65536)
        return seen

    def press(self, keys):
        os.write(self.fd, keys)

    def ended(self):
        """The exit status, and what was said at last."""
        status = self.process.wait(timeout=PATIENCE)
        said = b""
        while select.select([self.fd], [], [], 0)[0]:
            said += os.read(self.fd, 65536)
        return status, said

    def close(self):
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()
        os.close(self.fd)
        os.close(self.window)
