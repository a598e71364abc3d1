"""How the cost of a sweep grows with points, masses and workers: costs.py PROGRAM. Prints the tables of docs/sweep.md."""
import json
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

PROGRAM = sys.argv[1]
SCRATCH = tempfile.TemporaryDirectory()


def study(masses, columns, rows, chunk):
    ones = [1] * masses
    return {"scene": {"mass_ratios": ones, "stiffness_ratios": ones, "damping_ratios": 0.02, "contact": 1, "load": masses},
            "axes": [{"quantity": "r", "from": 0.1, "to": 2, "count": columns}, {"quantity": "beta", "from": 0.05, "to": 1.5, "count": rows}],
            "answers": ["regime", "amplitudes", "stops"], "points_of_a_chunk": chunk}


def processor_seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def call(*arguments, text=None):
    before = processor_seconds()
    start = time.monotonic()
    done = subprocess.run([PROGRAM, *map(str, arguments)], input=text, text=True, check=True, capture_output=True)
    return processor_seconds() - before, time.monotonic() - start, done.stdout


def swept(name, of, jobs=1, workers=1):
    folder = Path(SCRATCH.name) / name
    call("sweep", "plan", "--without-estimate", "-", folder, text=json.dumps(of))
    run, wall, _ = call("sweep", "run", folder, "--all", "--jobs", jobs)
    status = json.loads(call("sweep", "status", "--json", "--workers", workers, folder)[2])
    return run, wall, status


print("| points | masses | processor microseconds a point |\n|---|---|---|")
for masses, columns, rows in ((3, 25, 20), (3, 50, 40), (3, 100, 80), (1, 50, 40), (2, 50, 40), (5, 50, 40), (8, 50, 40)):
    run, _, status = swept(f"{masses}-{columns}", study(masses, columns, rows, 10**6))
    print(f"| {status['points']} | {masses} | {1e6 * run / status['points']:.3g} |")

print("\n| workers | processor seconds | seconds |\n|---|---|---|")
large = study(3, 1200, 20, 400)
for jobs in (1, 2):
    run, wall, status = swept(f"jobs-{jobs}", large, jobs, 1000)
    print(f"| {jobs}, measured | {run:.3g} | {wall:.3g} |")
print(f"| 1000, simulated from the {status['chunks']} chunks of the last run | {status['seconds']:.3g} | {status['seconds_with_workers']:.3g} |")

print("\n| pair | processor seconds of map | of sweep |\n|---|---|---|")
grid = study(5, 120, 60, 10**6)
for pair in range(5):
    of_map = call("map", "-", "--r", "0.1:2:120", "--beta", "0.05:1.5:60", "--threads", 1, "--output", Path(SCRATCH.name) / "map.npy",
                  text=json.dumps(grid["scene"]))[0]
    print(f"| {pair + 1} | {of_map:.3f} | {swept(f'pair-{pair}', grid)[0]:.3f} |")
