"""What a sweep costs beside `map`: costs.py. Needs DENHARTOG_LIBRARY and PYTHONPATH. Prints the tables of docs/sweep.md."""
import pathlib
import resource
import subprocess
import sys
import tempfile
import time

import numpy as np
from denhartog import System, sweep

SCRATCH = tempfile.TemporaryDirectory()


def study(masses, columns, rows, chunk=10**6):
    ones = [1] * masses
    return {"scene": {"mass_ratios": ones, "stiffness_ratios": ones, "damping_ratios": 0.02, "contact": 1, "load": masses},
            "axes": [{"quantity": "r", "from": 0.1, "to": 2, "count": columns}, {"quantity": "beta", "from": 0.05, "to": 1.5, "count": rows}],
            "answers": ["regime", "amplitudes", "stops"], "points_of_a_chunk": chunk}


def swept(of):
    """Processor seconds of all chunks, in this process."""
    folder = pathlib.Path(SCRATCH.name) / str(time.monotonic())
    sweep.plan(of, folder)
    before = time.process_time()
    sweep.run(folder)
    return time.process_time() - before


def mapped(of):
    """Processor seconds of `System.map` on the same grid."""
    system, axes = System.from_scene(of["scene"]), [np.linspace(axis["from"], axis["to"], axis["count"]) for axis in of["axes"]]
    before = time.process_time()
    system.map(*axes, masses=1, threads=1)
    return time.process_time() - before


print("| points | masses | processor microseconds a point |\n|---|---|---|")
for masses, columns, rows in ((3, 25, 20), (3, 50, 40), (3, 100, 80), (1, 50, 40), (2, 50, 40), (5, 50, 40), (8, 50, 40)):
    print(f"| {columns * rows} | {masses} | {1e6 * swept(study(masses, columns, rows)) / columns / rows:.3g} |")

print("\n| workers | processor seconds | seconds |\n|---|---|---|")
for jobs in (1, 2):
    folder = pathlib.Path(SCRATCH.name) / f"jobs-{jobs}"
    sweep.plan(study(3, 4800, 20, 1600), folder)
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    subprocess.run([sys.executable, "-m", "denhartog.sweep", "run", folder, "--jobs", str(jobs)], check=True, stdout=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    used = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    print(f"| {jobs} | {used:.3g} | {time.monotonic() - start:.3g} |")

print("\n| pair | processor seconds of map | of sweep |\n|---|---|---|")
for pair in range(5):
    grid = study(5, 480, 60)
    print(f"| {pair + 1} | {mapped(grid):.3f} | {swept(grid):.3f} |")
