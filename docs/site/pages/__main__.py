"""The generated pages of the site, from what a run left. Exit status: 0 done; 1 something is wrong, a sentence each on standard
error; 2 usage."""
import argparse
import subprocess
import sys
from pathlib import Path

from .finish import finish
from .site import write
from .text import Fault

commands = {"write": write, "finish": finish}
parser = argparse.ArgumentParser(prog="pages", description=__doc__)
parser.add_argument("command", choices=commands)
parser.add_argument("paths", nargs=3, type=Path, metavar="PATH", help="write RUN SOURCE OUTPUT: the pages for Doxygen; "
                                                      "finish SITE TAGFILE SOURCE: what Doxygen made of them")
asked = parser.parse_args()
try:
    done, faults = commands[asked.command](*asked.paths)
except (Fault, OSError, subprocess.CalledProcessError) as fault:
    done, faults = "", [str(fault)]
for fault in faults:
    print(f"pages: {fault}", file=sys.stderr)
print(done, end="\n" if done else "")
sys.exit(1 if faults else 0)
