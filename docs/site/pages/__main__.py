"""python3 -m pages write|link|finish: the generated pages of the site, from what a run left. Exit status: 0 done; 1 something is
wrong, a sentence each on standard error; 2 usage."""
import argparse
import subprocess
import sys
from pathlib import Path

from .text import Fault


def main():
    parser = argparse.ArgumentParser(prog="pages", description="The generated pages of the annotated reference")
    commands = parser.add_subparsers(dest="command", required=True)
    for name, told, options in (("write", "write the pages from what a run wrote", ("run", "source", "output")),
                                ("link", "resolve links to sources and pages", ("site", "tagfile", "source")),
                                ("finish", "finish the linked site, and follow every link", ("site",))):
        command = commands.add_parser(name, help=told)
        for option in options:
            command.add_argument(f"--{option}", type=Path, required=True)
    asked = vars(parser.parse_args())
    command = asked.pop("command")
    try:
        if command == "write":
            from .site import write
            done, faults = write(asked["run"], asked["source"], asked["output"])
        else:
            from . import finish
            done, faults = getattr(finish, command)(**asked)
    except (Fault, OSError, subprocess.CalledProcessError) as fault:
        done, faults = "", [str(fault)]
    for fault in faults:
        print(f"pages: {fault}", file=sys.stderr)
    print(done, end="\n" if done else "")
    return 1 if faults else 0


sys.exit(main())
