"""Asks two programs the same questions about the scenes of the certified vectors, and compares what they print, byte for byte.

For builds by two compilers, which are to give the same digits: cmake --workflow clang. Usage: same_bytes.py PROGRAM PROGRAM
"""
import json
import subprocess
import sys
from pathlib import Path

VECTORS = Path(__file__).resolve().parent / "vectors"


def scenes():
    """Every scene once, as a line of JSON, in the order of the vectors."""
    lines = [line for path in sorted(VECTORS.glob("*.jsonl")) for line in path.read_text().splitlines()]
    vectors = [json.loads(line) for line in lines]
    return list(dict.fromkeys(json.dumps(v["scene"]) for v in vectors if "reject" not in v))


def questions(every):
    """Arguments of the program, and what it reads."""
    fifth = every[::5]
    for digits in (3, 6, 10, 13):
        yield ["solve", "--json", "--digits", str(digits)], "\n".join(every)
    for digits in (20, 40):
        yield ["solve", "--json", "--digits", str(digits)], "\n".join(fifth)
    yield ["solve", "--json", "--all"], "\n".join(fifth)
    for scene in fifth:
        yield ["map", "--r", "0.21:2.7:9", "--beta", "0.01:1.5:9"], scene
        yield ["map", "--r", "0.21:2.7:40", "--boundaries"], scene
        yield ["functions", "--json"], scene


def printed(program, arguments, text):
    run = subprocess.run([program, *arguments], input=text, capture_output=True, text=True)
    if run.returncode not in (0, 3):  # 3: to some question there is no answer with the digits asked for, and the same in both
        raise SystemExit(f"{program} {' '.join(arguments)}: status {run.returncode}\n{run.stderr[-1000:]}")
    return run.returncode, run.stdout, run.stderr


def main():
    if len(sys.argv) != 3:
        raise SystemExit(__doc__)
    asked = different = size = 0
    for arguments, text in questions(scenes()):
        first, second = (printed(program, arguments, text) for program in sys.argv[1:])
        asked += 1
        size += len(first[1])
        if first != second:
            different += 1
            lines = [pair for pair in zip(first[1].splitlines(), second[1].splitlines()) if pair[0] != pair[1]]
            print(f"{' '.join(arguments)}: {len(lines)} lines differ, first\n  {lines[0] if lines else (first[2], second[2])}")
    print(f"{asked} runs, {size} bytes, {different} runs differ")
    raise SystemExit(different > 0)


if __name__ == "__main__":
    main()
