"""Packs of a corpus: what fuzzing found to be different, one file for each target.

pack.py pack FOLDER PACK [LARGEST]    all files of a folder of up to LARGEST bytes (512)
pack.py unpack PACK FOLDER            into files, for libFuzzer to go on with

A pack is one input after the other: its length in decimal, a newline, its bytes. corpus_main.cc reads it.
"""

import pathlib
import sys


def pack(folder, path, largest=512):
    inputs = sorted(file.read_bytes() for file in pathlib.Path(folder).iterdir())
    kept = [data for data in inputs if len(data) <= int(largest)]
    pathlib.Path(path).write_bytes(b"".join(b"%d\n" % len(data) + data for data in kept))
    print(f"{path}: {len(kept)} of {len(inputs)} inputs")


def unpack(path, folder):
    data = pathlib.Path(path).read_bytes()
    number = 0
    while data:
        length, _, rest = data.partition(b"\n")
        pathlib.Path(folder, f"{pathlib.Path(path).stem}-{number:05}").write_bytes(rest[: int(length)])
        data = rest[int(length):]
        number += 1


if __name__ == "__main__":
    commands = {"pack": pack, "unpack": unpack}
    if len(sys.argv) < 4 or sys.argv[1] not in commands:
        sys.exit(__doc__)
    commands[sys.argv[1]](*sys.argv[2:])
