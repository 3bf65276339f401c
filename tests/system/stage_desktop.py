"""The desktop: under Xorg, in the machine of the other stages, the window gets the tablet's pressure,
tilt and eraser, and the touch screen's fingers; pulled out and put back, they go on."""
import recorded
from hand import Hand
from laboratory import check, still_screen

XORG = "/usr/lib/xorg/Xorg :0 vt3 -nolisten tcp -noreset -logfile /run/Xorg.log >/run/Xorg.out 2>&1"
PROBE = "DISPLAY=:0 parti_display_probe x11 /run/probe.pen 2>/run/probe.log"
PRESSURE_ERROR = 0.01


def run(laboratory, machine, tablets):
    machine.must(f"{XORG} &")
    machine.wait_until("test -S /tmp/.X11-unix/X0", "Xorg")
    machine.must(f"{PROBE} & echo $! >/run/probe.pid")
    machine.wait_until("grep window /run/probe.log", "the window")
    still_screen(machine)
    _touch_everything(tablets)
    laboratory.expect_golden(machine, "x11_marks")
    machine.must("kill -TERM $(cat /run/probe.pid)")
    machine.wait_until("! kill -0 $(cat /run/probe.pid) 2>/dev/null", "the window's end")
    _check_events(machine.fetch("/run/probe.pen").decode())


def _touch_everything(tablets):
    hand = Hand()
    hand.stroke([(200, 150), (1000, 150)], pressure=lambda part: 0.1 + 0.9 * part)
    hand.stroke([(400, 150), (500, 150)], pressure=0.9, tool="eraser")
    hand.stroke([(200, 250), (600, 650)], pressure=0.3)
    hand.fingers([(700, 300), (700, 500)], [(900, 300), (1100, 500)])
    tablets.play(hand.drawing())


def _check_events(text):
    strokes = recorded.strokes(text)
    check([s[0].tool() for s in strokes] == ["pen", "eraser", "pen"], f"other strokes were seen:\n{text[:2000]}")
    # X tells that the pressure ends before it tells that the tip leaves.
    pressures = [p for report in strokes[0] if (p := float(report.axes["p"])) > 0]
    check(abs(pressures[0] - 0.1) < PRESSURE_ERROR and abs(pressures[-1] - 1) < PRESSURE_ERROR,
          f"pressure does not rise from 0.1 to 1: {pressures}")
    check(pressures == sorted(pressures), f"pressure does not rise steadily: {pressures}")
    check(all("tilt" in report.axes for report in strokes[0]), "the pen's tilt is missing")
    fingers = {report.axes["finger"] for report in recorded.reports(text, "touch")}
    check(len(fingers) == 2, f"{len(fingers)} fingers were seen, not 2")
