#!/usr/bin/env python3
"""Builds the elementary functions with every compiler that is here, and compares the bits of what they give.

The ways: GCC and Clang, with and without optimisation, and for the processor at hand, whose fused products and wide vectors a compiler may
then take; without fused products; the code paths that glibc takes on an older processor; and, where qemu is installed, under an emulator:
a processor that has no fused products, and 64-bit Arm. Two twins must be found out: products that the compiler may fuse, where the processor can, and the system's exponential.
Usage: compilers.py [--record FILE] FOLDER COMPILER; FOLDER takes the programs, COMPILER is the first.
"""
import argparse
import csv
import os
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SOURCES = [ROOT / "tests/elementary/programs/functions.cpp",
           *(ROOT / f"src/{name}.cpp" for name in ("elementary/angle", "elementary/exponential", "denhartog/model/product_of_doubles"))]
COMMON = ["-std=c++20", f"-I{ROOT / 'src'}", f"-I{ROOT}"]
TABLES = ROOT / "src/elementary/make_tables.py"
SYSTEM_EXP = [ROOT / "tests/digits/system_exp.cpp", "-Wl,--wrap=_ZN9denhartog10elementary3expEd"]
OLDER = {"GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX2,-FMA,-AVX512F"}


def version(compiler):
    return subprocess.run([compiler, "--version"], capture_output=True, text=True, check=True).stdout.splitlines()[0]


def emulator_of(processor):
    return shutil.which(f"qemu-{processor}") or shutil.which(f"qemu-{processor}-static")


def processor_has_fma():
    try:
        return " fma " in Path("/proc/cpuinfo").read_text()
    except OSError:
        return False


class Programs:
    def __init__(self, folder):
        self.folder = folder
        self.made = 0
        subprocess.run([sys.executable, TABLES, folder / "include/elementary"], check=True)

    def make(self, compiler, options):
        self.made += 1
        program = self.folder / f"functions-{self.made}"
        subprocess.run([compiler, *COMMON, f"-I{self.folder / 'include'}", *options, *SOURCES, "-o", program], check=True)
        return [program]


def lines_of(command, environment=None):
    run = subprocess.run(command, capture_output=True, text=True, check=True, env={**os.environ, **(environment or {})})
    rows = list(csv.DictReader(run.stdout.splitlines()))
    if len(rows) < 15:
        raise SystemExit(f"{command}: only {len(rows)} functions")
    return {row["function"]: (int(row["values"]), row["bits"]) for row in rows}


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--record", type=Path)
    options.add_argument("folder", type=Path)
    options.add_argument("compiler")
    given = options.parse_args()
    given.folder.mkdir(parents=True, exist_ok=True)
    programs = Programs(given.folder)
    strict = "-ffp-contract=off"
    first = programs.make(given.compiler, ["-O2", strict])
    expected = lines_of(first)
    rows, faults = [], 0

    def compare(name, found, is_twin=False):
        nonlocal faults
        differ = [f for f in expected if found.get(f) != expected[f]]
        wrong = not differ if is_twin else bool(differ)
        faults += wrong
        rows.append({"way": name, "functions": len(expected), "values": sum(n for n, _ in found.values()),
                     "differ": len(differ), "must": "differ" if is_twin else "not differ"})
        print(f"{'WRONG ' if wrong else ''}{name}: {len(differ)} of {len(expected)} functions differ{': ' if differ else ''}{', '.join(differ)}", flush=True)

    compare(f"{version(given.compiler)}, -O2", expected)
    compare("the same, glibc's code paths of an older processor", lines_of(first, OLDER))
    compare("the same, -O0", lines_of(programs.make(given.compiler, ["-O0", strict])))
    native = ["-O3", "-march=native", strict]
    compare("the same, -O3 -march=native", lines_of(programs.make(given.compiler, native)))
    compare("the same, -O2, without fused products", lines_of(programs.make(given.compiler, ["-O2", strict, "-DDENHARTOG_WITHOUT_FUSED_PRODUCT"])))
    older = emulator_of("x86_64")
    if older:
        compare("the same, -O2, under qemu-x86_64 -cpu Nehalem",
                lines_of([older, "-cpu", "Nehalem", *programs.make(given.compiler, ["-O2", "-static", strict])]))
    clang = shutil.which("clang++")
    if clang:
        compare(f"{version(clang)}, -O2", lines_of(programs.make(clang, ["-O2", strict])))
        compare("the same, -O3 -march=native", lines_of(programs.make(clang, native)))
    else:
        print("no clang++: not compared")
    arm, emulator = shutil.which("aarch64-linux-gnu-g++"), emulator_of("aarch64")
    if arm and emulator:
        compare(f"{version(arm)}, -O2, under {Path(emulator).name}",
                lines_of([emulator, *programs.make(arm, ["-O2", "-static", strict])]))
    else:
        print("no aarch64-linux-gnu-g++ or no qemu-aarch64: 64-bit Arm is not compared")
    if processor_has_fma():
        compare("twin: products may be fused, -mfma -ffp-contract=fast",
                lines_of(programs.make(given.compiler, ["-O2", "-mfma", "-ffp-contract=fast"])), True)
    twin = programs.make(given.compiler, ["-O2", strict, *SYSTEM_EXP])
    compare("twin: the system's exp", lines_of(twin), True)
    if given.record:
        with given.record.open("w", newline="") as file:
            writer = csv.DictWriter(file, ["way", "functions", "values", "differ", "must"], lineterminator="\n")
            writer.writeheader()
            writer.writerows(rows)
    sys.exit(faults > 0)


if __name__ == "__main__":
    main()
