"""A whole machine in QEMU, emulated (TCG: no KVM needed): started, ordered about, looked at, killed.

Orders are shell scripts that go to guest/init through a virtio port, one at a time, answered with
status and output. Keys, screenshots and the end come through QEMU's own control socket (QMP). Every
wait has a limit; a machine that doesn't answer raises MachineError with the end of its log.
"""
import base64
import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import time

from line_socket import LineSocket
from picture import read_ppm
from screens import Sockets

SCREEN = (1280, 728)  # of the shape of the display tablet in devices, and affordable to emulate
SOCKETS = ("first", "second")  # of the graphics card: Virtual-1 and Virtual-2; the second has no screen at first
BOOT_LIMIT_S = 180
ORDER_LIMIT_S = 60
KEY_S = 0.15  # QEMU holds a key for 0.1 s

KEYS = {" ": ("spc",), "-": ("minus",), ".": ("dot",), "/": ("slash",), "_": ("shift", "minus")}


def bound_to_us(command):
    """The command such that it goes with this program, should that be killed; also before it has begun."""
    return ["setpriv", "--pdeathsig", "KILL", "sh", "-c", '[ "$PPID" = "$0" ] && exec "$@"', str(os.getpid()), *command]


class MachineError(Exception):
    """The machine did not do what it was told."""


class Answer:
    """A script's exit status, and what it said on either output."""

    def __init__(self, status, text):
        self.status = status
        self.text = text


class Machine:
    """Use as a context: whatever happens inside, QEMU is gone afterwards."""

    def __init__(self, kernel, initramfs, disk, folder):
        """Logs go to `folder`; what is in it from an earlier run is overwritten."""
        folder.mkdir(parents=True, exist_ok=True)
        self._folder = folder
        # Socket names must be short, whatever the folder's is.
        self._sockets = pathlib.Path(tempfile.mkdtemp(prefix="parti-machine-"))
        self.screens = Sockets(self._sockets, SOCKETS)
        self._orders = self._control = None
        self._number = 0
        with (folder / "qemu.log").open("wb") as complaints:
            self._qemu = subprocess.Popen(
                bound_to_us(self._command(kernel, initramfs, disk)), cwd=folder, stdin=subprocess.DEVNULL,
                stdout=subprocess.DEVNULL, stderr=complaints)

    def __enter__(self):
        try:
            self._wait_for_boot()
        except BaseException:
            self.kill()
            raise
        return self

    def __exit__(self, *_):
        self.kill()

    def _command(self, kernel, initramfs, disk):
        width, height = SCREEN
        return ["qemu-system-x86_64", "-accel", "tcg,thread=single", "-icount", "shift=0", "-cpu", "max", "-smp", "1",
                "-m", "2048", "-nodefaults", "-no-reboot", "-display", "none",
                "-device", f"virtio-gpu-pci,id=card,xres={width},yres={height},max_outputs={len(SOCKETS)}",
                *self.screens.arguments("card"),
                "-drive", f"file={disk},format=raw,if=virtio",
                "-serial", "file:console.log",
                "-device", "virtio-serial-pci",
                "-chardev", f"socket,id=orders,path={self._sockets}/orders,server=on,wait=off",
                "-device", "virtserialport,chardev=orders,name=orders",
                "-chardev", "file,id=said,path=said.log",
                "-device", "virtserialport,chardev=said,name=said",
                "-qmp", f"unix:{self._sockets}/control,server=on,wait=off",
                "-kernel", str(kernel), "-initrd", str(initramfs),
                # Consoles neither go blank nor blink, for the sake of screenshots.
                "-append", "console=ttyS0 quiet panic=-1 consoleblank=0 vt.cur_default=1"]

    def _wait_for_boot(self):
        limit = time.monotonic() + BOOT_LIMIT_S
        self._control = LineSocket(self._sockets / "control", limit, self._check_alive)
        self._line(self._control, limit, "hello")
        self._ask("qmp_capabilities")
        self._orders = LineSocket(self._sockets / "orders", limit, self._check_alive)
        if self._line(self._orders, limit, "the start") != "ready":
            raise MachineError(f"the guest did not come up:\n{self._log_end()}")

    def order(self, script, limit_s=ORDER_LIMIT_S):
        """Runs a shell script in the guest to its end; its status is the caller's business."""
        self._number += 1
        encoded = base64.b64encode(script.encode()).decode()
        self._orders.send(f"{self._number} {encoded}")
        words = self._line(self._orders, time.monotonic() + limit_s, script).split()
        if int(words[0]) != self._number:
            raise MachineError(f"answers are out of order: {words[0]} for {self._number}")
        text = base64.b64decode(words[2]) if len(words) > 2 else b""
        return Answer(int(words[1]), text.decode(errors="replace"))

    def must(self, script, limit_s=ORDER_LIMIT_S):
        """The same for a script that has to succeed; gives what it said."""
        answer = self.order(script, limit_s)
        if answer.status != 0:
            raise MachineError(f"`{script}` ended with {answer.status}:\n{answer.text}")
        return answer.text

    def wait_until(self, script, what, limit_s=ORDER_LIMIT_S):
        """Repeats a script until it succeeds; gives what it said then."""
        limit = time.monotonic() + limit_s
        while (answer := self.order(script)).status != 0:
            if time.monotonic() > limit:
                raise MachineError(f"{what}: not within {limit_s} s; last said:\n{answer.text}")
            time.sleep(0.3)
        return answer.text

    def fetch(self, path):
        """A file of the guest's, as bytes."""
        return base64.b64decode(self.must(f"base64 '{path}'", limit_s=120))

    def send(self, content, path):
        """Writes a file in the guest."""
        encoded = base64.b64encode(content).decode()
        self.must(f"base64 -d >'{path}' <<'end'\n{encoded}\nend")

    def press(self, *keys):
        """Keys of the machine's own keyboard, held together: press("ctrl", "alt", "f2")."""
        self._ask("send-key", keys=[{"type": "qcode", "data": key} for key in keys])
        time.sleep(KEY_S)

    def type(self, text):
        """A line of text on the same keyboard, and Return."""
        for letter in text:
            self.press(*KEYS.get(letter, (letter,)))
        self.press("ret")

    def screenshot(self, screen=SOCKETS[0]):
        """What a screen shows now."""
        path = self._folder / "screen.ppm"
        self._ask("screendump", filename=str(path), device="card", head=SOCKETS.index(screen))
        return read_ppm(path)

    def said(self):
        """What the guest has written to /dev/virtio-ports/said: it can't be taken back."""
        return (self._folder / "said.log").read_text(errors="replace")

    def kill(self):
        """As if the power failed: nothing is written, closed or asked."""
        self._qemu.kill()
        self._qemu.wait(timeout=30)
        for connection in (self._orders, self._control):
            if connection:
                connection.close()
        self._orders = self._control = None
        shutil.rmtree(self._sockets, ignore_errors=True)

    def _ask(self, command, **arguments):
        self._control.send(json.dumps({"execute": command, "arguments": arguments}))
        limit = time.monotonic() + ORDER_LIMIT_S
        while True:
            answer = json.loads(self._line(self._control, limit, command))
            if "error" in answer:
                raise MachineError(f"QEMU refuses {command}: {answer['error']['desc']}")
            if "return" in answer:
                return answer["return"]

    def _line(self, connection, limit, what):
        try:
            return connection.line(limit)
        except OSError as trouble:
            self._check_alive()
            raise MachineError(f"no answer to `{what}`: {trouble}\n{self._log_end()}") from None

    def _check_alive(self):
        if self._qemu.poll() is not None:
            complaint = (self._folder / "qemu.log").read_text(errors="replace")
            raise MachineError(f"QEMU ended with {self._qemu.returncode}: {complaint}")

    def _log_end(self):
        log = self._folder / "console.log"
        return "\n".join(log.read_text(errors="replace").splitlines()[-25:]) if log.exists() else ""
