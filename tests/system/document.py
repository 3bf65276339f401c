"""Documents that the program left on the guest's disk, read with SQLite alone."""
import re
import sqlite3


class Document:
    """A copy of a document that nobody in the guest has open."""

    def __init__(self, machine, name, folder):
        """Fetches /data/NAME.parti, and what SQLite keeps beside it, into `folder`."""
        self.path = folder / f"{name}.parti"
        for ending in ("", "-wal", "-shm"):
            copy = folder / f"{name}.parti{ending}"
            copy.unlink(missing_ok=True)
            if ending != "-shm" and machine.order(f"test -f /data/{name}.parti{ending}").status == 0:
                copy.write_bytes(machine.fetch(f"/data/{name}.parti{ending}"))
        self._base = sqlite3.connect(self.path)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._base.close()

    def is_whole(self):
        return self._base.execute("PRAGMA integrity_check").fetchall() == [("ok",)]

    def steps(self):
        """What was done, in order: `stroke N` and commands."""
        return [row[0] for row in self._base.execute("SELECT command FROM history ORDER BY id")]

    def outline(self):
        """The rules without their numbers, which tremble with the pen."""
        (rules,), = self._base.execute("SELECT text FROM rules")
        return re.sub(r"-?\d+(\.\d+)?", "N", rules)
