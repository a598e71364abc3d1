"""What the pages take from the sources: the lines of functions, and where claims stand."""
import re
from collections import namedtuple
from itertools import takewhile
from pathlib import Path

from .text import Fault, prose

Snippet = namedtuple("Snippet", "text brief")

LITERAL = r'"((?:[^"\\]|\\.)*)"'


class Sources:
    """The sources of the project."""

    def __init__(self, root):
        self.root, self.literals = Path(root), {}  # where each literal of the derivation stands first, in all and in its source
        for file in sorted((self.root / "derivation").rglob("*.cpp")):
            name = file.relative_to(self.root).as_posix()
            for number, line in enumerate(file.read_text().splitlines(), 1):
                for mark, literal in re.findall(rf"(\.id = )?{LITERAL}", line.partition("//")[0]):
                    for key in (mark + literal, (name, literal)):
                        self.literals.setdefault(key, dict(file=name, line=number))

    def claim(self, claim):
        """Where a claim is made, of whose id a source may have the beginning and the rest apart."""
        for mark in (".id = ", ""):
            for at in range(len(claim), claim.find("/"), -1):
                if place := self.literals.get(mark + claim[:at]):
                    return self.literals.get((place["file"], claim[at:] or None), place)
        raise Fault(f"claim {claim} must be made in a source under derivation")

    def snippet(self, function):
        """A function or a type of the ledger, from its template head to its closing brace."""
        name, file, at = function["name"], function["file"], function["line"]
        lines = (self.root / file).read_text().split("\n")
        word = name.rpartition("::")[2]
        if not 1 <= at <= len(lines) or not re.search(rf"(?<!\w){re.escape(word)}(?!\w)", lines[at - 1], re.ASCII):
            raise Fault(f"{name} must stand where the ledger has it, {file}:{at}; run ./verify paper again")
        first = next(n for n in range(at - 1, -1, -1) if re.match(r"\s*($|//|#)|.*[;{}]\s*$", lines[n - 1]))
        ends = re.compile(rf"{re.match(' *', lines[first])[0]}(\S.*)?[;}}]\s*(//.*)?$")  # no further to the right than it began
        end = next(n for n in range(first, len(lines)) if ends.match(lines[n]))
        return Snippet("\n".join(lines[first:end + 1]), self.brief(lines, first))

    @staticmethod
    def brief(lines, first):
        """The first sentence after @brief in the comment above a line, its formulas as Doxygen has them; and the domain."""
        comment = list(takewhile(lambda line: line.startswith("///"), reversed(lines[:first])))
        told = " ".join(line.removeprefix("///").strip() for line in reversed(comment))
        found = re.search(r"@brief (.*?)(?=\.(?: |\Z)| \\f\[| @|\Z)", told)
        domain = re.search(r"@domain\{(.*?)\}(?= |\Z)", told)
        return (found[1].strip() + "." if found else "") + (f" Domain: {prose(domain[1])}." if domain else "")
