"""What is in the guest: Debian's files as they are installed on this machine, and our program.

Everything comes from packages that .ci/packages lists; a file that is missing here is reported with
the package that has it.
"""
import os
import pathlib
import subprocess

from file_tree import FileTree

HERE = pathlib.Path(__file__).resolve().parent
LIBRARIES = "/usr/lib/x86_64-linux-gnu"

# Loaded by name when a program runs, so ldd does not know them.
MESA = ["libEGL_mesa.so.0", "libEGL.so.1", "libGLX_mesa.so.0", "libgbm.so.1", "libGL.so.1",
        "dri/swrast_dri.so"]
MESA_SAME = ["dri/kms_swrast_dri.so", "dri/virtio_gpu_dri.so"]  # the same file once more

# What udev does when an input device or a screen comes.
UDEV_RULES = ["50-udev-default", "60-drm", "60-evdev", "60-input-id", "60-persistent-input",
              "65-libwacom", "70-mouse", "70-touchpad", "80-libinput-device-groups",
              "90-libinput-fuzz-override", "64-xorg-xkb"]
UDEV_HELPERS = ["libinput-device-group", "libinput-fuzz-extract", "libinput-fuzz-to-zero"]

XORG_MODULES = "/usr/lib/xorg/modules"


def build(kernel, programs, files, target):
    """Writes the archive `target`.

    programs  {path in the guest: program of this machine}
    files     {path in the guest: text}
    """
    tree = FileTree()
    tree.add_file(HERE / "guest" / "init", "/init")
    tree.add_file("/usr/bin/busybox")
    tree.add_link("/bin/sh", "busybox")
    _add_modules(tree, kernel)
    _add_udev(tree)
    _add_graphics(tree)
    _add_fonts(tree)
    _add_xorg(tree)
    for path, program in programs.items():
        tree.add_program(program, path)
    for path, text in files.items():
        tree.add_text(path, text, 0o755 if text.startswith("#!") else 0o644)
    _add_users(tree)
    tree.write(target)


def _add_modules(tree, kernel):
    for module in kernel.modules:
        tree.add_file(module, f"/modules/{module.name}")
    tree.add_text("/modules/order", "".join(f"{m.name}\n" for m in kernel.modules))


def _add_udev(tree):
    tree.add_program("/usr/bin/udevadm")
    tree.add_link("/usr/lib/systemd/systemd-udevd", "../../bin/udevadm")
    for rule in UDEV_RULES:
        tree.add_file(f"/usr/lib/udev/rules.d/{rule}.rules")
    for helper in UDEV_HELPERS:
        tree.add_program(f"/usr/lib/udev/{helper}")
    tree.add_file("/usr/lib/udev/hwdb.bin")
    tree.add_all("/usr/share/libinput")
    tree.add_all("/usr/share/libwacom", lambda path: not path.endswith(".svg"))


def _add_graphics(tree):
    for library in MESA:
        tree.add_program(f"{LIBRARIES}/{library}")
    for driver in MESA_SAME:
        tree.add_link(f"{LIBRARIES}/{driver}", "swrast_dri.so")
    tree.add_all("/usr/share/glvnd")
    tree.add_all("/usr/share/drirc.d")


def _add_fonts(tree):
    tree.add_all("/etc/fonts")
    tree.add_all("/usr/share/fontconfig/conf.avail")
    listed = subprocess.run(["dpkg", "-L", "fonts-inter"], capture_output=True, text=True,
                            check=True).stdout
    for path in listed.splitlines():
        if path.startswith("/usr/share/fonts/") and os.path.isfile(path):
            tree.add_file(path)


def _add_xorg(tree):
    tree.add_program("/usr/lib/xorg/Xorg")
    tree.add_program("/usr/bin/xkbcomp")
    for module in ("drivers/modesetting_drv.so", "input/libinput_drv.so", "libshadow.so",
                   "libfbdevhw.so", "extensions/libglx.so", "libglamoregl.so"):
        tree.add_program(f"{XORG_MODULES}/{module}")
    tree.add_all("/usr/share/X11/xkb")
    tree.add_all("/usr/share/X11/locale")
    tree.add_all("/usr/share/X11/xorg.conf.d")
    tree.add_folder("/var/lib/xkb")
    tree.add_folder("/var/log")


def _add_users(tree):
    tree.add_text("/etc/passwd", "root:x:0:0:root:/data:/bin/sh\n")
    tree.add_text("/etc/group", "root:x:0:\ninput:x:101:\nvideo:x:44:\nrender:x:102:\ntty:x:5:\n")
