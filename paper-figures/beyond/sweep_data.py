"""Takes the data of a picture out of the results of a sweep: sweep_data.py STORE, with the name of the picture it is for.

    python3 sweep_data.py share.zarr stick_slip_share >stick_slip_share.dat
    python3 sweep_data.py best.zarr best_friction >best_friction.dat

Needs python3-xarray and python3-zarr.
"""
import sys

import xarray


def table(values):
    """A matrix with the values of its axes, as gnuplot's `nonuniform matrix` has it."""
    rows, columns = (values[name].values for name in values.dims)
    print(len(columns), *(f"{x:.4g}" for x in columns))
    for x, line in zip(rows, values.values):
        print(f"{x:.4g}", *(f"{value:.4g}" for value in line))
    print("\n")


def stick_slip_share(data):
    print("# share of stick-slip: a row a frequency ratio, a column a friction ratio; samples:", data.sizes["sample"])
    table(data.share.sel(regime_class=1))
    for wanted in (0.5, 1.5):
        band = data.band.sel(beta=wanted, method="nearest")
        print(f"# beta {float(band.beta):.4g}: r, quantiles {data.band_probability.values} of the amplitude")
        for x, quantiles in zip(data.r.values, band.values):
            print(f"{x:.4g}", *(f"{value:.5g}" for value in quantiles))
        print("\n")


def best_friction(data):
    print("# the best friction ratio: a row a second stiffness, a column a third one")
    table(data.best_beta)
    print("# the peak there")
    table(data.best)


if len(sys.argv) != 3 or sys.argv[2] not in ("stick_slip_share", "best_friction"):
    sys.exit(__doc__)
globals()[sys.argv[2]](xarray.open_zarr(sys.argv[1]))
