#!/usr/bin/env python3
"""Draws the images that examples wear, beside this file: bricks.png, tiles.png and planks.png.

Each shows 1 m x 1 m and repeats. The same bytes every time; nothing but Python is needed.
"""
import os
import random
import struct
import zlib

SIDE = 256  # px, 1 m


def write_png(path, rows):
    """Rows of (r, g, b), from the top."""
    raw = b"".join(b"\0" + bytes(part for pixel in row for part in pixel) for row in rows)

    def chunk(kind, data):
        body = kind + data
        return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))

    header = struct.pack(">IIBBBBB", SIDE, SIDE, 8, 2, 0, 0, 0)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) +
                   chunk(b"IDAT", zlib.compress(raw, 9)) + chunk(b"IEND", b""))


def scaled(color, light):
    """In steps of 4, which files of few bytes are made of."""
    return tuple(max(0, min(255, round(part * light / 4) * 4)) for part in color)


def bricks(chance):
    """Stretcher bond: 12 courses of 8.3 cm, bricks of 25 cm, joints of 1 cm."""
    across, up = 4, 12
    light = [[chance.uniform(0.93, 1.06) for _ in range(across)] for _ in range(up)]
    warm = [[chance.uniform(0.95, 1.05) for _ in range(across)] for _ in range(up)]
    joint = 0.01

    def pixel(x, y):
        course = int(y * up)
        along = (x * across + 0.5 * (course % 2)) % across
        brick = int(along)
        if (along - brick) / across < joint or (y * up - course) / up < joint:
            return scaled((196, 188, 174), 1)
        tone = light[course][brick] * chance.choice((0.97, 1, 1, 1, 1.02))
        red, green, blue = 168, 84, 62
        return scaled((red, green * warm[course][brick], blue), tone)

    return pixel


def tiles(chance):
    """Flat clay tiles of 20 cm in rows of 25 cm, each row over the one below it."""
    across, up = 5, 4
    light = [[chance.uniform(0.93, 1.05) for _ in range(across)] for _ in range(up)]

    def pixel(x, y):
        row = int(y * up)
        along = (x * across + 0.5 * (row % 2)) % across
        tile, down = int(along), y * up - row
        tone = light[row][tile] * (0.90 + 0.14 * down)
        if along - tile < 0.04:
            tone *= 0.66
        if down < 0.07:
            tone *= 0.55  # the shadow of the row above
        return scaled((176, 96, 68), tone)

    return pixel


def planks(chance):
    """Upright boards of 12.5 cm, weathered."""
    across = 8
    light = [chance.uniform(0.93, 1.05) for _ in range(across)]
    grain = [chance.uniform(0.94, 1.04) for _ in range(SIDE)]

    def pixel(x, _):
        board = int(x * across)
        if x * across - board < 0.06:
            return scaled((92, 76, 60), 1)
        return scaled((178, 150, 116), light[board] * grain[int(x * SIDE)])

    return pixel


def main():
    folder = os.path.dirname(os.path.abspath(__file__))
    for draw in (bricks, tiles, planks):
        pixel = draw(random.Random(1))
        rows = [[pixel((x + 0.5) / SIDE, (y + 0.5) / SIDE) for x in range(SIDE)]
                for y in range(SIDE)]
        write_png(os.path.join(folder, draw.__name__ + ".png"), rows)


if __name__ == "__main__":
    main()
