"""The demo: on KMS the tablet draws the house of assets/drawings, stroke by stroke, as the real pen
would; fingers then turn it and come closer; and the document holds its rules."""
import pathlib

from atelier import Atelier
from document import Document
from hand import Hand, house
from laboratory import check

HOUSE = pathlib.Path(__file__).resolve().parents[2] / "assets" / "drawings" / "house.pen"
SPEED = 4  # of the hand; the emulated processor is what takes the time


def run(laboratory, machine, tablets):
    atelier = Atelier(machine, "house")
    atelier.draw(tablets, house(HOUSE.read_text()), SPEED)
    atelier.settle()
    laboratory.expect_golden(machine, "demo")
    _turn_and_come_closer(laboratory, atelier, tablets)
    atelier.end()
    with Document(machine, "house", laboratory.folder) as document:
        check(document.is_whole(), "the document is damaged")
        check(document.outline() == _outline_of_the_replay(laboratory, machine),
              f"other rules than those of the drawing:\n{document.outline()}")


def _turn_and_come_closer(laboratory, atelier, tablets):
    turn, closer = Hand(), Hand()
    turn.fingers([(500, 400), (800, 380)])
    closer.fingers([(560, 360), (420, 300)], [(720, 400), (860, 460)])
    for hand, name in ((turn, "demo_turned"), (closer, "demo_closer")):
        tablets.play(hand.drawing())
        atelier.settle()
        laboratory.expect_golden(atelier.machine, name)


def _outline_of_the_replay(laboratory, machine):
    """What `parti replay` makes of the same drawing, in the same machine."""
    machine.send(HOUSE.read_bytes(), "/data/house.pen")
    machine.must("parti replay /data/house.pen --save /data/replayed.parti", limit_s=180)
    with Document(machine, "replayed", laboratory.folder) as document:
        return document.outline()
