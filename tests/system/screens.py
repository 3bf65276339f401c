"""The sockets of the machine's graphics card: screens that are plugged in and pulled out, as a person
does. QEMU plugs one in when somebody who looks at it (a VNC client, RFC 6143) asks for a size, and
pulls it out at a size of nothing."""
import socket
import struct
import time

VERSION = b"RFB 003.008\n"
NO_SECURITY = 1
SET_DESKTOP_SIZE = 251  # extension of RFC 6143's list: the screen is to have this size
LIMIT_S = 30


class Sockets:
    def __init__(self, folder, names):
        """folder: where QEMU listens, at NAME.vnc for each of `names`."""
        self._folder = folder
        self._names = names

    def arguments(self, card):
        """QEMU's, for the sockets of the graphics card of that id."""
        words = []
        for head, name in enumerate(self._names):
            words += ["-vnc", f"unix:{self._folder}/{name}.vnc,id={name},display={card},head={head}"]
        return words

    def plug(self, name, size_px):
        self._ask(name, *size_px)

    def unplug(self, name):
        self._ask(name, 0, 0)

    def _ask(self, name, width, height):
        with socket.socket(socket.AF_UNIX) as line:
            line.settimeout(LIMIT_S)
            line.connect(str(self._folder / f"{name}.vnc"))
            _read(line, len(VERSION))
            line.sendall(VERSION)
            _read(line, _read(line, 1)[0])  # kinds of security
            line.sendall(bytes([NO_SECURITY]))
            _read(line, 4)  # the answer: it is fine
            line.sendall(b"\1")  # others may look, too
            said = _read(line, 24)
            _read(line, struct.unpack(">I", said[20:])[0])  # the name
            screen = struct.pack(">IHHHHI", 0, 0, 0, width, height, 0)
            line.sendall(struct.pack(">BxHHBx", SET_DESKTOP_SIZE, width, height, 1) + screen)
            time.sleep(0.3)  # to be read before the line goes


def _read(line, count):
    got = b""
    while len(got) < count:
        part = line.recv(count - len(got))
        if not part:
            raise ConnectionError("the screen's socket hung up")
        got += part
    return got
