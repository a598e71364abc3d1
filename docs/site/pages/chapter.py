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
    named_by = lambda kind: re.findall(r"\{\{" + kind + r" (.*?)\}\}", "\n".join(files.values()))
    known = {"equation": run.entries, "claims": run.entries, "steps": run.claims, "explore": run.places, "figure": run.figures}
    names, mentioned = list(files), set(named_by("steps"))
    others = {entry["equation"]: [(claim, record) for claim in entry["claims"] if claim["role"] != "observation"
                                  and (record := record_of(run, claim["id"]))["claim"] not in mentioned] for entry in run.ledger}
    mentioned |= {record["claim"] for equation in named_by("claims") for _, record in others.get(equation, [])}
    faults += [f"claim {record['claim']} is on a result of the chapter, which does not mention it" for entry in run.ledger
               if entry["kind"] == "result" for _, record in others[entry["equation"]] if record["claim"] not in mentioned]

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
        shown = others[name] if kind == "claims" else known[kind][name]
        return {"kind": kind, "name": name, "shown": shown, "steps": steps_of(run, shown) if kind == "steps" else []}

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
    return views
