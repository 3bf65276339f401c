"""The power: the machine is switched off in mid-stroke and started again; the document is whole, holds
every stroke and command that the program had said is safe, and is drawn on."""
import time

from atelier import Atelier
from document import Document
from hand import Hand, house
from laboratory import Failure, Tablets, check
from stage_demo import HOUSE, SPEED

ACTS = 3  # of the house, before the stroke that is cut
CUT = [(100, 600), (350, 600), (350, 640), (100, 640)]  # where nothing else is
CUT_SPEED = 0.1
INK_S = 60
DARK = 120  # a channel of ink


def run(laboratory, machine, tablets):
    acts = house(HOUSE.read_text())
    atelier = Atelier(machine, "house")
    begun = atelier.acknowledged()
    atelier.draw(tablets, acts[:ACTS], SPEED)
    atelier.settle()
    hand = Hand()
    hand.stroke(CUT)
    tablets.begin(hand.drawing(), CUT_SPEED)
    _wait_for_ink(machine)
    safe = atelier.acknowledged() - begun
    machine.kill()
    with laboratory.boot() as again:
        _check_document(laboratory, again, acts[:ACTS], safe)
        tablets = Tablets(again)
        atelier = Atelier(again, "house")
        atelier.settle()
        laboratory.expect_golden(again, "power_back")
        atelier.draw(tablets, acts[ACTS:ACTS + 1], SPEED)
        atelier.end()


def _wait_for_ink(machine):
    """The stroke has begun, and not ended."""
    limit = time.monotonic() + INK_S
    while time.monotonic() < limit:
        seen = machine.screenshot()
        if _is_inked(seen, CUT[0]):
            check(not _is_inked(seen, CUT[-1]), "the stroke was too quick to be cut")
            return
    raise Failure("the pen leaves no ink")


def _is_inked(seen, place):
    near = range(-3, 4)
    return any(max(seen.pixel(place[0] + x, place[1] + y)) < DARK for x in near for y in near)


def _check_document(laboratory, machine, acts, safe):
    done = [word for act in acts
            for word in [c.split()[0] for c in act.commands] + ["stroke"] * act.strokes]
    check(safe == len(done), f"{safe} of {len(done)} strokes and commands were said to be safe")
    with Document(machine, "house", laboratory.folder) as document:
        check(document.is_whole(), "the document is damaged")
        kinds = [step.split()[0] for step in document.steps()]
        check(kinds[-len(done):] == done, f"not what was done, but {document.steps()}")
