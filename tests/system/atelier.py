"""Parti at work in the machine: drawn on, sent commands, asked what is safe."""
import re
import time

from laboratory import COMMANDS, check
from machine import MachineError
from program import Program


NO_COMMAND = "begin?"


class Atelier(Program):
    """One run of the application with the document /data/NAME.parti."""

    def __init__(self, machine, document, display="kms"):
        """On the console, or on the desktop (x11)."""
        self._said = len(machine.said())
        super().__init__(machine, "parti", f"draw {display} {document}", typed=display == "kms")
        # What is no command is complained of as soon as the program listens: it has begun then.
        machine.must(f"test -p {COMMANDS} || mkfifo {COMMANDS}; echo {NO_COMMAND} >{COMMANDS}")
        self.wait_for(NO_COMMAND)

    def acknowledged(self):
        """How many strokes and commands of this run the program says are safe."""
        numbers = re.findall(r"^acknowledged (\d+)$", self._new(), re.MULTILINE)
        return int(numbers[-1]) if numbers else 0

    def command(self, *lines):
        """Commands as of a drawing, one after the other; waits until they are safe."""
        before = self.acknowledged()
        text = "\n".join(lines)
        self.machine.must(f"cat >{COMMANDS} <<'end'\n{text}\nend")
        self.wait_acknowledged(before + len(lines))

    def wait_acknowledged(self, number, limit_s=90):
        limit = time.monotonic() + limit_s
        while self.acknowledged() < number:
            if time.monotonic() > limit or not self.running():
                raise MachineError(f"{self.acknowledged()} of {number} strokes and commands are safe;"
                                   f" the program says:\n{self.complaints()}{self._new()}")
            time.sleep(0.2)
        failed = re.findall(r"^failed .*$", self._new(), re.MULTILINE)
        check(not failed, f"what was drawn or told failed: {failed}")

    def draw(self, tablets, acts, speed):
        """Commands and strokes; each act begins when the one before is safe."""
        for act in acts:
            if act.commands:
                self.command(*act.commands)
            if act.strokes:
                safe = self.acknowledged()
                tablets.play(act.drawing(), speed)
                self.wait_acknowledged(safe + act.strokes)

    def _new(self):
        return self.machine.said()[self._said:]
