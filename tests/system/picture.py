"""Screenshots: QEMU's PPM and our golden PNG files, and how two of them differ.

Only what is needed here: 8-bit RGB; PNG rows unfiltered or filtered by "up", as write_png makes them.
"""
import struct
import zlib

CHANNEL = 24  # a pixel differs when a channel is off by more, of 255: as in tests/support/golden.h
FRACTION = 0.004  # of the pixels may differ


class Picture:
    """`rows`: one bytes object of R, G, B triples per row, from the top."""

    def __init__(self, width, rows):
        self.width = width
        self.rows = rows

    @property
    def height(self):
        return len(self.rows)

    def pixel(self, x, y):
        return tuple(self.rows[y][3 * x:3 * x + 3])


class Difference:
    """`pixels` that differ, and `marked`: the first picture, pale, with them in red."""

    def __init__(self, pixels, marked):
        self.pixels = pixels
        self.marked = marked

    def is_small(self):
        return self.pixels <= FRACTION * self.marked.width * self.marked.height


def read_ppm(path):
    magic, size, depth, data = path.read_bytes().split(b"\n", 3)
    width, height = map(int, size.split())
    if magic != b"P6" or depth != b"255" or len(data) != 3 * width * height:
        raise ValueError(f"{path}: not an 8-bit PPM")
    return Picture(width, _cut(data, 3 * width))


def read_png(path):
    data = path.read_bytes()
    place, packed, header = 8, b"", None
    while place < len(data):
        length, kind = struct.unpack_from(">I4s", data, place)
        body = data[place + 8:place + 8 + length]
        place += 12 + length
        if kind == b"IHDR":
            header = struct.unpack(">IIBBBBB", body)
        elif kind == b"IDAT":
            packed += body
    if header is None or header[2:] != (8, 2, 0, 0, 0):
        raise ValueError(f"{path}: not a plain 8-bit RGB PNG")
    above, rows = bytes(3 * header[0]), []
    for line in _cut(zlib.decompress(packed), 1 + 3 * header[0]):
        above = _unfiltered(line[0], line[1:], above)
        rows.append(above)
    return Picture(header[0], rows)


def write_png(picture, path):
    above, lines = bytes(3 * picture.width), []
    for row in picture.rows:
        lines.append(b"\2" + bytes((a - b) & 255 for a, b in zip(row, above)))
        above = row
    header = struct.pack(">IIBBBBB", picture.width, picture.height, 8, 2, 0, 0, 0)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + _chunk(b"IHDR", header) +
                     _chunk(b"IDAT", zlib.compress(b"".join(lines), 9)) + _chunk(b"IEND", b""))


def compare(picture, golden, ignored=()):
    """`ignored`: rectangles (left, top, right, bottom) that don't count. None: other sizes."""
    if (picture.width, picture.height) != (golden.width, golden.height):
        return None
    pixels, marked = 0, []
    for y, (row, other) in enumerate(zip(picture.rows, golden.rows)):
        pale = bytearray(128 + value // 2 for value in row)
        if row != other:
            pixels += _mark(row, other, pale, [r for r in ignored if r[1] <= y < r[3]])
        marked.append(bytes(pale))
    return Difference(pixels, Picture(picture.width, marked))


def _mark(row, other, pale, ignored):
    count = 0
    for x in range(len(row) // 3):
        i = 3 * x
        if row[i:i + 3] == other[i:i + 3] or any(r[0] <= x < r[2] for r in ignored):
            continue
        if max(abs(row[i + c] - other[i + c]) for c in range(3)) > CHANNEL:
            pale[i:i + 3] = b"\xff\0\0"
            count += 1
    return count


def _cut(data, length):
    return [data[i:i + length] for i in range(0, len(data), length)]


def _unfiltered(kind, line, above):
    if kind == 0:
        return line
    if kind == 2:
        return bytes((a + b) & 255 for a, b in zip(line, above))
    raise ValueError("a PNG row that write_png did not make")


def _chunk(kind, body):
    return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
