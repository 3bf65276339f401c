"""What every stage works with: the guest's image, disks, machines with our devices plugged in, and
golden pictures."""
import os
import pathlib
import subprocess
import time

import guest_image
import kernel
import picture
from machine import SOCKETS, Machine, MachineError

HERE = pathlib.Path(__file__).resolve().parent
GOLDEN = HERE.parent / "golden"
GUEST_SHARE = "/usr/share/parti-machine"
DEVICES = ("cintiq_13hd", "touch_screen")
PROGRAMS = ("parti", "parti_uinput_devices", "parti_display_probe")
COMMANDS = "/run/commands"
COMPLAINTS = "/run/parti.log"
# To have less to type in the guest: draw DISPLAY DOCUMENT and probe DISPLAY.
DRAW = f"""#!/bin/sh
test -p {COMMANDS} || mkfifo {COMMANDS}
exec parti "/data/$2.parti" --display "$1" --commands {COMMANDS} \\
  --acknowledged /dev/virtio-ports/said 2>{COMPLAINTS}
"""
PROBE = f"""#!/bin/sh
exec parti_display_probe "$1" /run/probe.pen 2>{COMPLAINTS}
"""
DISK_MB = 64
SETTLE_S = 90  # a picture has to stand still within this time
STILL_S = 6  # and counts as still after this one


class Failure(Exception):
    """What a stage found wrong."""


def check(holds, what):
    if not holds:
        raise Failure(what)


class Laboratory:
    def __init__(self, folder, build, cache):
        """folder: for logs, disks and images;  build: where the programs are;  cache: for the
        kernel's package."""
        self.folder = folder
        folder.mkdir(parents=True, exist_ok=True)
        self._kernel = kernel.fetch(cache)
        self._initramfs = folder / "initramfs"
        files = {f"{GUEST_SHARE}/{name}.txt": (HERE / "devices" / f"{name}.txt").read_text()
                 for name in DEVICES}
        files |= {"/usr/bin/draw": DRAW, "/usr/bin/probe": PROBE}
        programs = {f"/usr/bin/{name}": build / name for name in PROGRAMS}
        guest_image.build(self._kernel, programs, files, self._initramfs)
        self._disk = folder / "disk.img"
        self._boots = 0

    def renew_disk(self):
        """The machines that boot from now on have an empty disk with a file system."""
        self._disk.unlink(missing_ok=True)
        subprocess.run(["mke2fs", "-q", "-F", "-t", "ext4", self._disk, f"{DISK_MB}M"], check=True,
                       stdout=subprocess.DEVNULL, timeout=60)

    def boot(self):
        """A machine (a context) that is up, without devices of ours, with the disk as it is."""
        self._boots += 1
        folder = self.folder / f"boot-{self._boots}"
        return Machine(self._kernel.image, self._initramfs, self._disk, folder)

    def expect_golden(self, machine, name, ignored=(), screen=SOCKETS[0]):
        """The screen comes to look like tests/golden/system_NAME.png: a picture that still changes
        is waited for. PARTI_UPDATE_GOLDEN=1 writes it instead: look at it before committing it."""
        path = GOLDEN / f"system_{name}.png"
        if os.environ.get("PARTI_UPDATE_GOLDEN") == "1":
            picture.write_png(still_screen(machine, screen), path)
            return
        check(path.exists(), f"there is no {path.name}; PARTI_UPDATE_GOLDEN=1 writes it")
        golden = picture.read_png(path)
        limit = time.monotonic() + SETTLE_S
        while True:
            seen = machine.screenshot(screen)
            difference = picture.compare(seen, golden, ignored)
            if difference and difference.is_small():
                return
            if time.monotonic() > limit:
                break
            time.sleep(0.5)
        picture.write_png(seen, path.with_suffix(".out.png"))
        check(difference is not None, f"{path.name} has another size; see .out.png")
        picture.write_png(difference.marked, path.with_suffix(".diff.png"))
        raise Failure(f"{path.name}: {difference.pixels} pixels differ; see .out.png and .diff.png")


def still_screen(machine, screen=SOCKETS[0]):
    """The screen as soon as it stands still."""
    limit = time.monotonic() + SETTLE_S
    last, since = machine.screenshot(screen), time.monotonic()
    while time.monotonic() - since < STILL_S and time.monotonic() < limit:
        time.sleep(0.25)
        now = machine.screenshot(screen)
        if now.rows != last.rows:
            last, since = now, time.monotonic()
    return last


class Tablets:
    """Our devices in a machine, and what is drawn on them."""

    FIFO = "/run/tablets"
    LOG = "/run/tablets.log"

    def __init__(self, machine):
        self._machine = machine
        self._played = 0
        self._answers = {}  # how often each was given
        machine.must(f"parti_uinput_devices {self.FIFO} >{self.LOG} 2>&1 &")
        machine.wait_until(f"test -p {self.FIFO}", "the program that makes devices")
        self.plug()

    def plug(self):
        for name in DEVICES:
            self._machine.must(f"echo plug {GUEST_SHARE}/{name}.txt >{self.FIFO}")
            self._wait_for("plugged")
        self._machine.must("udevadm settle")

    def unplug(self):
        self._machine.must(f"echo unplug >{self.FIFO}")
        self._wait_for("unplugged")

    def play(self, drawing, speed=1, limit_s=120):
        """Plays a drawing to its end."""
        path = self.begin(drawing, speed)
        self._wait_for(f"played {path}", limit_s)

    def begin(self, drawing, speed=1):
        """Begins to play; gives the drawing's name in the guest."""
        self._played += 1
        path = f"/run/drawing-{self._played}.pen"
        self._machine.send(drawing, path)
        self._machine.must(f"echo play {path} {speed} >{self.FIFO}")
        return path

    def _wait_for(self, answer, limit_s=30):
        """The next answer of this kind."""
        self._answers[answer] = self._answers.get(answer, 0) + 1
        said = self._machine.wait_until(
            f"cat {self.LOG}; grep -q '^error' {self.LOG} ||"
            f" test $(grep -c '^{answer}' {self.LOG}) -ge {self._answers[answer]}",
            f"the tablets' answer `{answer}`", limit_s)
        if "error" in said:
            raise MachineError(f"the tablets: {said}")
