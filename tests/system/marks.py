"""What parti_display_probe is given to show and to write down, on whatever display."""
import recorded
from hand import Hand
from laboratory import check

DRAWING = "/run/probe.pen"
PRESSURE_ERROR = 0.01


def touch_everything(tablets):
    """A line that is pressed harder and harder, the eraser on it, another line, two fingers."""
    hand = Hand()
    hand.stroke([(200, 150), (1000, 150)], pressure=lambda part: 0.1 + 0.9 * part)
    hand.stroke([(400, 150), (500, 150)], pressure=0.9, tool="eraser")
    hand.stroke([(200, 250), (600, 650)], pressure=0.3)
    hand.fingers([(700, 300), (700, 500)], [(900, 300), (1100, 500)])
    tablets.play(hand.drawing())


def check_events(text):
    """The probe's drawing says what touch_everything did."""
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
