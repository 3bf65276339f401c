"""What hands do, as drawings (docs/drawings.md) for the devices in devices/: lines, taps, pinches.

Places are pixels of the screen. Tablet and touch screen lie over the whole of it, as a display
tablet's do. Devices are numbered as in the drawings made here: 0 the pen, 1 the touch screen.
"""
import math
import re

from machine import SCREEN

SURFACE_MM = (297.76, 169.24)  # of both devices
STEP_S = 0.008  # between two reports
SPEED_PX_S = 700
FACTS = {
    0: 'name="Pen" vendor=056a product=0304 size_mm=297.76,169.24 pen pressure tilt distance eraser',
    1: 'name="Fingers" vendor=1209 product=5042 size_mm=297.76,169.24 touch',
}
# The house of assets/drawings: its tablet, and the view that it was drawn in.
HOUSE_TABLET_MM = (280, 175)
HOUSE_VIEW_PX = (1600, 1000)


class Hand:
    """Moves over the surfaces as time goes by; `drawing()` says what it did."""

    def __init__(self):
        self._t = 1.0
        self._lines = []

    def wait(self, seconds):
        self._t += seconds

    def stroke(self, points, pressure=0.5, tool="pen", lift=True):
        """The tip along straight lines through `points`, pressed as told, leaning to the right.

        pressure  one number, or a function of the part of the way [0, 1]
        lift      False: the pen stays on the surface and the drawing ends there
        """
        press = pressure if callable(pressure) else lambda _: pressure
        path = _along(points)
        self._pen("in", path[0], tool, 0, 0.5)
        self._pen("down", path[0], tool, press(0), 0)
        for number, place in enumerate(path):
            self._pen("move", place, tool, press(number / max(1, len(path) - 1)), 0)
        if lift:
            self._pen("up", path[-1], tool, 0, 0)
            self._pen("out", path[-1], tool, 0, 1)
            self.wait(0.1)

    def hover(self, place):
        """The pen comes near and stays there without touching."""
        self._pen("in", place, "pen", 0, 0.5)
        for _ in range(10):
            self._pen("move", place, "pen", 0, 0.4)

    def tap(self, place):
        """A short touch of the tip, as on a button."""
        self.stroke([place, (place[0] + 0.5, place[1])])

    def fingers(self, *paths):
        """One finger per path, all down, along and up together; each path is a list of points."""
        moves = [_along(path) for path in paths]
        steps = max(len(move) for move in moves)
        for finger, move in enumerate(moves):
            self._touch("down", finger, move[0])
        for step in range(steps):
            for finger, move in enumerate(moves):
                self._touch("move", finger, move[min(step, len(move) - 1)])
            self.wait(STEP_S)
        for finger, move in enumerate(moves):
            self._touch("up", finger, move[-1])
        self.wait(0.1)

    def drawing(self):
        facts = "".join(f"device {n} added 0 {f}\n" for n, f in FACTS.items())
        return f"parti-drawing 1\n{facts}{''.join(self._lines)}end\n".encode()

    def _pen(self, kind, place, tool, pressure, distance):
        x, y = _to_mm(place)
        named = "" if tool == "pen" else f" tool={tool}"
        self._lines.append(f"pen 0 {kind} {self._t:.6f} {x:.4f},{y:.4f} p={pressure:.4f} "
                           f"d={distance} tilt=20,10{named}\n")
        self.wait(STEP_S)

    def _touch(self, kind, finger, place):
        x, y = _to_mm(place)
        self._lines.append(f"touch 1 {kind} {self._t:.6f} {x:.4f},{y:.4f} finger={finger}\n")


class Act:
    """A part of the house: `commands` first, then `strokes` strokes, as a drawing."""

    def __init__(self):
        self.commands = []
        self.strokes = 0
        self._lines = []

    def add(self, line):
        self.strokes += line.split(" ")[2] == "up"
        self._lines.append(line)

    def drawing(self):
        return f"parti-drawing 1\ndevice 0 added 0 {FACTS[0]}\n{''.join(self._lines)}end\n".encode()


def house(text):
    """The acts of assets/drawings/house.pen: its strokes on our tablet, at the same places of views
    that are as high in angle and as wide as our screen makes them."""
    acts = [Act()]
    for line in text.splitlines():
        words = line.split(" ")
        if words[0] == "after":
            if acts[-1].strokes:
                acts.append(Act())
            command = line.split(": ", 1)[1]
            acts[-1].commands.append(re.sub(r"size \d+ \d+$", "size {} {}".format(*SCREEN), command))
        elif words[0] == "pen":
            words[4] = "{:.4f},{:.4f}".format(*_to_mm(_house_px(words[4])))
            acts[-1].add(" ".join(words) + "\n")
    return acts


def _house_px(position):
    """Screen pixels of a position on the house's tablet."""
    x, y = (float(value) * HOUSE_VIEW_PX[0] / HOUSE_TABLET_MM[0] for value in position.split(","))
    scale = SCREEN[1] / HOUSE_VIEW_PX[1]
    return ((x - HOUSE_VIEW_PX[0] / 2) * scale + SCREEN[0] / 2, y * scale)


def _to_mm(place):
    return (place[0] * SURFACE_MM[0] / SCREEN[0], place[1] * SURFACE_MM[1] / SCREEN[1])


def _along(points):
    """Places on the way through `points`, as far apart as a hand's reports are."""
    step_px = SPEED_PX_S * STEP_S
    path = [points[0]]
    for start, end in zip(points, points[1:]):
        steps = max(1, math.ceil(math.dist(start, end) / step_px))
        path += [tuple(a + (b - a) * i / steps for a, b in zip(start, end))
                 for i in range(1, steps + 1)]
    return path
