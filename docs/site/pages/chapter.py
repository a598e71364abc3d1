"""The derivation as a chapter: prose by hand, every formula from the run.

A file is a page. It begins with `# Title`; `## Title` begins a section, an empty line ends a paragraph; `$...$` is a formula,
`` `...` `` is code, and the number of an equation in brackets becomes a link. Place-holders stand on lines of their own:
`{{equation 26}}` is the form that holds, `{{printed 26}}` the printed one, `{{steps A.5/constants}}` the steps of a claim as the
run recorded them, `{{claims 26}}` a list of the claims on an equation whose steps the chapter does not show.
"""
import re
from types import SimpleNamespace

from .equations import steps_of
from .records import record_of
from .text import EQUATIONS, Fault, typeset

CHAPTER = set(EQUATIONS[3:72] + EQUATIONS[88:])  # (4)-(72) and the appendix


def read_chapter(folder):
    """The files by the name of their page, the first one of the chapter first."""
    files = {f"derivation_{file.stem}": file.read_text() for file in sorted(folder.glob("*.md"), key=lambda f: (f.stem != "chapter", f))}
    if "derivation_chapter" not in files:
        raise Fault(f"the chapter must have a file chapter.md in {folder}")
    return files


class Chapter:
    """Writes the pages of the chapter, and knows which claims they have mentioned."""

    def __init__(self, run, files):
        self.run, self.files, self.faults, self.listed = run, files, [], set()
        self.shown = {claim for text in files.values() for claim in re.findall(r"\{\{steps (.*?)\}\}", text)}

    def entry(self, equation):
        if equation not in self.run.entries:
            raise Fault(f"the ledger must have an entry for equation ({equation})")
        return self.run.entries[equation]

    def placeholder(self, line, place):
        found = re.fullmatch(r"\{\{(\w+) (.*?)\}\}", line)
        if not found or found[1] not in ("equation", "printed", "steps", "claims"):
            raise Fault(f"a place-holder must be {{{{equation|printed|steps|claims name}}}} on a line of its own, not {line}, in {place}")
        kind, name = found.groups()
        if kind == "steps":
            if name not in self.run.claims:
                raise Fault(f"a place-holder must name a claim of the run, not {name}, in {place}")
            return SimpleNamespace(kind=kind, record=self.run.claims[name], steps=steps_of(self.run.claims[name]))
        entry, claims = self.entry(name), []
        for claim in entry["claims"] if kind == "claims" else []:
            record = record_of(self.run, claim["id"])
            if claim["role"] != "observation" and record["claim"] not in self.shown | self.listed:
                self.listed.add(record["claim"])
                claims.append((claim, record))
        return SimpleNamespace(kind=kind, entry=entry, equation=name, claims=claims)

    def page(self, name):
        title, pieces, text, sections = "", [], [], 0
        for number, line in enumerate(self.files[name].splitlines() + [""], 1):
            place = f"docs/chapter, page {name}, line {number}"
            try:
                if text and (not line or line.startswith(("## ", "{{"))):
                    paragraph, text = " ".join(text), []
                    pieces.append(SimpleNamespace(kind="text", text=typeset(paragraph, place)))
                if line.startswith("# "):
                    title = line[2:]
                elif line.startswith("## "):
                    sections += 1
                    pieces.append(SimpleNamespace(kind="section", number=sections, text=line[3:]))
                elif line.startswith("{{"):
                    pieces.append(self.placeholder(line, place))
                elif line:
                    text.append(line)
            except Fault as fault:
                self.faults.append(str(fault))
        if not self.files[name].startswith("# "):
            self.faults.append(f"the file of {name} must begin with # and a title")
        names = list(self.files)
        at = names.index(name)
        return dict(name=name, title=title, pieces=pieces, parts_of=None if at else names[1:],
                    previous=names[at - 1] if at > 1 else None, next=names[at + 1] if at + 1 < len(names) else None)

    def pages(self):
        """What the template shows of each page; then the faults are known: a claim on a result that the chapter leaves out is one."""
        views = [self.page(name) for name in self.files]
        for entry in self.run.ledger:
            for claim in entry["claims"] if entry["kind"] == "result" and entry["equation"] in CHAPTER else []:
                name = record_of(self.run, claim["id"])["claim"]
                if claim["role"] != "observation" and name not in self.shown | self.listed:
                    self.faults.append(f"claim {name} is on a result of the chapter, which does not mention it")
        return views
