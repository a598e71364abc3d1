"""python3 -m pages write|finish --NAME FOLDER...: the generated pages of the site, from what a run left. Exit status: 0 done; 1
something is wrong, a sentence each on standard error; 2 usage."""
import argparse
import subprocess
import sys
from pathlib import Path

from .finish import finish
from .site import write
from .text import Fault


def main():
    parser = argparse.ArgumentParser(prog="pages", description="The generated pages of the annotated reference")
    commands = parser.add_subparsers(required=True)
    for command, told, options in ((write, "write the pages from what a run wrote", ("run", "source", "output")),
                                   (finish, "finish the site, and follow every link", ("site", "tagfile", "source"))):
        subparser = commands.add_parser(command.__name__, help=told)
        subparser.set_defaults(command=command)
        for option in options:
            subparser.add_argument(f"--{option}", type=Path, required=True)
    asked = vars(parser.parse_args())
    try:
        done, faults = asked.pop("command")(**asked)
    except (Fault, OSError, subprocess.CalledProcessError) as fault:
        done, faults = "", [str(fault)]
    for fault in faults:
        print(f"pages: {fault}", file=sys.stderr)
    print(done, end="\n" if done else "")
    return 1 if faults else 0


sys.exit(main())
