"""Stages one after the other within a limit: what each took, and which one was cut off, and why.

Time that is up and a signal end a stage alike, by CutOff, so machines go down on the way out. What a
stage does is not known here.
"""
import contextlib
import signal
import time
import traceback

SIGNALS = (signal.SIGTERM, signal.SIGINT, signal.SIGHUP)


class CutOff(BaseException):
    """The run ends here: nothing for a stage to catch."""


class Timetable:
    def __init__(self, stages, begin_s, end_s):
        """stages   {name: function that gives what is wrong, or nothing}
        begin_s  from now: no stage begins later than this
        end_s    from now: a stage that still runs then is cut off
        """
        self._stages = stages
        self._start = time.monotonic()
        self._begin_s, self._end_s = begin_s, end_s
        self._took = {}  # the stages that came to their end, in order: (seconds, passed)

    def run(self, prepare=lambda: None):
        """Does `prepare`, then each stage, and says how each ended; True when all passed."""
        current = "preparing"
        began = self._start
        try:
            with _cutting(self._end_s):
                prepare()
                for current, stage in self._stages.items():
                    began = time.monotonic()
                    self._run_one(current, stage)
        except CutOff as cut:
            self._tell_cut(current, time.monotonic() - began, cut)
        failed = len(self._stages) - sum(passed for _, passed in self._took.values())
        print(f"system: {len(self._stages) - failed} passed, {failed} failed, {self._spent():.0f} s", flush=True)
        return failed == 0

    def _run_one(self, name, stage):
        if self._spent() > self._begin_s:
            print(f"system: {name}: FAILED: no time left of {self._begin_s:g} s", flush=True)
            return
        print(f"system: {name} …", flush=True)
        start = time.monotonic()
        trouble = stage()
        took = time.monotonic() - start
        self._took[name] = (took, not trouble)
        print(f"system: {name}: {took:.0f} s, {f'FAILED: {trouble}' if trouble else 'ok'}", flush=True)

    def _spent(self):
        return time.monotonic() - self._start

    def _tell_cut(self, name, ran_s, cut):
        done = [f"{other} {took:.0f} s{'' if passed else ' (failed)'}" for other, (took, passed) in self._took.items()]
        ahead = [other for other in self._stages if other not in self._took and other != name]
        print(f"system: {name}: FAILED: cut off after {ran_s:.0f} s: {cut}, in {_place(cut)}\n"
              f"  finished before: {', '.join(done) or 'nothing'}\n"
              f"  not begun: {', '.join(ahead) or 'nothing'}\n"
              f"  hint: {_remedy(name, name in self._stages)}", flush=True)


def _remedy(name, is_stage):
    if not is_stage:
        return "is the network slow that Debian's kernel comes through? Once fetched it stays in build/system"
    return (f"try it alone, on a host with nothing else to do: tests/system/run --stage {name}; "
            "if it stops at the same place, build/system/boot-N says what the machine did")


@contextlib.contextmanager
def _cutting(limit_s):
    """Raises CutOff inside when the time is up or a signal comes; the first one only."""
    def cut(number, _):
        for each in (*SIGNALS, signal.SIGALRM):
            signal.signal(each, signal.SIG_IGN)
        why = f"{limit_s:g} s are over" if number == signal.SIGALRM else f"{signal.Signals(number).name} came"
        raise CutOff(why)

    before = {each: signal.signal(each, cut) for each in (*SIGNALS, signal.SIGALRM)}
    signal.setitimer(signal.ITIMER_REAL, limit_s)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        for each, handler in before.items():
            signal.signal(each, handler)


def _place(cut):
    """The line of the stage that waited, and what it called: enough to know what never came."""
    frames = traceback.extract_tb(cut.__traceback__)
    of_stage = [frame for frame in frames if "stage_" in frame.filename] or frames[-2:-1]
    return " > ".join(f"{frame.name} ({frame.filename.rpartition('/')[2]}:{frame.lineno})" for frame in of_stage)
