"""The screen without a desktop: on KMS the tablet, its eraser and two fingers are shown and written
down; another console comes and goes; and whatever ends the program, the console shows text again and
takes what is typed. A second screen comes and goes, and the first."""
import time

from laboratory import check, still_screen
from machine import SCREEN
from marks import DRAWING, check_events, touch_everything
from program import Program, type_on_console

OTHER_SCREEN = (800, 600)
TABLETS_SCREEN = (1176, 669)  # at QEMU's 100 pixels an inch, as large as the surface of the pen tablet
ENDINGS = ("TERM", "SEGV", "KILL")


def run(laboratory, machine, tablets):
    for signal in ENDINGS:
        probe = _start(machine)
        touch_everything(tablets)
        laboratory.expect_golden(machine, "kms_marks")
        _switch_away_and_back(laboratory, machine, probe)
        if signal == "TERM":
            _plug_and_unplug(laboratory, machine, probe)
        probe.end(signal)
        type_on_console(machine, f"after-{signal.lower()}")
        _check_is_text(machine, f"after SIG{signal}")
        if signal == "TERM":
            check_events(machine.fetch(DRAWING).decode())


def _plug_and_unplug(laboratory, machine, probe):
    """Of two screens the first is drawn on; the other where that is gone, or is the tablet's own."""
    machine.screens.plug("second", OTHER_SCREEN)
    _wait_for_socket(machine, "Virtual-2", "connected")
    laboratory.expect_golden(machine, "kms_marks")
    machine.screens.plug("first", SCREEN)  # as it is; but QEMU only unplugs what was once plugged
    machine.screens.unplug("first")
    _wait_for_size(machine, "second", OTHER_SCREEN)
    laboratory.expect_golden(machine, "kms_second", screen="second")
    check(_black_part(machine.screenshot("first")) > 0.9, "the screen that was pulled out is drawn on")
    machine.screens.plug("first", SCREEN)
    laboratory.expect_golden(machine, "kms_marks")
    machine.screens.plug("second", TABLETS_SCREEN)
    _wait_for_size(machine, "second", TABLETS_SCREEN)
    laboratory.expect_golden(machine, "kms_tablets_own", screen="second")
    machine.screens.unplug("second")
    laboratory.expect_golden(machine, "kms_marks")
    check(probe.running(), f"the program ended on the way:\n{probe.complaints()}")


def _wait_for_size(machine, screen, size_px):
    """Until somebody draws on it."""
    limit = time.monotonic() + 60
    while ((seen := machine.screenshot(screen)).width, seen.height) != size_px:
        check(time.monotonic() < limit, f"nothing of {size_px} is drawn on the {screen} screen, but of "
              f"{seen.width} x {seen.height}; sockets:\n{machine.must('cat /sys/class/drm/card0-*/status')}")
        time.sleep(0.3)


def _wait_for_socket(machine, name, state):
    machine.wait_until(f"grep -qx {state} /sys/class/drm/card0-{name}/status", f"{name} {state}", limit_s=30)


def _start(machine):
    probe = Program(machine, "parti_display_probe", "probe kms")
    probe.wait_for("the screen")
    return probe


def _switch_away_and_back(laboratory, machine, probe):
    machine.press("ctrl", "alt", "f2")
    _wait_for_console(machine, 2, probe)
    type_on_console(machine, "elsewhere")
    _check_is_text(machine, "on the second console")
    machine.press("alt", "f1")
    _wait_for_console(machine, 1, probe)
    laboratory.expect_golden(machine, "kms_marks")
    check(probe.running(), f"the program ended on the way:\n{probe.complaints()}")


def _wait_for_console(machine, number, probe):
    machine.wait_until(f"grep -qx tty{number} /sys/class/tty/tty0/active || {{ cat /run/parti.log; false; }}",
                       f"console {number}", limit_s=15)


def _check_is_text(machine, when):
    """Mostly black, and some light letters."""
    seen = still_screen(machine)
    check(0.9 < _black_part(seen) < 1, f"the screen does not show a text console {when}")


def _black_part(seen):
    return sum(row.count(0) for row in seen.rows) / (3 * seen.width * seen.height)
