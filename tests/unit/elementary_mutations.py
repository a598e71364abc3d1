"""Changes each coefficient, table entry or constant of the elementary functions, one at a time, and has their tests find it.

Of the tables, which the tests compare with MPFR entry by entry, every 97th entry is changed. Some changes nobody can find: a constant that
only chooses the nearest multiple may be a neighbour, and the last term of a series is below the 57 bits that are promised. They are
listed; the status is 1 where more than one change in five is not found.
Usage: elementary_mutations.py COMPILER SOURCES TEMPORARY_FOLDER
"""
import re
import shutil
import subprocess
import sys
from pathlib import Path

COEFFICIENT = re.compile(r"1\.0 / ([0-9]+)")
ENTRY = re.compile(r"0x1\.[0-9a-f]{13}p")


def mutants(folder):
    """File, text, and what is changed in it."""
    for name in ("elementary_kernels.hpp", "elementary_exponential.cpp", "elementary_angle.cpp"):
        text = (folder / name).read_text()
        for found in COEFFICIENT.finditer(text):
            changed = f"1.0 / ({found[1]} * 1.5)"
            line = text.count("\n", 0, found.start()) + 1
            yield name, text[:found.start()] + changed + text[found.end():], f"{name}:{line}: {found[0]} is {changed}"
    for name in ("circle_tables.hpp", "power_tables.hpp"):
        text = (folder / name).read_text()
        for number, found in enumerate(ENTRY.finditer(text)):
            if number > 8 and number % 97 != 0:
                continue
            last = found.end() - 2
            changed = text[:last] + format(int(text[last], 16) ^ 1, "x") + text[last + 1:]
            yield name, changed, f"{name}: the last digit of entry {number}, {found[0]}..."


def main():
    compiler, sources, temporary = sys.argv[1], Path(sys.argv[2]), Path(sys.argv[3])
    shutil.rmtree(temporary, ignore_errors=True)
    mutated = temporary / "denhartog" / "number"
    shutil.copytree(sources / "src" / "denhartog" / "number", mutated)
    options = [compiler, "-std=c++20", "-O1", "-ffp-contract=off", f"-I{temporary}", f"-I{sources}"]
    program = temporary / "tests"

    def compiled(source, name):
        subprocess.run([*options, "-c", source, "-o", temporary / name], check=True)

    def passes():
        for name in ("elementary_exponential", "elementary_angle"):
            compiled(mutated / f"{name}.cpp", f"{name}.o")
        compiled(sources / "tests" / "unit" / "elementary.cpp", "elementary.o")
        objects = [temporary / f"{name}.o" for name in ("main", "elementary", "elementary_exponential", "elementary_angle")]
        subprocess.run([compiler, *objects, "-lmpfr", "-lgmp", "-o", program], check=True)
        return subprocess.run([program, "--abort"], stdout=subprocess.DEVNULL).returncode == 0

    compiled(sources / "tests" / "main.cpp", "main.o")
    if not passes():
        raise SystemExit("the tests fail without a change")
    tried, missed = 0, []
    for name, text, what in mutants(mutated):
        original = (mutated / name).read_text()
        (mutated / name).write_text(text)
        tried += 1
        if passes():
            missed.append(what)
            print("not found: " + what, flush=True)
        (mutated / name).write_text(original)
    print(f"{tried} changes, {tried - len(missed)} found")
    raise SystemExit(1 if 5 * len(missed) > tried or tried < 40 else 0)


if __name__ == "__main__":
    main()
