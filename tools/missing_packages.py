"""What to say when Python lacks a package that a tool needs."""

import os
import sys


def end_without(error):
    """Ends the program with one line: which package is missing (error: the ImportError), and the remedy."""
    script = os.path.relpath(sys.argv[0]) if sys.argv[0] else "this"
    remedy = f"install numpy and matplotlib: {sys.executable} -m pip install numpy matplotlib"
    if sys.executable != "/usr/bin/python3" and os.path.exists("/usr/bin/python3"):
        remedy = f"run it with /usr/bin/python3, which has them after tools/install_packages.sh, or {remedy}"
    sys.exit(f"{os.path.basename(script)}: {sys.executable} has no {error.name}; {remedy}")
