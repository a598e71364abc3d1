"""Takes the data of a picture out of the results of a sweep: sweep_data.py STORE, with the name of the picture it is for.

    python3 sweep_data.py share/result.zarr stick_slip_share >stick_slip_share.dat
    python3 sweep_data.py best/result.zarr best_friction >best_friction.dat

Needs python3-zarr.
"""
import sys

import numpy
import zarr


def table(rows, columns, values):
    """A matrix with the values of its axes, as gnuplot's `nonuniform matrix` has it."""
    print(len(columns), *(f"{x:.4g}" for x in columns))
    for x, line in zip(rows, values):
        print(f"{x:.4g}", *(f"{value:.4g}" for value in line))
    print("\n")


def stick_slip_share(store):
    share, r, beta = store["share"][:], store["r"][:], store["beta"][:]
    print("# share of stick-slip: a row a frequency ratio, a column a friction ratio; samples:", len(store["sample"]))
    table(r, beta, share[:, :, 1])
    for wanted in (0.5, 1.5):
        n = numpy.abs(beta - wanted).argmin()
        print(f"# beta {beta[n]:.4g}: r, quantiles {store['band_probability'][:]} of the amplitude")
        for x, band in zip(r, store["band"][:, n]):
            print(f"{x:.4g}", *(f"{value:.5g}" for value in band))
        print("\n")


def best_friction(store):
    second, third = store["stiffness_2"][:], store["stiffness_3"][:]
    print("# the best friction ratio: a row a second stiffness, a column a third one")
    table(second, third, store["best_beta"][:])
    print("# the peak there")
    table(second, third, store["best"][:])


if len(sys.argv) != 3 or sys.argv[2] not in ("stick_slip_share", "best_friction"):
    sys.exit(__doc__)
globals()[sys.argv[2]](zarr.open(sys.argv[1], "r"))
