"""under_filter.py UNIT COMMAND...: runs the command with the system calls that the unit's lines
SystemCallFilter allow, as systemd-analyze names them. Any other one is refused with EPERM, as the
unit has it. Exit 77 means that there is no libseccomp."""

import ctypes
import ctypes.util
import os
import subprocess
import sys

REFUSE, ALLOW = 0x00050001, 0x7FFF0000  # SCMP_ACT_ERRNO(EPERM), SCMP_ACT_ALLOW


def calls_of(name):
    """Of a set, with the sets in it."""
    if not name.startswith("@"):
        return {name}
    told = subprocess.run(
        ["systemd-analyze", "syscall-filter", "--no-pager", name],
        capture_output=True,
        text=True,
        check=True,
    ).stdout
    found = set()
    for line in told.splitlines()[1:]:
        word = line.strip()
        if word and not word.startswith("#"):
            found |= calls_of(word)
    return found


def allowed_by(unit):
    allowed = calls_of("@default")
    with open(unit) as lines:
        for line in lines:
            if line.startswith("SystemCallFilter="):
                words = line.removeprefix("SystemCallFilter=").strip()
                calls = set().union(*(calls_of(word) for word in words.lstrip("~").split()))
                allowed = allowed - calls if words.startswith("~") else allowed | calls
    return allowed


allowed = allowed_by(sys.argv[1])
try:
    library = ctypes.CDLL("libseccomp.so.2")
except OSError:
    sys.exit(77)
library.seccomp_init.restype = ctypes.c_void_p
library.seccomp_rule_add.argtypes = [ctypes.c_void_p, ctypes.c_uint32, ctypes.c_int, ctypes.c_uint]
library.seccomp_load.argtypes = [ctypes.c_void_p]
filter_ = library.seccomp_init(REFUSE)
for name in sorted(allowed):
    number = library.seccomp_syscall_resolve_name(name.encode())
    if number >= 0:
        library.seccomp_rule_add(filter_, ALLOW, number, 0)
if library.seccomp_load(filter_) != 0:
    sys.exit("the filter cannot be loaded")
os.execvp(sys.argv[2], sys.argv[2:])
