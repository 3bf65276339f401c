"""The desktop: under Xorg, in the machine of the other stages, a window gets the tablet's pressure,
tilt and eraser, and the touch screen's fingers, and shows where they were."""
from laboratory import still_screen
from marks import DRAWING, check_events, touch_everything
from program import Program

XORG = "/usr/lib/xorg/Xorg :0 vt3 -nolisten tcp -noreset -logfile /run/Xorg.log >/run/Xorg.out 2>&1"


def run(laboratory, machine, tablets):
    start_xorg(machine)
    probe = Program(machine, "parti_display_probe", "probe x11", typed=False)
    probe.wait_for("window")
    still_screen(machine)
    touch_everything(tablets)
    laboratory.expect_golden(machine, "x11_marks")
    probe.end()
    check_events(machine.fetch(DRAWING).decode())


def start_xorg(machine):
    machine.must(f"{XORG} &")
    machine.wait_until("test -S /tmp/.X11-unix/X0", "Xorg")
