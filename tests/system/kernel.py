"""Debian's own kernel: its package fetched once, its image, and the modules that the machine needs.

Nothing is installed: the package is downloaded into a folder and unpacked there.
"""
import pathlib
import re
import shutil
import subprocess

META_PACKAGE = "linux-image-amd64"

# What the emulated machine has and the tests need; what these need in turn is found out.
MODULES = [
    "virtio_pci", "virtio_gpu",  # the bus and the screen
    "virtio_blk", "crc32c_generic", "ext4",  # the disk that outlives the machine
    "virtio_console",  # orders from outside
    "evdev", "uinput",  # devices that programs make
]


class NoKernel(Exception):
    """Debian's kernel can't be had here; the message says why."""


class Kernel:
    """`image`: the kernel's file; `modules`: module files, each after those that it needs."""

    def __init__(self, image, modules):
        self.image = image
        self.modules = modules


def fetch(folder):
    """The kernel under `folder`, downloaded if it is not there yet. Raises NoKernel."""
    folder.mkdir(parents=True, exist_ok=True)
    package = next(iter(sorted(folder.glob("linux-image-*.deb"))), None) or _download(folder)
    unpacked = folder / package.stem
    if not unpacked.exists():
        _unpack(package, unpacked)
    image = next((unpacked / "boot").glob("vmlinuz-*"))
    return Kernel(image, _in_order(unpacked / "lib" / "modules"))


def _download(folder):
    for command in (None, ["apt-get", "update", "-qq"]):
        if command:
            subprocess.run(command, capture_output=True, timeout=300, check=False)
        name = _package_name()
        if not name:
            continue
        got = subprocess.run(["apt-get", "download", "-qq", name], cwd=folder, timeout=300,
                             capture_output=True, text=True, check=False)
        packages = sorted(folder.glob(f"{name}_*.deb"))
        if got.returncode == 0 and packages:
            return packages[0]
    raise NoKernel(f"apt-get could not download {name or META_PACKAGE}: is the network there?")


def _package_name():
    """The package of the kernel that the meta package stands for, as apt knows it now."""
    told = subprocess.run(["apt-cache", "depends", META_PACKAGE], capture_output=True, text=True,
                          check=False).stdout
    found = re.search(r"Depends: (linux-image-\S+)", told)
    return found.group(1) if found else None


def _unpack(package, folder):
    """Only whole: under another name first."""
    half = folder.with_name(folder.name + ".half")
    shutil.rmtree(half, ignore_errors=True)
    subprocess.run(["dpkg-deb", "-x", package, half], timeout=300, check=True)
    half.rename(folder)


def _in_order(folder):
    files = {_module_name(path): path for path in folder.rglob("*.ko")}
    order = []
    for module in MODULES:
        _add(module, files, order)
    return order


def _add(module, files, order):
    path = files.get(module)
    if path is None:
        raise NoKernel(f"the kernel's package has no module {module}")
    if path in order:
        return
    for needed in _depends(path):
        _add(needed, files, order)
    order.append(path)


def _module_name(path):
    return path.stem.replace("-", "_")


def _depends(path):
    found = re.search(rb"\0depends=([^\0]*)\0", pathlib.Path(path).read_bytes())
    names = found.group(1).decode() if found else ""
    return [name.replace("-", "_") for name in names.split(",") if name]
