"""The guest's first file system: files of this machine and texts of ours, written as a cpio archive.

What the kernel unpacks as its root is an archive in cpio's "newc" form, uncompressed, because
unpacking under emulation costs more than reading. Paths are merged as in Debian's /usr: /lib/x
becomes /usr/lib/x, so that a library that two names lead to is there once.
"""
import os
import re
import stat
import subprocess

MERGED = ("bin", "sbin", "lib", "lib64")


class FileTree:
    """Absolute path -> (mode, content); folders come by themselves."""

    def __init__(self):
        self._entries = {}
        for name in MERGED:
            self.add_link(f"/{name}", f"usr/{name}")

    def add_text(self, path, text, mode=0o644):
        self._put(path, stat.S_IFREG | mode, text.encode())

    def add_link(self, path, target):
        self._put(path, stat.S_IFLNK | 0o777, target.encode())

    def add_folder(self, path):
        self._put(path, stat.S_IFDIR | 0o755, b"")

    def add_file(self, source, path=None):
        """A file of this machine under its own path, or under `path`."""
        path = path or source
        if self._normal(path) in self._entries:
            return
        with open(source, "rb") as file:
            content = file.read()
        executable = 0o111 if os.access(source, os.X_OK) else 0
        self._put(path, stat.S_IFREG | 0o644 | executable, content)

    def add_program(self, source, path=None):
        """A program or library, and all that it is linked with."""
        self.add_file(source, path)
        for library in linked_libraries(source):
            self.add_file(library)

    def add_all(self, folder, keep=lambda path: True):
        """Every file and link under a folder of this machine whose path `keep` accepts."""
        for root, _, names in os.walk(folder):
            for name in sorted(names):
                source = os.path.join(root, name)
                if not keep(source):
                    continue
                if os.path.islink(source):
                    self.add_link(source, os.readlink(source))
                elif os.path.isfile(source):
                    self.add_file(source)

    def write(self, path):
        """As a newc archive that is the same for the same content."""
        with open(path, "wb") as archive:
            for number, name in enumerate(sorted(self._entries), 1):
                mode, content = self._entries[name]
                _write_entry(archive, number, name.lstrip("/"), mode, content)
            _write_entry(archive, 0, "TRAILER!!!", 0, b"")

    def _put(self, path, mode, content):
        path = self._normal(path)
        folder = os.path.dirname(path)
        if folder != "/" and folder not in self._entries:
            self.add_folder(folder)
        self._entries[path] = (mode, content)

    @staticmethod
    def _normal(path):
        path = os.path.normpath(path)
        first, _, rest = path.lstrip("/").partition("/")
        return f"/usr{path}" if first in MERGED and rest else path


def linked_libraries(program):
    """What the dynamic linker would load for it, without the kernel's own."""
    listed = subprocess.run(["ldd", program], capture_output=True, text=True, check=False).stdout
    missing = re.search(r"(\S+) => not found", listed)
    if missing:
        raise FileNotFoundError(f"{program} needs {missing.group(1)}, which is not installed")
    return re.findall(r"(/\S+)", listed)


def _write_entry(archive, number, name, mode, content):
    """One file: a header of 8-digit fields, the name, the content; each padded to 4 bytes."""
    encoded = name.encode() + b"\0"
    fields = [number, mode, 0, 0, 1, 0, len(content), 0, 0, 0, 0, len(encoded), 0]
    header = b"070701" + b"".join(b"%08X" % field for field in fields)
    archive.write(header + encoded + b"\0" * (-(len(header) + len(encoded)) % 4))
    archive.write(content + b"\0" * (-len(content) % 4))
