"""Lines over a Unix socket, each waited for with a limit."""
import socket
import time


class LineSocket:
    """Raises TimeoutError when a limit passes, ConnectionError when the other end is gone."""

    def __init__(self, path, limit, alive):
        """Connects as soon as someone listens; `alive()` raises when nobody ever will."""
        self._read = b""
        while True:
            self._socket = socket.socket(socket.AF_UNIX)
            try:
                self._socket.connect(str(path))
                return
            except OSError:
                self._socket.close()
                alive()
                if time.monotonic() > limit:
                    raise TimeoutError(f"nobody listens on {path.name}") from None
                time.sleep(0.1)

    def send(self, line):
        self._socket.settimeout(30)
        self._socket.sendall(line.encode() + b"\n")

    def line(self, limit):
        """The next line, without its end; `limit` is on time.monotonic()'s clock."""
        while b"\n" not in self._read:
            self._socket.settimeout(max(0.01, limit - time.monotonic()))
            got = self._socket.recv(1 << 20)
            if not got:
                raise ConnectionError("hung up")
            self._read += got
        line, _, self._read = self._read.partition(b"\n")
        return line.decode()

    def close(self):
        self._socket.close()
