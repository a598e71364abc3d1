"""All generated pages: each kind has a template; the pages are Doxygen's, which resolves links to what is in the sources."""
import json
import re
from itertools import count
from pathlib import Path

import jinja2

from . import text
from .chapter import chapter_views, places_in_chapter, read_chapter
from .code import code_of, javascript_of
from .conclusions import conclusions_of
from .equations import SAMPLES, SAMPLES_OF_MODES, equation_view, in_namespace, statement_of, theorems_of, witness_names
from .records import faults_of_departures, faults_of_stand_ins, read_run, record_of, told
from .sources import Sources
from .text import EQUATIONS, Fault, html, told_in, verdict_text

SECTIONS = {"1": "Introduction", "2.1": "Formulation", "2.2": "Modal superposition", "2.3": "The mass in contact",
            "2.4": "Time response", "2.5": "The other masses", "2.6": "Domain of validity", "3.1": "Numerical approach",
            "3.2.1": "Time responses", "3.2.2": "Amplitudes, phases and regimes", "4.1": "Resonances",
            "4.2": "Low and high frequency ratios", "4.3": "Invariant points and the stuck contact", "5": "Concluding remarks"}
DEPARTURES = {"scan": "a slip of the scan", "misprint": "a misprint: the paper's own other equations contradict it",
              "substance": "an error of substance: it does not hold as it is meant",
              "convention": "a convention that the paper does not state"}


def tables(markdown, prefix):
    """A text of the surveys, whose tables Doxygen reads, with its words typeset and labels for its headings."""
    for table in re.findall(r"(?:^\|.*\n)+", markdown, re.M):
        if len({line.count("|") for line in table.splitlines()}) > 1:
            raise Fault(f"a row of a table must have as many cells as its head: {table}")
    number = count(1)
    return "\n".join(rf"\section {prefix}_{next(number)} {line.lstrip('# ')}" if line.startswith("#") else
                     text.typeset(line, "a table of measurements") for line in markdown.splitlines())


def drawn_graph(dot):
    """A graph in the language of Graphviz as a picture within a page, without the lines that follow from others."""
    drawn = told("dot", "-Tsvg", asked=told("tred", asked=dot))
    svg = drawn[drawn.index("<svg"):].replace("xlink:title", "aria-label")  # what a link is called
    return re.sub(r'(?<=\d)pt(?=")|xlink:(?=href)', "", svg)


def environment(run, sources):
    """Jinja with the words of the pages as filters."""
    templates = Path(__file__).parent.parent / "templates"
    jinja = jinja2.Environment(loader=jinja2.FileSystemLoader(templates), undefined=jinja2.StrictUndefined, trim_blocks=True,
                               keep_trailing_newline=True, comment_start_string="<!--#", comment_end_string="#-->")
    jinja.filters |= {name: word for name, word in vars(text).items() if callable(word)} | dict(
        code_of=code_of, javascript_of=javascript_of, in_namespace=in_namespace,
        departure_text=lambda kind: DEPARTURES.get(kind, "none"),
        error=lambda worst: "not finite" if worst is None else text.typeset(text.digits(worst, 2), "an error"),
        snippet=sources.snippet, number="{:.10g}".format,
        sample=lambda name, of_modes: SAMPLES_OF_MODES[name] if of_modes else SAMPLES.get(name, "1"),
        names=lambda witness, claim="": witness_names(run, witness, claim), record=lambda claim: record_of(run, claim),
        statement_of_theorem=lambda of: re.search(rf"Definition {of['name']} : Prop :=.*?\.(?=\n)|\Z", run.theorems, re.S)[0],
        section_title=lambda section: f"{section} {SECTIONS[section]}" if section in SECTIONS else section,
        tables=tables, conclusions_of=conclusions_of, drawn_graph=drawn_graph, theorems_of=theorems_of)
    jinja.globals |= dict(run=run, chapter={}, ledger=run.ledger, departures=run.departures,
                          said_of=lambda equation: text.typeset(run.departures[equation].said, "departures.json"))
    jinja.globals["part"] = jinja.get_template("parts.html").module
    return jinja


def faults_of_pages(pages):
    """A sentence for each page with a dollar outside of a formula or a place-holder that nothing replaced. Doxygen finds labels
    that are there twice or not at all, formulas that are not closed and LaTeX outside of them; KaTeX, a formula that is wrong."""
    raw = re.compile(r"\\f\$.*?\\f\$|\\f\[.*?\\f\]|\\htmlonly.*?\\endhtmlonly|\\code.*?\\endcode", re.S)
    what = {"$": "a dollar outside of a formula", "{": "a place-holder that nothing replaced"}
    return [f"page {name} has {what[found[0][0]]}: {found[0]}" for name, page in pages.items()
            if (found := re.search(r"(?<!\\)\$.*|\{\{.*", raw.sub("", page)))]


def make_pages(run, sources, chapter):
    """The pages by name, and why they cannot be taken, a sentence each."""
    faults = faults_of_departures(run.departures, run.ledger) + faults_of_stand_ins(run)
    if faults:
        return {}, faults
    jinja, pages, files = environment(run, sources), {}, read_chapter(chapter)
    jinja.globals["chapter"] = places_in_chapter(files)

    def add(name, template, view):
        page = jinja.get_template(f"{template}.html").render(view)
        contents = ", ".join(rf'\ref {label} "{title}"' for label, title in re.findall(r"\\section (\S+) (.*)", page))
        page = page.replace("<!--contents-->", contents)
        pages[name] = re.sub(r"\n*(\n\\(?:sub)?section .*\n)\n*", r"\n\1\n", page)  # a heading stands apart

    for figure in run.figures.values():
        with told_in(faults):
            add(figure.label, "figure", dict(figure=figure, program=figure.script.removesuffix("gp") + "cpp"))
    for equation in EQUATIONS:
        with told_in(faults):
            view = equation_view(run, sources, run.entries[equation])
            add(view["name"], "equation", view)
            if view["more"]:
                add(view["name"] + "_more", "equation_more", view)
    for name in ("home", "equations", "errata", "errata_sheet", "stand_ins", "figures_page", "speed_page", "conformance_page",
                 "audit", "accuracy_page", "conclusions", "equation_graph", "theorems"):
        with told_in(faults):
            add(name, name, {})
    for view in chapter_views(run, files, faults):
        add(view["name"], "chapter", view)
    return pages, sorted(set(faults or faults_of_pages(pages)))  # a page that could not be made is missed by all that link to it


def script_files(run):
    """What the scripts of the pages read: symbols and statements for the formulas, places to go to, accuracy as a table."""
    as_json = lambda value: json.dumps(value, indent=0, ensure_ascii=False)
    in_html = lambda words: re.sub("`(.*?)`", r"<code>\1</code>", re.sub(r"\$(.*?)\$", r"\\(\1\\)", html(words)))
    symbols = [vars(symbol) | {"meaning": in_html(symbol.meaning)} for symbol in run.notation]
    statements, places = {}, {}
    for entry in run.ledger:
        said = ". ".join(filter(None, (f"as printed: {verdict_text(entry['printed'])}", run.departures[entry["equation"]].said)))
        statements[entry["equation"]] = {"said": in_html(said), "latex": statement_of(run, entry).plain}
        places.setdefault(f"section {entry['section']}", f"equations.html#{text.label('equations', entry['section'])}")
    places |= {f"figure {figure.number[5:]}": f"{figure.label}.html" for figure in run.figures.values() if figure.number}
    columns = ("function", "type", "zone", "points", "printed", "shipped", "shipped_at")
    rows = [",".join(json.dumps(row[column], ensure_ascii=False) for column in columns) for row in run.accuracy]
    return {"accuracy.csv": "\n".join([",".join(columns)] + rows) + "\n", "symbols.json": as_json(symbols) + "\n",
            "statements.json": as_json(statements) + "\n", "sections.js": f"window.siteSections = {as_json(places)};\n"}


def write(run, source, output):
    """Makes and writes the pages of a run. Returns what was done and the faults; with faults nothing is written."""
    record = read_run(run, source)
    pages, faults = make_pages(record, Sources(source), source / "docs/chapter")
    if faults:
        return "", faults
    output.mkdir(parents=True, exist_ok=True)
    for file in output.glob("*.md"):  # pages of an earlier run
        file.unlink()
    for name, content in ({f"{name}.md": page for name, page in pages.items()} | script_files(record)).items():
        (output / name).write_text(content)
    return f"{len(pages)} pages", []
