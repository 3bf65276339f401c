"""The parts of the system test that need no machine: pictures, archives, hands, recordings, timetables."""
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import hand  # noqa: E402
import picture  # noqa: E402
import recorded  # noqa: E402
from file_tree import FileTree  # noqa: E402

HOUSE = pathlib.Path(__file__).resolve().parents[2] / "assets" / "drawings" / "house.pen"


def grey(width, height, value=100):
    return picture.Picture(width, [bytes([value]) * 3 * width for _ in range(height)])


def with_pixel(image, x, y, colour):
    row = bytearray(image.rows[y])
    row[3 * x:3 * x + 3] = bytes(colour)
    return picture.Picture(image.width, [*image.rows[:y], bytes(row), *image.rows[y + 1:]])


class Pictures(unittest.TestCase):
    def test_a_png_is_read_as_it_was_written(self):
        image = with_pixel(grey(7, 5), 3, 2, (0, 200, 255))
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "a.png"
            picture.write_png(image, path)
            self.assertEqual(picture.read_png(path).rows, image.rows)

    def test_a_ppm_is_read(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "a.ppm"
            path.write_bytes(b"P6\n2 1\n255\n" + bytes([1, 2, 3, 10, 10, 10]))
            self.assertEqual(picture.read_ppm(path).pixel(1, 0), (10, 10, 10))
            path.write_bytes(b"P6\n2 1\n255\n" + bytes([1, 2, 3]))
            self.assertRaises(ValueError, picture.read_ppm, path)

    def test_what_is_rounded_otherwise_does_not_differ_and_what_moved_does(self):
        golden = grey(100, 10)
        near = with_pixel(golden, 5, 5, (100, 100, 124))
        far = with_pixel(golden, 5, 5, (100, 100, 125))
        self.assertEqual(picture.compare(near, golden).pixels, 0)
        self.assertEqual(picture.compare(far, golden).pixels, 1)
        self.assertEqual(picture.compare(far, golden).marked.pixel(5, 5), (255, 0, 0))
        self.assertEqual(picture.compare(far, golden, [(5, 5, 6, 6)]).pixels, 0)
        self.assertEqual(picture.compare(far, golden, [(6, 5, 7, 6)]).pixels, 1)
        self.assertIsNone(picture.compare(grey(99, 10), golden))

    def test_one_pixel_in_two_hundred_and_fifty_may_differ(self):
        golden = grey(100, 10)
        image = golden
        for x in range(4):
            image = with_pixel(image, x, 0, (0, 0, 0))
        self.assertTrue(picture.compare(image, golden).is_small())
        self.assertFalse(picture.compare(with_pixel(image, 4, 0, (0, 0, 0)), golden).is_small())


class Archives(unittest.TestCase):
    def test_what_was_put_in_is_there_under_merged_names(self):
        tree = FileTree()
        tree.add_text("/lib/a/text", "hello\n")
        tree.add_text("/init", "#!/bin/sh\n", 0o755)
        tree.add_link("/etc/link", "../init")
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            tree.write(root / "archive")
            subprocess.run(["python3", "-c", UNPACK, root / "archive", root], check=True)
            self.assertEqual((root / "usr/lib/a/text").read_text(), "hello\n")


# A reader of the format by its description in cpio(5), to check the writer against.
UNPACK = """
import pathlib, sys
data, root, place = pathlib.Path(sys.argv[1]).read_bytes(), pathlib.Path(sys.argv[2]), 0
while True:
    assert data[place:place + 6] == b"070701"
    fields = [int(data[place + 6 + 8 * i:place + 14 + 8 * i], 16) for i in range(13)]
    name = data[place + 110:place + 109 + fields[11]].decode()
    place = (place + 110 + fields[11] + 3) // 4 * 4
    content = data[place:place + fields[6]]
    place = (place + fields[6] + 3) // 4 * 4
    if name == "TRAILER!!!":
        break
    if fields[1] >> 12 == 4:
        (root / name).mkdir(parents=True, exist_ok=True)
    elif fields[1] >> 12 == 8:
        (root / name).write_bytes(content)
"""


class Hands(unittest.TestCase):
    def test_a_stroke_is_as_it_was_told(self):
        told = hand.Hand()
        told.stroke([(0, 0), (1280, 728)], pressure=lambda part: part)
        (stroke,) = recorded.strokes(told.drawing().decode())
        self.assertEqual(stroke[0].place_mm, (0, 0))
        self.assertEqual(stroke[-1].place_mm, hand.SURFACE_MM)
        self.assertEqual((stroke[0].axes["p"], stroke[-1].axes["p"]), ("0.0000", "1.0000"))
        self.assertLess(max(b.t_s - a.t_s for a, b in zip(stroke, stroke[1:])), 0.01)

    def test_fingers_come_and_go_together(self):
        told = hand.Hand()
        told.fingers([(0, 0), (100, 0)], [(0, 100), (100, 100)])
        kinds = [report.kind for report in recorded.reports(told.drawing().decode(), "touch")]
        self.assertEqual((kinds[:2], kinds[-2:]), (["down", "down"], ["up", "up"]))

    def test_the_house_is_cut_into_acts_of_commands_and_strokes(self):
        acts = hand.house(HOUSE.read_text())
        self.assertEqual(acts[0].commands[1], "lot rect(20,14)")
        self.assertTrue(acts[0].commands[0].endswith("size 1280 728"), acts[0].commands[0])
        self.assertEqual(acts[1].commands, ["pick 1 extrude"])
        for act in acts:
            self.assertEqual(len(recorded.strokes(act.drawing().decode())), act.strokes)
        self.assertEqual(sum(act.strokes for act in acts[:-1]), 23)
        self.assertEqual(acts[-1].strokes, 0)

    def test_the_house_keeps_its_middle(self):
        (act,) = hand.house("pen 0 down 1 140,87.5\npen 0 up 1.1 140,87.5\n")
        self.assertIn("148.8800,84.6200", act.drawing().decode())


# A run of two stages whose machine is a sleeping child; arguments: its limits [s].
SLEEPY_RUN = """
import pathlib, sys, tempfile, time
sys.path.insert(0, {here!r})
from machine import Machine
from timetable import Timetable

class Bed(Machine):
    def _command(self, *_):
        return ["sleep", "300"]
    def _wait_for_boot(self):
        pass

def stage_sleep():
    with tempfile.TemporaryDirectory() as folder, Bed(None, None, None, pathlib.Path(folder)) as bed:
        print("child", bed._qemu.pid, flush=True); time.sleep(300)

stages = {{"quick": lambda: None, "bad": lambda: "a reason", "sleepy": stage_sleep, "later": lambda: None}}
sys.exit(0 if Timetable(stages, float(sys.argv[1]), float(sys.argv[2])).run() else 1)
"""


class Timetables(unittest.TestCase):
    """What a run says when it is cut off, and what it leaves behind: nothing."""

    def begin(self, begin_s, end_s):
        """The run as a program of its own, to be signalled."""
        script = SLEEPY_RUN.format(here=str(pathlib.Path(__file__).parent))
        run = subprocess.Popen([sys.executable, "-B", "-c", script, str(begin_s), str(end_s)],
                               stdout=subprocess.PIPE, text=True)
        self.addCleanup(run.kill)
        return run

    @staticmethod
    def child_of(run):
        """The machine that a run has started, once it has."""
        for line in run.stdout:
            if line.startswith("child "):
                return int(line.split()[1])
        raise AssertionError("the machine was not started")

    def assert_gone(self, pid):
        """Its process has ended, whoever is to bury it."""
        limit = time.monotonic() + 10
        stat = pathlib.Path(f"/proc/{pid}/stat")
        while stat.exists() and stat.read_text().rpartition(")")[2].split()[0] != "Z":
            self.assertLess(time.monotonic(), limit, "the machine lives on")
            time.sleep(0.02)

    def assert_told(self, said, why):
        self.assertRegex(said, rf"system: sleepy: FAILED: cut off after \d+ s: {why}, in stage_sleep")
        self.assertIn("finished before: quick 0 s, bad 0 s (failed)", said)
        self.assertIn("not begun: later", said)
        self.assertIn("hint: try it alone", said)
        self.assertIn("tests/system/run --stage sleepy", said)
        self.assertIn("1 passed, 3 failed", said)

    def test_a_run_whose_time_is_up_names_the_stage_and_ends_its_machine(self):
        run = self.begin(1, 1)
        child = self.child_of(run)
        said, _ = run.communicate(timeout=30)
        self.assert_told(said, "1 s are over")
        self.assertEqual(run.returncode, 1)
        self.assert_gone(child)

    def test_a_run_that_is_told_to_end_does_the_same(self):
        for number in (signal.SIGTERM, signal.SIGINT):
            run = self.begin(100, 100)
            child = self.child_of(run)
            run.send_signal(number)
            said, _ = run.communicate(timeout=30)
            self.assert_told(said, number.name + " came")
            self.assertEqual(run.returncode, 1)
            self.assert_gone(child)

    def test_a_run_that_is_killed_takes_its_machine_along(self):
        run = self.begin(100, 100)
        child = self.child_of(run)
        run.kill()
        run.communicate(timeout=30)
        self.assert_gone(child)

    def test_no_stage_begins_when_there_is_no_time_left(self):
        run = self.begin(0, 100)
        said, _ = run.communicate(timeout=30)
        self.assertEqual(said.count("no time left"), 4)
        self.assertEqual(run.returncode, 1)


if __name__ == "__main__":
    unittest.main()
