"""The screen without a desktop: on KMS the tablet, its eraser and two fingers are shown and written
down; another console comes and goes; and whatever ends the program, the console shows text again and
takes what is typed."""
from laboratory import check, still_screen
from marks import DRAWING, check_events, touch_everything
from program import Program, type_on_console

ENDINGS = ("TERM", "SEGV", "KILL")


def run(laboratory, machine, tablets):
    for signal in ENDINGS:
        probe = _start(machine)
        touch_everything(tablets)
        laboratory.expect_golden(machine, "kms_marks")
        _switch_away_and_back(laboratory, machine, probe)
        probe.end(signal)
        type_on_console(machine, f"after-{signal.lower()}")
        _check_is_text(machine, f"after SIG{signal}")
        if signal == "TERM":
            check_events(machine.fetch(DRAWING).decode())


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
    black = sum(row.count(0) for row in seen.rows) / (3 * seen.width * seen.height)
    check(0.9 < black < 1, f"the screen does not show a text console {when}")
