"""What `parti record` wrote (docs/drawings.md), as far as the stages look at it."""


class Report:
    """One line of a pen or a finger: kind, time, place [mm], and its axes as text by name."""

    def __init__(self, line):
        words = line.split()
        self.kind = words[2]
        self.t_s = float(words[3])
        self.place_mm = tuple(float(value) for value in words[4].split(","))
        self.axes = dict(word.split("=") for word in words[5:] if "=" in word)

    def tool(self):
        return self.axes.get("tool", "pen")


def reports(text, device):
    """All of a kind of device: "pen" or "touch"."""
    return [Report(line) for line in text.splitlines() if line.startswith(device + " ")]


def strokes(text):
    """The pen's reports from each `down` to where the tip left the surface, or the device went."""
    found, current = [], None
    for line in text.splitlines():
        if line.startswith("device ") and " removed " in line:
            current = None
        if not line.startswith("pen "):
            continue
        report = Report(line)
        if report.kind == "down":
            current = []
            found.append(current)
        elif report.kind in ("up", "out"):
            current = None
        if current is not None:
            current.append(report)
    return found
