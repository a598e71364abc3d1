"""The kill matrix: every known mistake as a program of its own, asked the certified vectors by `denhartog conform run`.

A mistake is made by edits of an adapter or by arguments of a solver (programs.txt). Its program has to be found
wrong, and the first diagnosis has to be the right one; a correct program has to pass, one in single precision to be found
inaccurate and nowhere wrong, and one that has no name must not conform. Where the vectors that show a mistake are no `must`, the
run conforms but finds it all the same. An edit whose text is not there exactly once is an error. Programs that make several
mistakes at once are for diagnose_known.cpp. Usage:
kill_matrix.py --program DENHARTOG --vectors FOLDER --output FOLDER [--only NAME] [--all]
With --only one of them is run, and no table written. A program that is asked one in so many of all vectors is asked a quarter of
these, and with --all each of them.
"""
import argparse
import json
import shutil
import subprocess
import sys
import tempfile
from collections import Counter, defaultdict
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

HERE = Path(__file__).resolve().parent
ADAPTERS = HERE.parent / "adapters"
WRONG = ("wrong", "as-printed", "wrong-regime")
MOST_CAUGHT = 24  # vectors that claim to catch the mistake
MOST_A_QUANTITY = 3  # vectors besides, of every quantity


def programs_in(text):
    """The programs of a text, which says at its head how it is written."""
    programs, edit = [], None
    for line in text.splitlines():
        if line.startswith("== "):
            name, brace, settings = line[3:].partition(" {")
            programs.append({"name": name, **json.loads(brace + settings or "{}"), "edits": []})
        elif line.startswith(("-", "+")):
            if line[0] == "-" and edit["new"]:
                edit = {"file": edit["file"], "old": [], "new": []}
            if not edit["old"]:
                programs[-1]["edits"].append(edit)
            edit["old" if line[0] == "-" else "new"].append(line[1:])
        elif not line.startswith("#"):
            edit = {"file": line, "old": [], "new": []}
    return programs


def edited(folder, edits, adapter):
    """An adapter with the edits in a folder of its own."""
    files = {path.name: path.read_text() for path in (ADAPTERS / adapter).iterdir() if path.suffix in (".py", ".js")}
    for edit in edits:
        old, content = "\n".join(edit["old"]), files[edit["file"]]
        if content.count(old) != 1:
            raise SystemExit(f"stale edit: {edit['file']} has {content.count(old)} times\n{old}")
        files[edit["file"]] = content.replace(old, "\n".join(edit["new"]))
    for name, content in files.items():
        (folder / name).write_text(content)
    return ["node", str(folder / "adapter.js")] if "adapter.js" in files else [sys.executable, str(folder / "adapter.py")]


def spread(vectors, most):
    return vectors if len(vectors) <= most else [vectors[n * len(vectors) // most] for n in range(most)]


def chosen(vectors, subject, is_all):
    """The vectors that a program is asked: one in so many of all, or those that claim to catch it and some of every quantity.

    An edit of the adapter `systems` is asked about systems beyond the paper, any other program about scenes of the paper."""
    vectors = [v for v in vectors if v["group"].startswith("systems-") == (subject.get("adapter") == "systems")]
    if "of_all" in subject:
        return [v for v in vectors if subject.get("without") not in v["flags"]][:: subject["of_all"] * (1 if is_all else 4)]
    names = subject["diagnosis"]
    groups = subject.get("asks")
    asked = [v for v in vectors if (not groups or v["quantity"] in groups) and subject.get("flag", "") in ["", *v["flags"]]]
    caught = spread([v for v in asked if set(names) & set(v["catches"])], subject.get("most", MOST_CAUGHT))
    by_quantity = defaultdict(list)
    for v in asked:
        if v["tier"] != "stress":
            by_quantity[v["quantity"]].append(v)
    others = [v for of_one in by_quantity.values() for v in spread(of_one, subject.get("each", MOST_A_QUANTITY))]
    ids = {v["id"] for v in caught + others}
    return [v for v in vectors if v["id"] in ids]


def run(options, vectors, subject):
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        asked = chosen(vectors, subject, options.all)
        (folder / "vectors").mkdir()
        for group in sorted({v["file"] for v in asked}):
            lines = [v["line"] for v in asked if v["file"] == group]
            (folder / "vectors" / group).write_text("\n".join(lines) + "\n")
        (folder / "program").mkdir()
        if "program" in subject:
            command = [sys.executable, str(HERE / subject["program"][0]), *subject["program"][1:]]
        else:
            command = edited(folder / "program", subject["edits"], subject.get("adapter", "python"))
        done = subprocess.run([options.program, "conform", "run", "--vectors", str(folder / "vectors"), "--systems", "--format",
                               "json", "--timeout", "30", "--method", subject.get("method", "closed-form"), "--", *command],
                              capture_output=True, text=True)
        if done.returncode not in (0, 1):
            return {"asked": len(asked), "status": done.returncode, "error": done.stderr[-400:], "wrong": 0, "groups": {},
                    "findings": [], "counts": {}, "mistaken": []}
        report = json.loads(done.stdout)
    wrong = [r for r in report["results"] if r["verdict"] in WRONG]
    return {"asked": len(asked), "status": done.returncode, "error": "", "wrong": len(wrong),
            "groups": dict(sorted(Counter(r["group"] for r in wrong).items())), "counts": report["counts"],
            "findings": [{k: f[k] for k in ("mistake", "number", "explained", "contradicted")} for f in report["diagnosis"]["findings"]],
            "mistaken": [f"{r['id']}: {r['verdict']} {r.get('reason', '')} {r.get('error', '')}" for r in wrong][:8]}


def fault_of(subject, result):
    """What is amiss; empty where all is as it has to be."""
    if result["error"]:
        return f"the runner ended with status {result['status']}: {result['error']}"
    if subject.get("verdict") == "right":
        return "" if result["status"] == 0 and result["wrong"] == 0 else f"a correct program fails: {result['mistaken']}"
    if subject.get("verdict") == "inaccurate":
        if result["wrong"]:
            return f"found wrong, not inaccurate: {result['mistaken']}"
        return "" if result["counts"]["inaccurate"] else "not found inaccurate"
    if not result["wrong"]:
        return f"survives {result['asked']} questions"
    if subject.get("verdict") == "fails":
        return "" if result["status"] == 1 else f"conforms, with {result['wrong']} wrong answers"
    first = result["findings"][0]["mistake"] if result["findings"] else "none"
    if first not in subject["diagnosis"]:
        return f"first diagnosis is {first}"
    number = result["findings"][0]["number"]
    return "" if number == subject.get("number", number) else f"the number found is {number}"


def table(rows, totals):
    lines = ["| mistake | asked | found wrong | in groups | first diagnosis | explained by it |",
             "|---|--:|--:|---|---|--:|"]
    for name, r in rows:
        first = r["findings"][0] if r["findings"] else {"mistake": "", "explained": ""}
        lines.append(f"| {name} | {r['asked']} | {r['wrong']} | {', '.join(f'{g} {n}' for g, n in r['groups'].items())} | "
                     f"{first['mistake']} | {first['explained']} |")
    return "\n".join(lines) + "\n\n" + totals + "\n"


def main():
    parser = argparse.ArgumentParser()
    for option in ("--program", "--vectors", "--output"):
        parser.add_argument(option, required=True)
    parser.add_argument("--only")
    parser.add_argument("--all", action="store_true")
    options = parser.parse_args()
    vectors = []
    for path in sorted(Path(options.vectors).glob("*.jsonl")):
        for line in path.read_text().splitlines():
            v = json.loads(line)
            vectors.append({**v, "file": path.name, "line": line, "catches": v.get("catches", [])})
    if not vectors:
        raise SystemExit(f"no vectors in {options.vectors}")
    subjects = programs_in((HERE / "programs.txt").read_text())
    for subject in subjects:
        subject.setdefault("diagnosis", [subject["name"]])
    subjects = [s for s in subjects if options.only in (None, s["name"])
                and (s.get("adapter") != "javascript" or shutil.which("node"))]
    with ThreadPoolExecutor(2) as pool:
        results = list(pool.map(lambda s: run(options, vectors, s), subjects))
    rows = sorted(((s["name"], r) for s, r in zip(subjects, results)), key=lambda row: row[0])
    faults = {s["name"]: fault_of(s, r) for s, r in zip(subjects, results)}
    mistakes = [s for s in subjects if "verdict" not in s]
    killed = sum(not faults[s["name"]].startswith(("survives", "the runner")) for s in mistakes)
    right = sum(not faults[s["name"]] for s in mistakes)
    totals = f"{len(mistakes)} mistakes, {killed} killed, {right} of them with the right diagnosis first."
    if not options.only:
        output = Path(options.output)
        output.mkdir(parents=True, exist_ok=True)
        (output / "kill_matrix.md").write_text(table(rows, totals))
        record = {"mistakes": len(mistakes), "killed": killed, "diagnosed": right,
                  "rows": [{"name": name, **result, "fault": faults[name]} for name, result in rows]}
        (output / "kill_matrix.json").write_text(json.dumps(record, indent=1) + "\n")
    print(totals)
    for name, fault in sorted(faults.items()):
        if fault:
            print(f"{name}: {fault}")
    return 1 if any(faults.values()) else 0


if __name__ == "__main__":
    sys.exit(main())
