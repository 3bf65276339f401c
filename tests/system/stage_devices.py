"""Devices: what the tablet and the touch screen send comes through the kernel, udev and libinput, and
`parti record` writes it down as it was drawn; the house too, and a tablet that is pulled out and put
back in mid-stroke."""
import contextlib
import pathlib
import time

import recorded
from hand import Hand, house
from laboratory import check

HOUSE = pathlib.Path(__file__).resolve().parents[2] / "assets" / "drawings" / "house.pen"
ERROR_MM = 0.05  # the kernel swallows moves of less than the device's fuzz, 4 units of 1/200 mm
PRESSURE_ERROR = 0.01
TILT_ERROR_DEG = 1  # the tablet's steps
HOUSE_SPEED = 3


def run(laboratory, machine, tablets):
    _see_both_devices(machine)
    _record_axes(machine, tablets)
    _record_the_house(machine, tablets)
    _record_a_replugged_tablet(machine, tablets)


def _see_both_devices(machine):
    listed = machine.must("parti devices")
    check("Wacom Cintiq 13HD (056a:0304): pen, display, pressure, tilt, distance, eraser, 298 x 169 mm" in listed,
          f"parti devices does not list the tablet:\n{listed}")
    check("Parti Touch Screen (1209:5042): touch" in listed,
          f"parti devices does not list the touch screen:\n{listed}")


@contextlib.contextmanager
def _recording(machine, result):
    """Whatever is played inside is recorded; `result` gets the drawing's text."""
    machine.must("rm -f /run/r.pen; parti record /run/r.pen >/run/record.log 2>&1 & echo $! >/run/record.pid")
    machine.wait_until("test -s /run/r.pen", "parti record")
    yield
    time.sleep(0.5)
    machine.must("kill -INT $(cat /run/record.pid)")
    machine.wait_until("! kill -0 $(cat /run/record.pid) 2>/dev/null", "the end of parti record")
    result.append(machine.fetch("/run/r.pen").decode())


def _record_axes(machine, tablets):
    hand = Hand()
    hand.stroke([(100, 100), (300, 100), (300, 300)], pressure=lambda part: 0.2 + 0.6 * part)
    hand.stroke([(100, 200), (300, 200)], tool="eraser")
    hand.fingers([(200, 200), (300, 200)], [(400, 200), (500, 300)])
    texts = []
    with _recording(machine, texts):
        tablets.play(hand.drawing())
    strokes = recorded.strokes(texts[0])
    check([s[0].tool() for s in strokes] == ["pen", "eraser"], "not one stroke with each end of the pen")
    pressures = [float(report.axes["p"]) for report in strokes[0]]
    check(abs(pressures[0] - 0.2) < PRESSURE_ERROR and abs(pressures[-1] - 0.8) < PRESSURE_ERROR and
          pressures == sorted(pressures), f"pressure does not rise from 0.2 to 0.8: {pressures}")
    tilts = [float(part) for part in strokes[0][0].axes["tilt"].split(",")]
    check(max(abs(tilts[0] - 20), abs(tilts[1] - 10)) < TILT_ERROR_DEG, f"tilt is not 20, 10: {tilts}")
    lifted = [report.kind for report in recorded.reports(texts[0], "touch")].count("up")
    check(lifted == 2, f"{lifted} fingers left the touch screen, not 2")


def _record_the_house(machine, tablets):
    texts, wanted = [], []
    with _recording(machine, texts):
        for act in house(HOUSE.read_text()):
            if act.strokes:
                tablets.play(act.drawing(), HOUSE_SPEED)
                wanted += recorded.strokes(act.drawing().decode())
    seen = recorded.strokes(texts[0])
    check(len(seen) == len(wanted), f"{len(seen)} of {len(wanted)} strokes of the house were recorded")
    for number, (stroke, original) in enumerate(zip(seen, wanted), 1):
        for end in (0, -1):
            check(_distance(stroke[end], original[end]) < ERROR_MM, f"stroke {number} is elsewhere")


def _record_a_replugged_tablet(machine, tablets):
    cut, whole = Hand(), Hand()
    cut.stroke([(100, 100), (500, 100)], lift=False)
    whole.stroke([(100, 300), (500, 300)])
    texts = []
    with _recording(machine, texts):
        tablets.play(cut.drawing())
        tablets.unplug()
        tablets.plug()
        tablets.play(whole.drawing())
    check(texts[0].count(" removed ") == 2, "two devices went, but were not seen to go")
    check(len(recorded.strokes(texts[0])) == 2, "not a stroke before and one after the tablet was pulled out")


def _distance(report, other):
    return max(abs(a - b) for a, b in zip(report.place_mm, other.place_mm))
