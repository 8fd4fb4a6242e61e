"""What to do when Python lacks a package that a tool needs."""

import os
import sys

SYSTEM = "/usr/bin/python3"  # for which tools/install_packages.sh installs


def end_without(error, group="", packages="numpy matplotlib"):
    """Starts the tool again with the system's Python where that is another one than this; otherwise ends it with one line:
    which package is missing (error: the ImportError), and the remedy: the group of tools/install_packages.sh, or packages
    for pip."""
    script = sys.argv[0]
    if os.path.isfile(script) and os.path.exists(SYSTEM) and os.path.realpath(sys.executable) != os.path.realpath(SYSTEM):
        sys.stdout.flush()
        os.execv(SYSTEM, [SYSTEM, *sys.argv])
    sys.exit(f"{os.path.basename(script) or 'this'}: {sys.executable} has no {error.name}; install it: "
             f"{' '.join(['sh tools/install_packages.sh', *group.split()])}, or {sys.executable} -m pip install {packages}")
