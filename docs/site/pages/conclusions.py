"""Do the conclusions survive? The statements of the paper's text in its order, with the verdicts of the run, in plain words.

A person writes the sentence on a claim, docs/ledger/in_words.json; the numbers in it are those of the run: `{beta}` is the value
of the witness that has this name, to three digits, `{beta:2}` to two, `{error:%}` in percent. A sentence is for one verdict:
where the run finds another one, the pages are not made.
"""
import math
import re
from collections import Counter
from types import SimpleNamespace

from .records import record_of
from .text import Fault, digits, typeset

# What a verdict means to a reader, and the colour of its mark.
ANSWERS = {"proved": ("holds, proved", "proved"), "argued": ("holds, by an argument that is given", "argued"),
           "measured": ("holds where it was measured", "measured"), "refuted": ("false", "refuted"),
           "refuted at a threshold of ours": ("false at the threshold that was chosen", "illegible"),
           "assumption": ("assumed", "assumption"), "slip of reference": ("cites the wrong equation or figure", "illegible"),
           "not decided": ("not decided", "open")}
NUMBER_WORDS = ["no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten"]

SYSTEM = re.compile(r"(?:(\d+)DOF j=(\d+) l=(\d+)|SDOF)[, ]*(?:zeta=(\S+)|(undamped))?(.*)")


def system_in_words(name):
    """`2DOF j=2 l=1 zeta=0.1` is two masses, contact on mass 2, load on mass 1, zeta = 0.1."""
    found = SYSTEM.fullmatch(name)
    if not found:
        return name
    masses, contact, load, zeta, undamped, rest = found.groups()
    said = f"{NUMBER_WORDS[int(masses)]} masses, contact on mass {contact}, load on mass {load}" if masses else "a single mass"
    damping = rf", $\zeta={digits(float(zeta), 3)}$" if zeta else ", without damping" if undamped else ""
    return said + damping + (", " + rest if rest else "")


def scene_of(record):
    """Where the explorable machine shows the point of a witness, if it is one of the paper's chains, in motion."""
    values = {value["name"]: value["value"] for value in record["witness"]}
    found = SYSTEM.fullmatch(values.get("system", ""))
    if not found or not {"r", "beta"} <= values.keys() or float(values["beta"]) < 1e-6:
        return None
    masses, contact, load, zeta, _, _ = found.groups()
    zeta = float(zeta or values.get("zeta", "0"))
    frequencies = ((math.sqrt(5) - 1) / 2, (math.sqrt(5) + 1) / 2) if masses == "2" else (1,)  # of Figs. 8 to 10
    ratios = ",".join(f"{zeta / r_n:.6g}" for r_n in frequencies)
    return (f"machine.html#N={masses or 1}&g=1&k=1&z={ratios}&j={contact or 1}&l={load or 1}&r={float(values['r']):.6g}"
            f"&b={float(values['beta']):.6g}")


def with_numbers(words, record, claim):
    """A sentence with the values of the witness put in."""
    values = {value["name"]: value["value"] for value in record["witness"]}

    def number(mark):
        name, form = mark[1], mark[2].removeprefix(":")
        if name == "system":
            said = system_in_words(values[name])
            return said[0].upper() + said[1:] if mark.string[:mark.start()].strip()[-1:] in ("", ".") else said
        if re.fullmatch("-?[0-9]{1,5}", values[name]):
            return values[name]
        value = float(values[name])
        return digits(100 * value, 2) + " %" if form == "%" else digits(value, int(form or 3))

    names = sorted(map(re.escape, values), key=len, reverse=True) or ["-"]
    said = re.sub(r"\{(" + "|".join(names) + r")((?::[0-9%])?)\}", number, words)
    if left := re.search(r"\{[^}]*\}", re.sub(r"\$[^$]*\$", "", said)):
        raise Fault(f"docs/ledger/in_words.json: {claim} has no value {left[0]}")
    return typeset(said, "docs/ledger/in_words.json")


def sentence_on(run, claim, verdict):
    """The sentence on a claim with the numbers of the run; empty where nobody has written one."""
    words = run.in_words.get(claim)
    if words is None:
        return ""
    decided = "refuted at a threshold of ours" if verdict == "refuted" and words["verdict"] != "refuted" else verdict
    if words["verdict"] != decided:
        raise Fault(f"docs/ledger/in_words.json: {claim} is {verdict}, its sentence is for {words['verdict']}")
    return with_numbers(words["words"], record_of(run, claim), claim)


def number_of_ours(threshold):
    """What was taken for a vague word, and where the verdict turns."""
    turns, taken = digits(threshold["turns"], 2), digits(threshold["taken"], 2)
    where = f"it would hold with {turns}" if threshold["decides"] else f"it would hold only with {turns}, which says nothing"
    return typeset(f"{threshold['what']}: we took {taken}; {where}", "docs/ledger/in_words.json")


def decided_by(run, claim):
    """What a page says of a claim: its sentence, or what is wrong with the printed equation, or nothing."""
    equation, words = claim["id"].partition("/")[0], run.in_words.get(claim["id"])
    if claim["id"] not in run.claims:  # an id for all claims that begin with it
        return SimpleNamespace(equation=equation, said="", misprint=False, numbers=[], picture=None, record=None, place=None)
    record, refuted = record_of(run, claim["id"]), "refuted" in claim["verdict"]
    misprint = refuted and not words and run.departures[equation].said
    if refuted and not words and not misprint:
        raise Fault(f"docs/ledger/in_words.json has no sentence on {claim['id']}")
    place = run.places.get(equation) if misprint else scene_of(record) if refuted else None
    return SimpleNamespace(equation=equation, said=sentence_on(run, claim["id"], claim["verdict"]), misprint=misprint,
                           numbers=[number_of_ours(threshold) for threshold in record["thresholds"]] if refuted else [],
                           picture=words and words.get("picture"), record=record, place=place)


def conclusions_view(run):
    """Sections with their statements, and how many statements there are of each answer."""
    if unknown := run.in_words.keys() - {claim["id"] for row in run.statements for claim in row["claims"]}:
        raise Fault(f"docs/ledger/in_words.json speaks of {', '.join(sorted(unknown))}, which decides no statement")
    figures, shown, rows = run.figures, set(), []
    for row in run.statements:
        claims = [decided_by(run, claim) for claim in row["claims"]]
        names = [claim.picture for claim in claims if claim.picture in figures]
        answer, colour = ANSWERS[row["verdict"]]
        remark = re.sub(r"\bfig0?(\d+)\b", r"Fig. \1", row["remark"])
        place = next((claim.place for claim in claims if claim.place), None)
        rows.append(dict(row, remark=remark, answer=answer, colour=colour, claims=claims, place=place,
                         figure=figures[names[0]] if names else None, new=bool(names) and names[0] not in shown))
        shown.update(names[:1])
    count = Counter(row["answer"] for row in rows)
    return dict(statements=rows, count=[(answer, colour, count[answer]) for answer, colour in ANSWERS.values()])
