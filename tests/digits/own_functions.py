#!/usr/bin/env python3
"""Whether a program or library calls an elementary function of the system, whose digits differ from machine to machine.

What IEEE 754 rounds exactly (sqrt, fma, remainder, floor and the like) may be called. Usage: own_functions.py NM FILE...
"""
import re
import subprocess
import sys

# Functions of libm that are not rounded correctly, for each type, and those of complex numbers; what vectors and -ffast-math make
# of them; and quotients of complex numbers, which libgcc computes with fused products where the processor has them.
INEXACT = re.compile(
    r"_*(ZGV\w+_)?(a?(sin|cos|tan)h?|atan2|sincos|(sin|cos|tan|asin|acos|atan|atan2)pi|exp|exp2|exp10|expm1|pow10|log|log2|log10|log1p|pow|cbrt"
    r"|hypot|erfc?|[lt]?gamma|j[01n]|y[01n]|c(abs|arg|exp|log|log10|pow|sqrt|a?(sin|cos|tan)h?))(f|l|f32|f64|f128)?(_r|_finite)?$"
    r"|__(mul|div)[sdxtk]c3$")


def called(nm, file):
    """Names that a file leaves to other libraries, without their version."""
    command = [nm, "--undefined-only", "--format=posix"]
    lines = subprocess.run([*command, file], capture_output=True, text=True, check=True).stdout.splitlines()
    if not any(" U" in line for line in lines):
        lines = subprocess.run([*command, "--dynamic", file], capture_output=True, text=True, check=True).stdout.splitlines()
    return {line.split()[0].split("@")[0] for line in lines if " U" in line}


def main():
    if len(sys.argv) < 3:
        raise SystemExit(__doc__)
    faults = 0
    for file in sys.argv[2:]:
        names = called(sys.argv[1], file)
        inexact = sorted(name for name in names if INEXACT.match(name))
        if len(names) < 10:
            raise SystemExit(f"{file}: only {len(names)} names are left to other libraries: it was not read rightly")
        faults += len(inexact)
        print(f"{file}: {', '.join(inexact) if inexact else 'no function whose digits differ from machine to machine'}")
    raise SystemExit(faults > 0)


if __name__ == "__main__":
    main()
