"""A program of ours at work in the machine: started as a person would, ended in every way."""
import time

from laboratory import COMPLAINTS, Failure
from machine import MachineError

COLUMNS = 160  # of the text console: the screen's width in letters of 8 px
START_S = 60
END_S = 30
SETTLE_S = 240
QUIET_LOOKS = 3  # a second apart: that was all
QUIET_TICKS = 2  # of the processor, 1/100 s, in which nothing is drawn


class Program:
    def __init__(self, machine, name, line, typed=True):
        """`line` starts the program `name`: typed on the console, or as an order (for a desktop).
        Waits until it runs."""
        self.machine = machine
        machine.must(f"rm -f {COMPLAINTS}")
        if typed:
            machine.type(line)
        else:
            machine.must(f"DISPLAY=:0 {line} &")
        # Not the child that looks after the console.
        self.pid = machine.wait_until(f"pidof {name} | tr ' ' '\\n' | sort -n | head -1 | grep .",
                                      f"the start of {name}", START_S).strip()

    def running(self):
        return self.machine.order(f"kill -0 {self.pid}").status == 0

    def complaints(self):
        """What it said on standard error."""
        return self.machine.order(f"cat {COMPLAINTS}").text

    def wait_for(self, words, limit_s=START_S):
        """Until it says something on standard error."""
        limit = time.monotonic() + limit_s
        while words not in self.complaints():
            if time.monotonic() > limit or not self.running():
                raise MachineError(f"the program does not say `{words}`, but:\n{self.complaints()}")
            time.sleep(0.3)

    def settle(self, limit_s=SETTLE_S):
        """Until it has nothing left to do: what is on the screen stays there."""
        limit, quiet, last = time.monotonic() + limit_s, 0, -1
        while quiet < QUIET_LOOKS:
            if time.monotonic() > limit:
                raise MachineError(f"the program is busy for more than {limit_s} s")
            time.sleep(1)
            ticks = int(self.machine.must(f"awk '{{ print $14 + $15 }}' /proc/{self.pid}/stat"))
            quiet = quiet + 1 if ticks - last <= QUIET_TICKS else 0
            last = ticks

    def end(self, signal="TERM"):
        """Sends a signal and waits for the program's end."""
        self.machine.must(f"kill -{signal} {self.pid}")
        self.machine.wait_until(f"! kill -0 {self.pid} 2>/dev/null", f"the end after SIG{signal}", END_S)


def console(machine, number):
    """The text on a console, line by line."""
    text = machine.must(f"cat /dev/vcs{number}")
    lines = [text[i:i + COLUMNS].rstrip() for i in range(0, len(text), COLUMNS)]
    return [line for line in lines if line]


def type_on_console(machine, word, limit_s=15):
    """Types a command on the keyboard; the console in front must show what it says."""
    number = machine.must("cat /sys/class/tty/tty0/active").strip().removeprefix("tty")
    machine.type(f"echo {word}")
    limit = time.monotonic() + limit_s
    while word not in (shown := console(machine, number)):
        if time.monotonic() > limit:
            raise Failure(f"console {number} does not do what is typed; it shows:\n" + "\n".join(shown))
        time.sleep(0.3)
