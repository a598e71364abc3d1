#!/usr/bin/env python3
"""Asks a program the same questions in several ways, and compares what it prints, byte for byte.

The questions: solve with 6, 13 and 30 digits of seeded scenes of every kind, maps of some of them, and all quantities of the scenes of the
certified vectors. The ways: with the code paths that glibc takes on this processor and with those of an older one; with 1, 2 and 4 threads;
and by other programs, such as a build by another compiler, or one for another processor under an emulator.
Usage: same_digits.py [--scenes N] [--digits 6,13,30] [--maps N] [--vectors EVERY] [--other [NAME=]COMMAND]... [--others-only]
                      [--twin] [--record FILE] PROGRAM
With --twin the digits of PROGRAM must differ, and the status says whether they do: it is one that calls the system's exp, or another
that differs from the first. With --record FILE the counts are written there, those of ways in FILE that were not asked are kept; with
--others-only that is also the program as it is.
"""
import argparse
import csv
import hashlib
import json
import os
import random
import re
import shlex
import subprocess
from pathlib import Path

HWCAPS = ("-FMA", "-AVX2", "-AVX512F", "-AVX2,-FMA,-AVX512F")
THREADS = ("1", "2", "4")
VECTORS = Path(__file__).resolve().parents[1] / "conformance" / "vectors"
FIELDS = ("way", "scenes", "runs", "bytes", "differ")


def chain(draw, N):
    """Ratios of a chain, as fractions of 64."""
    ratio = lambda: (16 + int(draw.random() * 112)) / 64
    return {"mass_ratios": [1, *(ratio() for _ in range(N - 1))], "stiffness_ratios": [1, *(ratio() for _ in range(N - 1))]}


def dashpots(draw, N):
    """A damping matrix of dashpots between neighbours, the first to the ground; it couples the modes."""
    c = [int(draw.random() * 16) / 64 for _ in range(N)]
    C = [[0.0] * N for _ in range(N)]
    for i in range(N):
        C[i][i] += c[i]
        if i > 0:
            C[i - 1][i - 1] += c[i]
            C[i - 1][i] -= c[i]
            C[i][i - 1] -= c[i]
    C[0][0] += 1 / 64
    return C


def scene(draw, kind):
    """A scene of one of eight kinds."""
    N = 1 if kind == 0 else 2 + int(draw.random() * (10 if kind == 7 else 4))
    s = chain(draw, N)
    zeta = {4: 0.5, 5: 1.0, 6: 0.0}.get(kind, 1 / 64)
    s["damping_ratios"] = [zeta + int(draw.random() * 16) / (1024 if kind not in (4, 5) else 32) for _ in range(N)]
    s["contact"] = 1 + int(draw.random() * N)
    s["load"] = 1 + int(draw.random() * N)
    if kind == 2:  # two masses rub against each other
        other = s["contact"] % N + 1
        s["contact"] = [s["contact"], other]
    if kind == 3:
        del s["damping_ratios"]
        s["damping_matrix"] = dashpots(draw, N)
    s["mu"] = 1 if draw.random() < 0.5 else 1 + int(draw.random() * 32) / 32
    s["r"] = (4 + int(draw.random() * 180)) / 64 + 1 / 1024
    s["beta"] = (1 + int(draw.random() ** 2 * 160)) / 128
    return s


def scenes(count):
    draw = random.Random(23)
    return [scene(draw, n % 8) for n in range(count)]


def scenes_of_vectors(every):
    """Every scene of the certified vectors once, of these each `every`th."""
    lines = [line for path in sorted(VECTORS.glob("*.jsonl")) for line in path.read_text().splitlines()]
    vectors = [json.loads(line) for line in lines]
    return list(dict.fromkeys(json.dumps(v["scene"]) for v in vectors if "reject" not in v))[::every]


def questions(count, digits, maps, of_vectors):
    """What is asked of every way: a name, arguments, what is read, and whether threads matter."""
    every = scenes(count)
    lines = [json.dumps(s) for s in every]
    for d in digits:
        for start in range(0, count, 500):
            part = "\n".join(lines[start:start + 500])
            yield f"solve --digits {d}, scenes {start + 1} and on", ["solve", "--json", "--digits", str(d)], part, False
    for n in range(maps):
        line = lines[n * 7 % count]
        yield f"map of scene {n * 7 % count + 1}", ["map", "--r", "0.21:2.7:12", "--beta", "0.01:1.5:12"], line, True
        yield f"boundaries of scene {n * 7 % count + 1}", ["map", "--r", "0.21:2.7:60", "--boundaries"], line, True
    if of_vectors:
        text = "\n".join(scenes_of_vectors(of_vectors))
        yield "solve --all, scenes of the vectors", ["solve", "--json", "--all"], text, False
        yield "functions, scenes of the vectors", ["functions", "--json"], text, False


def named(command):
    """NAME=COMMAND, or a command that is its own name."""
    found = re.fullmatch(r"([^=]*)=(.*)", command, re.DOTALL)
    return (found[1], found[2]) if found else (command, command)


def record(path, ways, count):
    """The counts, with those that are in the file of ways that were not asked now."""
    rows = {}
    if path.exists():
        with path.open(newline="") as file:
            rows = {row["way"]: row for row in csv.DictReader(file)}
    for way in ways:
        rows[way.name] = dict(zip(FIELDS, (way.name, count, way.runs, way.bytes, way.different)))
    with path.open("w", newline="") as file:
        writer = csv.DictWriter(file, FIELDS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows.values())


class Way:
    def __init__(self, name, command, hwcaps=None, threads=None):
        self.name, self.command, self.threads = name, command, threads
        self.environment = dict(os.environ)
        if hwcaps:
            self.environment["GLIBC_TUNABLES"] = "glibc.cpu.hwcaps=" + hwcaps
        self.runs = self.bytes = self.different = 0

    def ask(self, arguments, text, threads_matter):
        extra = ["--threads", self.threads or "1"] if threads_matter else []
        run = subprocess.run([*self.command, *arguments, *extra], input=text, capture_output=True, text=True, env=self.environment)
        if run.returncode not in (0, 3):  # 3: to some question there is no answer with the digits asked for, the same in every way
            raise SystemExit(f"{self.name}, {' '.join(arguments)}: status {run.returncode}\n{run.stderr[-1000:]}")
        self.runs += 1
        self.bytes += len(run.stdout)
        return run.returncode, run.stdout, run.stderr


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("program")
    options.add_argument("--scenes", type=int, default=2000)
    options.add_argument("--digits", default="6,13,30")
    options.add_argument("--maps", type=int, default=40)
    options.add_argument("--other", action="append", default=[])
    options.add_argument("--others-only", action="store_true")
    options.add_argument("--vectors", type=int, default=1, metavar="EVERY", help="each so manieth scene of the vectors; 0: none")
    options.add_argument("--twin", action="store_true")
    options.add_argument("--record", type=Path)
    given = options.parse_args()
    command = shlex.split(given.program)
    first = Way("as it is", command)
    ways = [Way(f"glibc.cpu.hwcaps={caps}", command, hwcaps=caps) for caps in HWCAPS]
    ways += [Way(f"{threads} threads", command, threads=threads) for threads in THREADS[1:]]
    ways = [Way(name, shlex.split(other)) for name, other in map(named, given.other)] + ([] if given.others_only else ways)
    whole = hashlib.sha256()
    for name, arguments, text, threads_matter in questions(given.scenes, given.digits.split(","), given.maps, given.vectors):
        expected = first.ask(arguments, text, threads_matter)
        whole.update(expected[1].encode())
        for way in ways:
            if way.threads and not threads_matter:
                continue
            found = way.ask(arguments, text, threads_matter)
            if found == expected:
                continue
            way.different += 1
            pairs = [(a, b) for a, b in zip(expected[1].splitlines(), found[1].splitlines()) if a != b]
            at = next((i for i, (a, b) in enumerate(zip(*pairs[0])) if a != b), 0) if pairs else 0
            shown = "\n  ".join(line[max(0, at - 60):at + 60] for line in pairs[0]) if pairs else f"{expected[2]}\n  {found[2]}"
            print(f"{way.name}: {name}: {len(pairs)} lines differ, first\n  {shown}", flush=True)
    for way in (first, *ways):
        print(f"{way.name}: {way.runs} runs, {way.bytes} bytes, {way.different} runs differ")
    print(f"sha256 of the answers: {whole.hexdigest()}")
    if given.record:
        record(given.record, ways if given.others_only else (first, *ways), given.scenes)
    differ = any(way.different for way in ways)
    raise SystemExit(not differ if given.twin else differ)


if __name__ == "__main__":
    main()
