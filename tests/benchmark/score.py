#!/usr/bin/env python3
"""Scores results files against the pack, and makes tables of scores. Needs Python 3.8 and nothing else.

    score.py score RESULTS.jsonl...      scores as CSV, a line a scene, to standard output
    score.py table SCORES.csv            a line a method and setting
    score.py exposes SCORES.csv          by what the scenes expose
    score.py picture SCORES.csv          data of the picture

docs/benchmark.md has the format of a results file. Exit status 2: the input breaks a rule, which is named; nothing is written then.
"""
import csv
import json
import math
import pathlib
import statistics
import sys

PACK = pathlib.Path(__file__).resolve().parent / "pack" / "scenes.json"
INSTANTS = 64
COLUMNS = ["method", "setting", "scene", "answered", "seconds", "error", "velocity_error", "stops", "stop_error"]
GOOD, EXPOSED = 1e-3, ["creep", "missed event", "trapped event", "transient", "static friction", "none of these"]


class Refused(Exception):
    pass


def number(value, what):
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not math.isfinite(value):
        raise Refused(f"{what} must be a finite number, but is {value!r:.40}")
    return value


def masses(value, scene, what, contact_needed):
    """A list of N lists of 64 numbers; null for a mass that was not computed."""
    if not isinstance(value, list) or len(value) != len(scene["m"]):
        raise Refused(f"{what} must be a list of {len(scene['m'])}, one list a mass (null where a mass was not computed)")
    for k, row in enumerate(value, 1):
        if row is None and not (contact_needed and k == scene["contact"]):
            continue
        if not isinstance(row, list) or len(row) != INSTANTS:
            raise Refused(f"{what} of mass {k} must be a list of {INSTANTS} numbers")
        for n, x in enumerate(row):
            number(x, f"{what} of mass {k} at instant {n}")
    return value


def stops_of(scene):
    """Starts and ends of the contact's stops in a period; the one stop of a contact that never moves is the whole of it."""
    period = 2 * math.pi / scene["omega"]
    if scene["regime"] == "permanent_sticking":
        return [(0.0, period)]
    events, found = scene["events"], []
    for n, event in enumerate(events):
        if event["what"] == "stops":
            later = events[(n + 1) % len(events)]["t"] + (period if n + 1 == len(events) else 0)
            found.append((event["t"], later))
    return found


def largest_difference(given, true):
    return max(abs(a - b) for x, y in zip(given, true) if x is not None for a, b in zip(x, y))


def score_line(line, scene):
    """What a line of a results file is worth: the cells after `scene`."""
    known = {"scene", "seconds", "failure", "x", "v", "stops"}
    for name in line:
        if name not in known:
            raise Refused(f"member {name!r} is none of {', '.join(sorted(known))}")
    seconds = f"{number(line['seconds'], 'seconds'):.2g}" if "seconds" in line else ""
    if "failure" in line:
        return ["no", seconds, "", "", "", ""]
    if "x" not in line:
        raise Refused("x is missing; where there is no answer, say why in failure")
    scale = max(scene["amplitude"]) or 1.0
    x = masses(line["x"], scene, "x", True)
    error, velocity_error = largest_difference(x, scene["x"]) / scale, ""
    if "v" in line:
        v = masses(line["v"], scene, "v", False)
        velocity_error = f"{largest_difference(v, scene['v']) / (scale * scene['omega']):.1e}"
    stops, stop_error = "", ""
    if "stops" in line:
        period, true = 2 * math.pi / scene["omega"], stops_of(scene)
        given = []
        if not isinstance(line["stops"], list):
            raise Refused("stops must be a list of pairs, start and end in seconds")
        for stop in line["stops"]:
            if not isinstance(stop, list) or len(stop) != 2:
                raise Refused("a stop must be a pair, start and end in seconds")
            start, end = (number(t, "an instant of a stop") for t in stop)
            if not end > start:
                raise Refused(f"a stop must end after its start, but {end} is not after {start}")
            given.append((start, end))
        stops = "right" if len(given) == len(true) else "wrong"
        if stops == "right" and scene["regime"] == "permanent_sticking":
            stops = "right" if given[0][1] - given[0][0] >= period * (1 - 1e-9) else "wrong"
        elif stops == "right" and true:
            apart = lambda a, b: abs(math.remainder(a - b, period)) / period
            stop_error = max(min(max(apart(a, c), apart(b, d)) for c, d in given) for a, b in true)
            stop_error = f"{stop_error:.1e}"
    return ["yes", seconds, f"{error:.1e}", velocity_error, stops, stop_error]


def refuse_constant(text):
    raise Refused(f"{text} is no number")


def score_file(path, scenes):
    rows, head, seen = [], None, set()
    for n, text in enumerate(pathlib.Path(path).read_text(encoding="utf-8").splitlines(), 1):
        try:
            line = json.loads(text, parse_constant=refuse_constant)
            if not isinstance(line, dict):
                raise Refused("a line must be a JSON object")
            if head is None:
                if not all(isinstance(line.get(name), str) and line[name] for name in ("method", "setting")):
                    raise Refused("the first line must have method and setting, each a text")
                head = [line["method"], line["setting"]]
                continue
            name = line.get("scene")
            if name not in scenes:
                raise Refused(f"scene {name!r:.40} is not in the pack")
            if name in seen:
                raise Refused(f"scene {name} is there twice")
            seen.add(name)
            rows.append([*head, name, *score_line(line, scenes[name])])
        except (Refused, ValueError) as reason:
            raise Refused(f"{path}, line {n}: {reason}") from None
    if not rows:
        raise Refused(f"{path}: there is no scene in it")
    return rows + [[*head, name, "no", "", "", "", "", ""] for name in scenes if name not in seen]  # left out: not answered


def read_scores(path):
    with open(path, newline="", encoding="utf-8") as file:
        reader = csv.DictReader(file)
        if reader.fieldnames != COLUMNS:
            raise Refused(f"{path}: the columns must be {','.join(COLUMNS)}")
        rows = list(reader)
    for n, row in enumerate(rows, 2):
        for name in ("seconds", "error"):
            try:
                row[name] = float(row[name]) if row[name] else None
            except ValueError:
                raise Refused(f"{path}, line {n}: {name} must be a number, but is {row[name]!r}") from None
    groups = {}
    for row in rows:
        groups.setdefault((row["method"], row["setting"]), []).append(row)
    return groups


def laid_out(rows):
    widths = [max(len(row[n]) for row in rows) for n in range(len(rows[0]))]
    return ["  ".join(cell.ljust(width) for cell, width in zip(row, widths)).rstrip() for row in rows]


def summary(rows):
    errors = sorted(row["error"] for row in rows if row["error"] is not None)
    seconds = [row["seconds"] for row in rows if row["seconds"] is not None]
    told = [row["stops"] for row in rows if row["stops"]]
    return errors, statistics.median(seconds) if seconds else None, told


def worst(rows):
    answered = [row for row in rows if row["error"] is not None]
    return "{error:.0e} {scene}".format(**max(answered, key=lambda row: row["error"])) if answered else "-"


def table(groups):
    lines = [["method", "setting", "answered", "within 1e-3", "1e-6", "1e-9", "median", "worst", "stops right", "seconds"]]
    for (method, setting), rows in groups.items():
        errors, seconds, told = summary(rows)
        lines.append([method, setting, f"{len(errors)} of {len(rows)}"] +
                     [str(sum(e <= limit for e in errors)) for limit in (1e-3, 1e-6, 1e-9)] +
                     [f"{statistics.median(errors):.0e}" if errors else "-", worst(rows),
                      f"{told.count('right')} of {len(told)}" if told else "-", f"{seconds:.1g}" if seconds is not None else "-"])
    return laid_out(lines)


def by_exposure(groups, scenes):
    lines = [["method", "setting", *EXPOSED]]
    for (method, setting), rows in groups.items():
        cells = []
        for what in EXPOSED:
            some = [row for row in rows if what in (scenes[row["scene"]]["exposes"] or ["none of these"])]
            right = sum(row["error"] is not None and row["error"] <= GOOD for row in some)
            cells.append(f"{right} of {len(some)}" if some else "-")
        lines.append([method, setting, *cells])
    return laid_out(lines)


def picture(groups):
    """Blocks a method: digits (median of the answered, then that nine of ten scenes have, unanswered ones having none),
    seconds a scene, share of scenes within 1e-3."""
    methods, text = {}, []
    for (method, setting), rows in groups.items():
        bounded = " and max_step" if "max_step" in setting else ""
        methods.setdefault(method + bounded, []).append((setting, rows))
    for n, (method, settings) in enumerate(methods.items(), 1):
        text += [f"# name {n} {method}", f"# method={n};"]
        for _, rows in settings:
            errors, seconds, _ = summary(rows)
            digits = sorted(max(0.0, -math.log10(e)) if e > 0 else 17.0 for e in errors)
            if not digits or seconds is None:
                continue
            nine = sorted(digits + [0.0] * (len(rows) - len(digits)))[len(rows) // 10]
            text.append(f"{statistics.median(digits):.2f} {nine:.2f} {max(seconds, 1e-6):.3g} "
                        f"{sum(e <= GOOD for e in errors) / len(rows):.3f}")
        text += ["", ""]
    return text


def main(arguments):
    if len(arguments) < 2 or arguments[0] not in ("score", "table", "exposes", "picture") or arguments[1] in ("-h", "--help"):
        print(__doc__, file=sys.stderr)
        return 2
    try:
        scenes = {scene["scene"]: scene for scene in json.loads(PACK.read_text(encoding="utf-8"))}
        command, files = arguments[0], arguments[1:]
        if command == "score":
            rows = [row for path in files for row in score_file(path, scenes)]
            csv.writer(sys.stdout, lineterminator="\n").writerows([COLUMNS, *rows])
            return 0
        groups = read_scores(files[0])
        lines = {"table": table, "picture": picture}.get(command, lambda some: by_exposure(some, scenes))(groups)
        print("\n".join(lines))
        return 0
    except (Refused, OSError) as reason:
        print(f"score.py: {reason}", file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
