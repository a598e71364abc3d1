"""The derivation as a chapter: prose by hand, every formula from the run.

A file is a page, whose parts are apart by empty lines: `# Title` first; `## Title` begins a section; in a paragraph `$...$` is a
formula, `` `...` `` is code, and the number of an equation in brackets becomes a link. Place-holders stand by themselves:
`{{equation 26}}` is the form that holds, `{{steps A.5/constants}}` the steps of a claim as the run recorded them,
`{{claims 26}}` a list of the claims on an equation whose steps the chapter does not show, `{{figure fig08_loaded_mass_response}}`
a figure, `{{explore 57}}` the picture to explore an equation. `[words](page:label)` links to another page.
"""
import re

from .equations import steps_of
from .records import record_of
from .text import Fault, told_in, typeset


def read_chapter(folder):
    """The files by the name of their page, the first one of the chapter first."""
    in_order = sorted(folder.glob("*.md"), key=lambda file: (file.stem != "chapter", file))
    return {f"derivation_{file.stem}": file.read_text() for file in in_order}


def places_in_chapter(files):
    """The page and its title where the chapter shows each equation."""
    return {equation: (name, files[name].partition("\n")[0].removeprefix("# "))
            for name in reversed(files) for equation in re.findall(r"\{\{equation (.*?)\}\}", files[name])}


def chapter_views(run, files, faults):
    """What the template shows of each page. A claim on a result that the chapter leaves out is a fault, too."""
    mentioned = {claim for content in files.values() for claim in re.findall(r"\{\{steps (.*?)\}\}", content)}
    known = {"equation": run.entries, "claims": run.entries, "steps": run.claims, "explore": run.places, "figure": run.figures}
    names = list(files)

    def piece(block, place):
        """A section, a paragraph or a place-holder."""
        if block.startswith("## "):
            return {"kind": "section", "text": block[3:]}
        if not block.startswith("{{"):
            return {"kind": "text", "text": typeset(block.replace("\n", " "), place)}
        kind, _, name = block.removeprefix("{{").removesuffix("}}").partition(" ")
        if not block.endswith("}}") or name not in known.get(kind, {}):
            raise Fault("a place-holder must stand by itself, like {{equation 26}}: one of " + ", ".join(known) +
                        f", and a name of the run, not {block}, in {place}")
        shown, claims = known[kind][name], []
        for claim in shown["claims"] if kind == "claims" else []:
            record = record_of(run, claim["id"])
            if claim["role"] != "observation" and record["claim"] not in mentioned:
                mentioned.add(record["claim"])
                claims.append((claim, record))
        steps = steps_of(run, shown) if kind == "steps" else []
        return {"kind": kind, "name": name, "shown": shown, "claims": claims, "steps": steps}

    views = []
    for at, name in enumerate(names):
        head, *blocks = re.split(r"\n\n+", files[name].strip())
        if not head.startswith("# "):
            faults.append(f"the file of {name} must begin with # and a title")
        pieces = []
        for block in blocks:
            with told_in(faults):
                pieces.append(piece(block, f"docs/chapter, page {name}"))
        views.append(dict(name=name, title=head[2:], pieces=pieces, first=at == 0, subpages=[] if at else names[1:],
                          previous=names[at - 1] if at > 1 else None, next=names[at + 1] if at + 1 < len(names) else None))
    for entry in run.ledger:
        for claim in entry["claims"] if entry["kind"] == "result" else []:
            claimed = record_of(run, claim["id"])["claim"]
            if claim["role"] != "observation" and claimed not in mentioned:
                faults.append(f"claim {claimed} is on a result of the chapter, which does not mention it")
    return views
