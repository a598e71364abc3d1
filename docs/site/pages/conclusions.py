"""Do the conclusions survive? The statements of the paper's text in its order, with the verdicts of the run, in plain words.

A person writes the sentence on a claim, docs/ledger/in_words.json; the numbers in it are those of the run: `{beta}` is the value
of the witness that has this name, to three digits, `{beta:2}` to two, `{error:%}` in percent. A sentence is for one verdict:
where the run finds another one, the pages are not made.
"""
import math
import re
from types import SimpleNamespace

from .records import record_of
from .text import Fault, digits, equation_link, spelled, typeset


def scene_of(record):
    """Where the explorable machine shows the point of a witness, if it is one of the paper's chains, in motion."""
    values = {value["name"]: value["value"] for value in record["witness"]}
    found = re.match(r"(?:(\d+)DOF j=(\d+) l=(\d+)|SDOF)[, ]*(?:zeta=(\S+))?", values.get("system", ""))
    if not found or not {"r", "beta"} <= values.keys() or float(values["beta"]) < 1e-6:
        return None
    masses, contact, load, zeta = found.groups()
    zeta = float(zeta or values.get("zeta", "0"))
    frequencies = ((math.sqrt(5) - 1) / 2, (math.sqrt(5) + 1) / 2) if masses == "2" else (1,)  # of Figs. 8 to 10
    ratios = ",".join(f"{zeta / r_n:.6g}" for r_n in frequencies)
    return (f"machine.html#N={masses or 1}&g=1&k=1&z={ratios}&j={contact or 1}&l={load or 1}&r={float(values['r']):.6g}"
            f"&b={float(values['beta']):.6g}")


def sentence_on(run, claim, verdict):
    """The sentence on a claim with the numbers of the run; empty where nobody has written one."""
    words = run.in_words.get(claim)
    if words is None:
        return ""
    decided = "refuted at a threshold of ours" if verdict == "refuted" and words["verdict"] != "refuted" else verdict
    if words["verdict"] != decided:
        raise Fault(f"docs/ledger/in_words.json: {claim} is {verdict}, its sentence is for {words['verdict']}")
    values = {value["name"]: value["value"] for value in record_of(run, claim)["witness"]}

    def number(mark):
        name, form = mark[1], mark[2].removeprefix(":")
        if name == "system":
            said = re.sub(r"\bj=(\d+), l=(\d+)", r"contact on mass \1, load on mass \2", spelled(values[name]))
            return said[0].upper() + said[1:] if mark.string[:mark.start()].strip()[-1:] in ("", ".") else said
        if re.fullmatch("-?[0-9]{1,5}", values[name]):
            return values[name]
        value = float(values[name])
        return digits(100 * value, 2) + " %" if form == "%" else digits(value, int(form or 3))

    names = "|".join(sorted(map(re.escape, values), key=len, reverse=True)) or "-"
    said = re.sub(r"\{(" + names + r")((?::[0-9%])?)\}", number, words["words"])
    if left := re.search(r"\{[^}]*\}", re.sub(r"\$[^$]*\$", "", said)):
        raise Fault(f"docs/ledger/in_words.json: {claim} has no value {left[0]}")
    return typeset(said, "docs/ledger/in_words.json")


def number_of_ours(threshold):
    """What was taken for a vague word, and where the verdict turns."""
    turns, taken = digits(threshold["turns"], 2), digits(threshold["taken"], 2)
    where = f"it would hold with {turns}" if threshold["decides"] else f"it would hold only with {turns}, which says nothing"
    return typeset(f"{threshold['what']}: we took {taken}; {where}", "docs/ledger/in_words.json")


def decided_by(run, claim):
    """What a page says of a claim: its sentence, or what is wrong with the printed equation, or nothing."""
    record, refuted = record_of(run, claim["id"]), "refuted" in claim["verdict"]
    said, place = sentence_on(run, claim["id"], claim["verdict"]), scene_of(record) if refuted else None
    if refuted and not said:
        equation = claim["id"].partition("/")[0]
        if not run.departures[equation].said:
            raise Fault(f"docs/ledger/in_words.json has no sentence on {claim['id']}")
        said = f"{equation_link(equation)} as printed: {typeset(run.departures[equation].said, 'departures.json')}"
        place = run.places.get(equation)
    return SimpleNamespace(said=said, numbers=list(map(number_of_ours, record["thresholds"])) if refuted else [],
                           picture=run.in_words.get(claim["id"], {}).get("picture"), record=record, place=place)


def conclusions_of(run):
    """The statements with the claims that decide them."""
    if unknown := run.in_words.keys() - {claim["id"] for row in run.statements for claim in row["claims"]}:
        raise Fault(f"docs/ledger/in_words.json speaks of {', '.join(sorted(unknown))}, which decides no statement")
    shown, rows = set(), []
    for row in run.statements:
        claims = [decided_by(run, claim) for claim in row["claims"] if claim["id"] in run.claims]  # others are of many claims
        figure = next((run.figures[claim.picture] for claim in claims if claim.picture in run.figures), None)
        remark = re.sub(r"\bfig0?(\d+)\b", r"Fig. \1", row["remark"])
        place = next((claim.place for claim in claims if claim.place), None)
        rows.append(dict(row, remark=remark, claims=claims, place=place, figure=figure, new=figure and figure.name not in shown))
        shown.add(figure and figure.name)
    return rows
