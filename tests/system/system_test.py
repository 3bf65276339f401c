#!/usr/bin/env python3
"""The whole program in a whole machine: Debian's kernel in QEMU, a pen tablet, a touch screen, a screen.

Usage: system_test.py --build FOLDER [--stage NAME]...      docs/system-test.md says more.
Exit status 0: all stages passed; 1: one did not; 77: the machine can't be built here.
"""
import argparse
import pathlib
import shutil
import sys
import time
import traceback

import kernel
import stage_demo
import stage_desktop
import stage_devices
import stage_power
import stage_screen
from laboratory import Failure, Laboratory, Tablets
from machine import MachineError

ROOT = pathlib.Path(__file__).resolve().parents[2]
STAGES = {
    "devices": stage_devices,
    "screen": stage_screen,
    "desktop": stage_desktop,
    "demo": stage_demo,
    "power": stage_power,
}
PROGRAMS = ("qemu-system-x86_64", "setpriv", "mke2fs", "dpkg-deb", "apt-get", "busybox", "ldd")
LIMIT_S = 15 * 60
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


def run_stage(name, laboratory):
    """In a machine of its own; True when it passed."""
    start = time.monotonic()
    print(f"system: {name} …", flush=True)
    trouble = None
    try:
        laboratory.renew_disk()
        with laboratory.boot() as machine:
            STAGES[name].run(laboratory, machine, Tablets(machine))
    except (Failure, MachineError) as failed:
        trouble = str(failed)
    except Exception:  # a mistake of ours, or a file that is missing: the other stages still count
        trouble = traceback.format_exc()
    verdict = f"FAILED: {trouble}" if trouble else "ok"
    print(f"system: {name}: {time.monotonic() - start:.0f} s, {verdict}", flush=True)
    return trouble is None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, required=True, help="where parti was built")
    parser.add_argument("--stage", choices=STAGES, action="append", help="only this one")
    options = parser.parse_args()
    if reason := why_not():
        return skip(reason)
    start, folder = time.monotonic(), ROOT / "build" / "system"
    try:
        laboratory = Laboratory(folder, options.build, folder / "kernel")
    except kernel.NoKernel as missing:
        return skip(str(missing))
    failed, stages = [], options.stage or list(STAGES)
    for name in stages:
        if time.monotonic() - start > LIMIT_S:
            print(f"system: {name}: FAILED: no time left of {LIMIT_S} s", flush=True)
            failed.append(name)
        elif not run_stage(name, laboratory):
            failed.append(name)
    print(f"system: {len(stages) - len(failed)} passed, {len(failed)} failed, {time.monotonic() - start:.0f} s")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
