"""solvers_table.py FOLDER: makes solvers.json and solvers.md from FOLDER/solvers/runs.json and the reports that it names."""
import json
import statistics
import sys
from pathlib import Path

TIERS = ("must", "should", "stress")
VERDICTS = ("pass", "pass-loose", "rejected", "inaccurate", "as-printed", "wrong", "wrong-regime", "not-rejected", "skipped", "crash",
            "timeout", "stall")


def tier_of(report, tier):
    """Verdicts of a tier, with the digits of the numbers among the answers."""
    results = [result for result in report["results"] if result["tier"] == tier]
    given = [result["verdict"] for result in results]
    row = {"tier": tier, "asked": len(results), "verdicts": {verdict: given.count(verdict) for verdict in sorted(set(given))}}
    digits = sorted((result["digits"], result["id"]) for result in results if "digits" in result)
    if digits:
        row |= {"median_digits": statistics.median(each for each, _ in digits), "worst_digits": digits[0][0], "worst_id": digits[0][1]}
    return row


def solver_of(run, folder):
    report = json.loads((folder / run["report"]).read_text())
    return {"solver": report["subject"]} | {key: run[key] for key in ("package", "version", "seconds", "jobs")} | {
        "tiers": [row for row in (tier_of(report, tier) for tier in TIERS) if row["asked"] > 0]}


def markdown(solvers):
    verdicts = [verdict for verdict in VERDICTS if any(verdict in tier["verdicts"] for each in solvers for tier in each["tiers"])]
    rows = [["solver", "tier", "asked", *verdicts, "median digits", "worst digits", "worst"]]
    rows.append(["---"] * len(rows[0]))
    for each in solvers:
        for tier in each["tiers"]:
            digits = [f"{tier[key]:.1f}" if key in tier else "" for key in ("median_digits", "worst_digits")]
            rows.append([each["solver"], tier["tier"], tier["asked"], *(tier["verdicts"].get(verdict, 0) for verdict in verdicts),
                         *digits, tier.get("worst_id", "")])
    lines = ["".join(["|", *(f" {cell} |" for cell in row)]) for row in rows] + [""]
    for each in solvers:
        lines.append(f"- {each['solver']}: {each['package']} {each['version']}, {int(each['seconds'] + 0.5)} s for all questions, "
                     f"{each['jobs']} at a time")
    return "\n".join(lines) + "\n"


def main(folder):
    solvers = [solver_of(run, folder / "solvers") for run in json.loads((folder / "solvers/runs.json").read_text())]
    (folder / "solvers.json").write_text(json.dumps(solvers, indent=1, ensure_ascii=False) + "\n")
    (folder / "solvers.md").write_text(markdown(solvers))
    print(markdown(solvers), end="")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
