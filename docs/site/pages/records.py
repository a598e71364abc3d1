"""What a run wrote, as the pages take it: ledger, derivation, figures, measurements; and what people wrote beside it."""
import csv
import json
import re
import subprocess
from collections import defaultdict, namedtuple
from types import SimpleNamespace
from xml.etree import ElementTree

from .text import EQUATIONS, Fault, label

Departure = namedtuple("Departure", "equation said printed holds why", defaults=[""] * 5)


def read_json(file):
    try:
        return json.loads(file.read_text())
    except json.JSONDecodeError as error:
        raise Fault(f"{file} must be JSON: {error}") from error


def read_if_there(file):
    return file.read_text() if file.exists() else ""


def told(*command, asked=None):
    """What a program answers."""
    return subprocess.run(command, input=asked, check=True, stdout=subprocess.PIPE, text=True).stdout


def read_run(verify, source):
    """Everything that the pages are made of."""
    ledger, written = read_json(verify / "paper/ledger.json"), source / "docs/ledger"
    claims = {claim["claim"]: claim for claim in read_json(verify / "paper/derivation.json")}
    exported = json.loads(read_if_there(verify / "kernel/certificates.json") or '{"certificates": []}')
    accuracy = sorted(map(read_json, sorted((verify / "test-results/accuracy").glob("*.json"))),
                      key=lambda record: {"d": 0, "l": 1}.get(record["type"][0], 2))  # double, long double, others
    offers = json.loads(told(verify / "bin/offers", source / "tests/conformance/vectors"))
    return SimpleNamespace(
        ledger=ledger, entries={entry["equation"]: entry for entry in ledger}, claims=claims,
        symbols={each["name"]: each["name_latex"] for claim in claims.values() for each in claim["witness"]},
        run=read_json(verify / "paper/run.json"), audit=(verify / "paper/audit.md").read_text(),
        certificates={certificate["claim"]: certificate for certificate in exported["certificates"]},
        theorems=read_if_there(source / "derivation/kernel/Statements.v"), figures=read_figures(verify / "figures", source),
        accuracy=[row | {"type": record["type"]} for record in accuracy for row in record["functions"]],
        chart=read_if_there(verify / "chart/tables.md"), batch=read_if_there(verify / "chart/batch.md"),
        benchmark=[(solver, *row.split()) for solver, rows in re.findall(
            r"# name \d+ (.*)\n#.*\n((?:\d.*\n)*)", (source / "paper-figures/beyond/benchmark_work_precision.dat").read_text())
            for row in rows.splitlines()],
        conformance={file.stem: file.read_text() for file in (verify / "conformance").glob("*.md")},
        departures=defaultdict(Departure, {row["equation"]: Departure(**row) for row in read_json(written / "departures.json")}),
        tests={test.get("name"): dict(file="tests/" + test.get("filename").rpartition("/tests/")[2], line=test.get("line"))
               for results in (verify / "test-results").glob("*.xml") for test in ElementTree.parse(results).iter("TestCase")},
        statements=read_json(verify / "paper/statements.json"),
        in_words={row["claim"]: row for row in read_json(written / "in_words.json")},
        stand_for=read_json(written / "stand_for.json"), names=read_json(written / "names.json"),
        notation=read_symbols((source / "docs/notation.md").read_text()), places=read_json(source / "docs/explore/places.json"),
        formulas=offers["formulas"], questions=offers["questions"],
        motion=motion_of_example(verify / "bin/denhartog", source / "docs/example.json"))


def motion_of_example(program, scene):
    """Displacements of the masses of the program's example, a list an instant of the period."""
    rows = csv.DictReader(told(program, "motion", scene, "--samples", "36").splitlines())
    return [[float(row[name]) for name in row if name.startswith("x_")] for row in rows]


def named(records, name, what):
    """The record that has a name."""
    if name not in records:
        raise Fault(f"{name} must be {what}")
    return records[name]


def record_of(run, claim):
    """The record of a claim, of which the ledger may have one for each of its equations, with the equation at its end."""
    shorter, _, equation = claim.rpartition("/")
    of_all = claim not in run.claims and equation in EQUATIONS
    return named(run.claims, shorter if of_all else claim, "a claim with its steps in derivation.json; run ./verify paper again")


def faults_of_stand_ins(run):
    """A symbol of stand_for.json that stands in no formula of its claims would leave what it means unsaid."""
    return [f"docs/ledger/stand_for.json has {symbol} for claims {row['claims']}, in none of which it stands"
            for row in run.stand_for for symbol, _ in row["symbols"]
            if not any(re.search(symbol, step["latex"]) for claim, record in run.claims.items()
                       if re.fullmatch(row["claims"], claim) for step in record["steps"])]


def meant_by(run, claim, latex):
    """A formula of a claim with what its symbols stand for: the computer algebra borrows those of the modes for other numbers."""
    for row in run.stand_for:
        if re.fullmatch(row["claims"], claim):
            for symbol, meant in row["symbols"]:
                latex = re.sub(symbol, meant, latex)
    return latex


# Figures


def title_of_script(script):
    """The first sentence of a plot script, where no program has recorded a title."""
    comment = re.match("(# .*\n)+", script.read_text())[0]
    return re.split(r"\.\s|;", comment.replace("# ", "").replace("\n", " "))[0]


def read_figures(folder, source):
    """The figures of the run by name, those of the paper first."""
    captions, figures = read_json(source / "docs/ledger/figures.json"), {}
    scripts = {file.stem: file for file in (source / "paper-figures").rglob("*.gp")}
    for name in sorted(file.stem for file in folder.glob("*.svg") if file.stem in scripts):  # others an earlier run left
        record = read_json(folder / f"{name}.json") if (folder / f"{name}.json").exists() else None
        title = (record["title"] if record else title_of_script(scripts[name])).replace("->", "→").replace("zeta", "ζ")
        number = f"Fig. {int(name[3:5])}" if name.startswith("fig") else ""
        data = [file.name for ending in (".pdf", ".dat", ".csv") for file in sorted(folder.glob(f"{name}*{ending}"))]
        figures[name] = SimpleNamespace(
            name=name, label=label("figure", name), number=number, title=title, record=record, data=data,
            full_title=f"{number}: {title}" if number else title, script=scripts[name].relative_to(source).as_posix(),
            caption=named(captions, name, "a figure with a caption in docs/ledger/figures.json"))
    return dict(sorted(figures.items(), key=lambda item: not item[1].number))


# Symbols


def of_other_masses(latex):
    """The same symbol of another mass: psi_ki, psi_ji, psi_li; G_k, G_j."""
    for mass in "kj":
        if found := re.fullmatch(rf"(.*_[^_]*?){mass}([^_]*)", latex):
            return [latex] + [found[1] + other + found[2] for other in "kjl" if other != mass]
    return [latex]


def read_symbols(notation):
    """The paper's symbols from the tables of the notation page."""
    symbols = []
    for row in re.findall(r"^\| (\$.*)\|$", notation.partition("\n## Symbols of ours\n")[0], re.M):
        written, _, meaning, equations, units = (cell.strip() for cell in row.split("|"))
        for latex in re.findall(r"\$([^$]*)\$", written):
            latex = re.sub(r"(\\overline|\\mathbf|\\dot) (.)", r"\1{\2}", latex).replace(r"\boldsymbol\Psi", r"\boldsymbol{\Psi}")
            latex = latex.replace("'", "")
            if latex not in ("", "j", "l", "t"):
                symbols.append(SimpleNamespace(
                    latex=of_other_masses(latex), meaning=meaning, units=units,
                    equations=[number for number in re.findall(r"\(([^)]*)\)", equations) if number in EQUATIONS]))
    if not symbols:
        raise Fault("the notation page must have tables of symbols")
    return symbols


def stands_in(latex, name):
    """Whether a symbol stands in a formula, and not as a part of another one."""
    before = (r"(?<![A-Za-z\\_{])" if len(name) < 3 else r"(?<![A-Za-z\\_])") if name[0].isalpha() else ""
    return re.search(before + re.escape(name) + (r"(?![A-Za-z_])" if name[-1].isalpha() else ""), latex) is not None


def symbols_in(symbols, latex):
    """The symbols of a formula with their names in it, in the order of the notation page; of equal meanings the first."""
    found = {}
    for symbol in symbols:
        if names := [name for name in symbol.latex if stands_in(latex, name)]:
            found.setdefault(symbol.meaning, (names[0], symbol))
    return list(found.values())


# Departures


def faults_of_departures(departures, ledger):
    """Why the departures do not fit the run: one without a sentence, a sentence too many, or another formula than printed."""
    marks = re.compile(r"\\vphantom\{(\\frac\{V\}\{V\}|\\sqrt\{V_\{dj\}\^2\})\}|\\(begin|end)\{aligned\}|"
                       r"\\(misprint|mended|Bigl|Bigr|left\.?|right\.?)|[{}&\s\\]")
    faults = []
    for entry in ledger:
        departure, departs = departures[entry["equation"]], entry["departure"] != "none"
        printed, statement = marks.sub("", departure.printed), marks.sub("", entry["statement"])
        differs = r"\misprint{" in departure.printed and r"\mended{" in departure.holds
        faults += [f"docs/ledger/departures.json: ({entry['equation']}) {told}" for told, there in (
            ("has a sentence and does not depart", departure.said and not departs),
            ("departs from the print and has no sentence", departs and not departure.said),
            ("is refuted as printed and does not say why", entry["printed"] == "refuted" and not departure.why),
            (f"without its marks is not the printed formula: {printed} against {statement}", printed and printed != statement),
            ("shows no difference", printed and not differs and entry["equation"] != "68")) if there]
    return faults
