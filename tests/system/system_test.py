#!/usr/bin/env python3
"""The whole program in a whole machine: Debian's kernel in QEMU, a pen tablet, a touch screen, a screen.

Usage: system_test.py --build FOLDER [--stage NAME]...      docs/system-test.md says more.
Exit status 0: all stages passed; 1: one did not; 77: the machine can't be built here.
"""
import argparse
import pathlib
import shutil
import sys
import traceback

import kernel
import stage_demo
import stage_desktop
import stage_devices
import stage_power
import stage_screen
from laboratory import Failure, Laboratory, Tablets
from machine import MachineError
from timetable import Timetable

ROOT = pathlib.Path(__file__).resolve().parents[2]
STAGES = {
    "devices": stage_devices,
    "screen": stage_screen,
    "desktop": stage_desktop,
    "demo": stage_demo,
    "power": stage_power,
}
PROGRAMS = ("qemu-system-x86_64", "setpriv", "mke2fs", "dpkg-deb", "apt-get", "busybox", "ldd")
BEGIN_S = 15 * 60  # no stage begins later
END_S = BEGIN_S + 45  # and none goes on; tests/system/run ends this program 15 s later
SKIPPED = 77


def why_not():
    """What is missing on this machine, or nothing."""
    missing = [program for program in PROGRAMS if not shutil.which(program)]
    if missing:
        return f"{', '.join(missing)} not found; .ci/packages, group system, lists what is needed"
    return None


def skip(reason):
    bar = "!" * 100
    print(f"{bar}\nsystem: SKIPPED, the machine was not tested: {reason}\n{bar}", flush=True)
    return SKIPPED


def run_stage(stage, laboratory):
    """In a machine of its own; what went wrong, or nothing."""
    try:
        laboratory.renew_disk()
        with laboratory.boot() as machine:
            stage.run(laboratory, machine, Tablets(machine))
    except (Failure, MachineError) as failed:
        return str(failed)
    except Exception:  # a mistake of ours, or a file that is missing: the other stages still count
        return traceback.format_exc()
    return None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, required=True, help="where parti was built")
    parser.add_argument("--stage", choices=STAGES, action="append", help="only this one")
    options = parser.parse_args()
    if reason := why_not():
        return skip(reason)
    folder, laboratory = ROOT / "build" / "system", []

    def prepare():
        laboratory.append(Laboratory(folder, options.build, folder / "kernel"))

    def of(name):
        return lambda: run_stage(STAGES[name], laboratory[0])

    timetable = Timetable({name: of(name) for name in options.stage or STAGES}, BEGIN_S, END_S)
    try:
        return 0 if timetable.run(prepare) else 1
    except kernel.NoKernel as missing:
        return skip(str(missing))


if __name__ == "__main__":
    sys.exit(main())
