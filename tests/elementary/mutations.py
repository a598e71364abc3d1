"""Changes each coefficient, table entry or constant of the elementary functions, one at a time, and has their tests find it.

Of the tables, which the tests compare with MPFR entry by entry, every 97th entry is changed. Some changes nobody can find, and they are
listed with the reason; the status is 1 where another one is not found, and where one of these is found.
Usage: mutations.py COMPILER SOURCES TEMPORARY_FOLDER [EVERY], which takes one change in so many
"""
import re
import shutil
import subprocess
import sys
from pathlib import Path

COEFFICIENT = re.compile(r"1\.0 / ([0-9]+)")
ENTRY = re.compile(r"0x1\.[0-9a-f]{13}p")

# What no test can find. A constant that only chooses the nearest multiple may be its neighbour: then the reduced argument is a
# little larger than half a step, and the series still has its digits. The last terms of a series, and the last parts of a
# constant in two or three parts, are below the 57 bits that are promised.
CHOOSES = "it only chooses the nearest multiple"
BELOW = "it is below the bits that are promised"
UNSEEN = {
    ("kernels.hpp", "1.0 / 40320"): BELOW,
    ("circle_tables.hpp", "entry 2"): CHOOSES,
    ("circle_tables.hpp", "entry 4"): BELOW,
    ("circle_tables.hpp", "entry 8"): BELOW,
    ("power_tables.hpp", "entry 0"): CHOOSES,
    ("power_tables.hpp", "entry 2"): BELOW,
    ("power_tables.hpp", "entry 3"): BELOW,
    ("logarithm_tables.hpp", "entry 1"): BELOW,
    ("logarithm_tables.hpp", "entry 3"): BELOW,
}


def mutants(folder):
    """File, text, what is changed in it, and how that is told."""
    for name in ("kernels.hpp", "exponential.cpp", "angle.cpp"):
        text = (folder / name).read_text()
        for found in COEFFICIENT.finditer(text):
            changed = f"1.0 / ({found[1]} * 1.5)"
            line = text.count("\n", 0, found.start()) + 1
            yield name, text[:found.start()] + changed + text[found.end():], found[0], f"{name}:{line}: {found[0]} is {changed}"
    for name in ("angle_tables.hpp", "circle_tables.hpp", "logarithm_tables.hpp", "power_tables.hpp"):
        text = (folder / name).read_text()
        for number, found in enumerate(ENTRY.finditer(text)):
            if number > 8 and number % 97 != 0:
                continue
            last = found.end() - 2
            changed = text[:last] + format(int(text[last], 16) ^ 1, "x") + text[last + 1:]
            yield name, changed, f"entry {number}", f"{name}: the last digit of entry {number}, {found[0]}..."


def main():
    compiler, sources, temporary = sys.argv[1], Path(sys.argv[2]), Path(sys.argv[3])
    every = int(sys.argv[4]) if len(sys.argv) > 4 else 1
    shutil.rmtree(temporary, ignore_errors=True)
    mutated = temporary / "elementary"
    shutil.copytree(sources / "src" / "elementary", mutated)
    subprocess.run([sys.executable, mutated / "make_tables.py", mutated], check=True)
    options = [compiler, "-std=c++20", "-O1", "-ffp-contract=off", f"-I{temporary}", f"-I{sources / 'src'}", f"-I{sources}"]
    program = temporary / "tests"

    parts = {"main": sources / "tests" / "main.cpp", "elementary": sources / "tests" / "elementary" / "elementary.cpp"}
    parts |= {name: mutated / f"{name}.cpp" for name in ("exponential", "angle")}
    read = {name: subprocess.run([*options, "-MM", source], check=True, capture_output=True, text=True).stdout.split()
            for name, source in parts.items()}

    def compiled(name, folder):
        subprocess.run([*options, "-c", parts[name], "-o", folder / f"{name}.o"], check=True)
        return folder / f"{name}.o"

    def passes(objects):
        subprocess.run([compiler, *objects, "-lmpfr", "-lgmp", "-o", program], check=True)
        return subprocess.run([program, "--abort"], stdout=subprocess.DEVNULL).returncode == 0

    as_they_are = {name: compiled(name, temporary) for name in parts}
    if not passes(as_they_are.values()):
        raise SystemExit("the tests fail without a change")
    (temporary / "changed").mkdir()
    tried, wrong = 0, 0
    for name, text, what, told in list(mutants(mutated))[::every]:
        original = (mutated / name).read_text()
        (mutated / name).write_text(text)
        changed = {part: compiled(part, temporary / "changed") for part in parts if str(mutated / name) in read[part]}
        if not changed:
            raise SystemExit(f"{name} is not read by what is tested")
        found = not passes({**as_they_are, **changed}.values())
        (mutated / name).write_text(original)
        tried += 1
        reason = UNSEEN.get((name, what))
        if found and reason:
            wrong += 1
            print(f"found, though listed as one that nobody can find: {told}", flush=True)
        elif not found:
            wrong += not reason
            print(f"not found{': ' + reason if reason else ''}: {told}", flush=True)
    print(f"{tried} changes, {wrong} of them not as expected")
    raise SystemExit(1 if wrong or tried * every < 60 else 0)


if __name__ == "__main__":
    main()
