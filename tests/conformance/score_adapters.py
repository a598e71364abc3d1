"""Asks every implementation of adapters/ the certified vectors by `denhartog conform run`, and writes the scores.

None may give a wrong, inaccurate or loose answer, fail to reject, skip what a closed form gives, or break. What is missing is
skipped by name. One question in ten is asked and all that break a rule; with --all every question. Usage:
score_adapters.py --program DENHARTOG --vectors FOLDER --output FOLDER --library LIBDENHARTOG [--all]
"""
import argparse
import json
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent / "adapters"
COLUMNS = ("pass", "pass-loose", "rejected", "skipped")


def implementations(folder, library):
    """Name, the program that has to be installed, how it is built, how it is started; what the ids of its questions begin with."""
    c, fortran = HERE / "c", HERE / "fortran"
    header = HERE.parents[2] / "src/denhartog/c"
    strict = ["-O2", "-ffp-contract=off", "-Wall", "-Wextra", "-pedantic", "-Werror"]
    return [
        ("Python", sys.executable, [], [sys.executable, HERE / "python/adapter.py"], ""),
        ("Octave", "octave-cli", [], ["octave-cli", HERE / "octave/adapter.m"], ""),
        ("JavaScript", "node", [], ["node", HERE / "javascript/adapter.js"], ""),
        ("C", "cc", ["cc", "-std=c99", *strict, "-o", folder / "c", c / "adapter.c", c / "closed_form.c", "-lm"],
         [folder / "c"], ""),
        ("Fortran", "gfortran", ["gfortran", "-std=f2018", *strict, "-J", folder, "-o", folder / "fortran",
                                 fortran / "closed_form.f90", fortran / "adapter.f90"], [folder / "fortran"], ""),
        ("Python, systems", sys.executable, [], [sys.executable, HERE / "systems/adapter.py"], "systems-"),
        ("the library, from C", "cc", ["cc", "-std=c99", *strict, "-I", header, "-o", folder / "library", c / "library_adapter.c",
                                       library, f"-Wl,-rpath,{library.parent}", "-lm"], [folder / "library"], ""),
    ]


def score(options, folder, build, start, questions):
    if build:
        subprocess.run([str(word) for word in build], check=True)
    report = folder / "report.json"
    report.unlink(missing_ok=True)
    run = subprocess.run([options.program, "conform", "run", "--vectors", options.vectors, "--systems", "--filter", questions,
                          "--jobs", "2", "--timeout", "60", "--format", "json", "--output", str(report), "--", *map(str, start)],
                         capture_output=True, text=True)
    if run.returncode > 1:
        raise SystemExit(f"{start[0]}: status {run.returncode}\n{run.stderr[-1000:]}")
    return json.loads(report.read_text())


def tiers(report):
    """By tier, systems beyond the paper by themselves: questions, verdicts, and the least of what its groups have in digits."""
    rows = {}
    for s in report["scores"]:
        tier = "systems" if s["group"].startswith("systems-") else s["tier"]
        row = rows.setdefault(tier, {"asked": 0, "counts": {}, "median_digits": None, "worst_digits": None})
        row["asked"] += s["asked"]
        for verdict, n in s["counts"].items():
            row["counts"][verdict] = row["counts"].get(verdict, 0) + n
        for key in ("median_digits", "worst_digits"):
            if s[key] is not None:
                row[key] = s[key] if row[key] is None else min(row[key], s[key])
    return rows


def table(scores, skipped, is_all):
    lines = ["| implementation | tier | asked | pass | pass-loose | rejected | skipped | anything else | "
             "least median digits of a group | worst digits |", "|---|---|--:|--:|--:|--:|--:|--:|--:|--:|"]
    for name, rows in scores.items():
        for tier, row in rows.items():
            counts = row["counts"]
            other = sum(n for verdict, n in counts.items() if verdict not in COLUMNS)
            digits = [f"{row[key]:.1f}" if row[key] is not None else "" for key in ("median_digits", "worst_digits")]
            lines.append(f"| {name} | {tier} | {row['asked']} | " + " | ".join(str(counts[v]) for v in COLUMNS) +
                         f" | {other} | {digits[0]} | {digits[1]} |")
    text = "\n".join([*lines, "", "Skipped are motions with stops, which no closed form gives; the library and the JavaScript "
                      "answer them from event to event. The rows `systems` are about systems beyond the paper; an implementation "
                      "of the paper skips all of them." +
                      ("\n" if is_all else " One question in ten was asked, and all that break a rule; the preset `sweeps` asks "
                       "all of them.\n")])
    return text + ("\nNot installed here, and not asked: " + ", ".join(skipped) + ".\n" if skipped else "")


def main():
    parser = argparse.ArgumentParser()
    for option in ("--program", "--vectors", "--output", "--library"):
        parser.add_argument(option, required=True)
    parser.add_argument("--all", action="store_true", help="ask every question, not one in ten: minutes")
    options = parser.parse_args()
    scores, skipped, faults = {}, [], []
    vectors = [json.loads(line) for path in Path(options.vectors).glob("*.jsonl") for line in path.open()]
    closed = {v["id"] for v in vectors if v.get("regime") != "stick_slip" and not v["group"].startswith("systems-")}
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for language, needed, build, start, group in implementations(folder, Path(options.library).resolve()):
            if not shutil.which(needed):
                skipped.append(f"{language} ({needed})")
                print(f"{language}: skipped, {needed} is not installed")
                continue
            report = score(options, folder, build, start, f"^{group}" + ("" if options.all else "(.*0|(systems-)?reject.*)$"))
            scores[language] = tiers(report)
            smoke = [options.program, "conform", "smoke", "--", *map(str, start)]
            if subprocess.run(smoke, stdout=subprocess.DEVNULL).returncode:
                faults.append(f"{language}: `conform smoke` fails")
            bad = [r for r in report["results"] if r["verdict"] not in COLUMNS or r["verdict"] == "pass-loose" or
                   (r["verdict"] == "skipped" and r["id"] in closed)]
            faults += [f"{language}: {r['id']} {r['verdict']} {r.get('reason', '')} {r.get('error', '')}" for r in bad]
            faults += [f"{language}: {note}" for note in report["notes"]]
            print(f"{language}: " + ", ".join(f"{n} {verdict}" for verdict, n in report["counts"].items() if n))
    output = Path(options.output)
    output.mkdir(parents=True, exist_ok=True)
    (output / "adapters.md").write_text(table(scores, skipped, options.all))
    (output / "adapters.json").write_text(json.dumps({"scores": scores, "skipped": skipped, "faults": faults}, indent=1) + "\n")
    print("\n".join(faults))
    return 1 if faults or not scores else 0


if __name__ == "__main__":
    sys.exit(main())
