#!/usr/bin/env python3
"""Runs the commands of a page of documentation and writes, or checks, what they print.

A command stands in a comment, what it prints in the fence after it:

    <!-- run: build/verify/bin/denhartog conform list --summary -->
    ```
    ...
    ```

The fence starts with the command itself after a dollar sign and shows its standard output. Commands run in the folder of the
sources; an exit status that is not zero stands in a last line. With --check nothing is written: words have to be the same, decimal
numbers nearly so, as their last digits differ from machine to machine; errors at the level of rounding have to be there, and
numbers of digits that agree, with their one decimal, to one digit.
"""
import argparse
import importlib.util
import os
import pathlib
import re
import subprocess
import sys

BLOCK = re.compile(r"(<!-- run: (?P<command>.*?) -->\n```[a-z]*\n)(?P<shown>.*?)(?P<end>^```$)", re.S | re.M)
NUMBER = re.compile(r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?")
HEXADECIMAL = re.compile(r"-?0x[\da-f.]+p[-+]\d+")
DIGITS = re.compile(r"\d\d?\.\d")
ROUNDING = 1e-9


def printed(command, source, programs):
    """What a command prints, as a page shows it."""
    own = {**os.environ, "PATH": os.path.dirname(sys.executable) + os.pathsep + os.environ.get("PATH", "")}  # python3 is this one
    run = subprocess.run(["bash", "-c", command.replace("build/verify/bin", str(programs))], cwd=source, env=own, text=True,
                         stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, stdin=subprocess.DEVNULL, timeout=300, check=False)
    lines = [line.rstrip() for line in run.stdout.replace(str(programs), "build/verify/bin").splitlines()]
    if run.returncode:
        lines.append(f"(exit status {run.returncode})")
    return "\n".join([f"$ {command}", *lines]) + "\n"


def near(a, b):
    """Whether two numbers of an output are the same but for their last digits."""
    if "." not in a + b and "e" not in a + b:
        return a == b
    x, y = float(a), float(b)
    if DIGITS.fullmatch(a) and DIGITS.fullmatch(b) and abs(x - y) <= 1:
        return True
    return abs(x) < ROUNDING and abs(y) < ROUNDING or abs(x - y) <= 0.05 * max(abs(x), abs(y))


def agree(shown, found):
    """Whether an output says the same as another."""
    texts = [HEXADECIMAL.sub("0x", text) for text in (shown, found)]
    words = [NUMBER.sub("#", text).split() for text in texts]
    numbers = [NUMBER.findall(text) for text in texts]
    return words[0] == words[1] and all(map(near, *numbers))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("pages", nargs="+", type=pathlib.Path)
    parser.add_argument("--programs", required=True, type=pathlib.Path, help="folder of the built programs")
    parser.add_argument("--check", action="store_true", help="write nothing; status 1 where a page is out of date")
    options = parser.parse_args()
    if importlib.util.find_spec("numpy") is None:
        parser.error(f"the adapters that the pages run need numpy, which {sys.executable} has not; take a python3 that has it")
    source = pathlib.Path(__file__).resolve().parents[2]
    programs = options.programs.resolve()
    faults = commands = 0
    for page in options.pages:
        text = page.read_text(encoding="utf-8")
        pieces, last = [], 0
        for block in BLOCK.finditer(text):
            commands += 1
            found = printed(block["command"], source, programs)
            if options.check and not agree(block["shown"], found):
                faults += 1
                print(f"{page}: out of date\n--- shown\n{block['shown']}--- found\n{found}", file=sys.stderr)
            pieces += [text[last:block.start()], block[1], found, block["end"]]
            last = block.end()
        if not options.check:
            page.write_text("".join([*pieces, text[last:]]), encoding="utf-8")
    print(f"{commands} commands of {len(options.pages)} pages, {faults} out of date")
    return 1 if faults or not commands else 0


if __name__ == "__main__":
    sys.exit(main())
