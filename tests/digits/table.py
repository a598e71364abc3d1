#!/usr/bin/env python3
"""Prints a table of counts that `compilers.py --record` or `same_digits.py --record` wrote. Usage: table.py FILE"""
import csv
import sys


def main():
    if len(sys.argv) != 2:
        raise SystemExit(__doc__)
    with open(sys.argv[1], newline="") as file:
        rows = list(csv.reader(file))
    widths = [max(map(len, column)) for column in zip(*rows)]
    for row in rows:
        print("  ".join([row[0].ljust(widths[0]), *(cell.rjust(width) for cell, width in zip(row[1:], widths[1:]))]).rstrip())


if __name__ == "__main__":
    main()
