"""What the pages take from the sources: the lines of functions, and where claims stand."""
import re
from collections import namedtuple
from itertools import takewhile
from pathlib import Path

from .text import Fault, prose

Snippet = namedtuple("Snippet", "text brief")

LITERAL = r'"(?:[^"\\]|\\.)*"'


class Sources:
    """The sources of the project."""

    def __init__(self, root):
        self.root, self.ids, self.literals = Path(root), {}, {}
        for file in sorted((self.root / "derivation").rglob("*.cpp")):
            self.read_claims(file.relative_to(self.root).as_posix(), file.read_text())

    def read_claims(self, name, text):
        """Keeps the literals of a source: those with a slash, the ones that a claim takes as its id rather than others, and those
        without, by source."""
        for number, line in enumerate(text.splitlines(), 1):
            for is_id, literal in re.findall(rf"(\.id = )?({LITERAL})", line.partition("//")[0]):
                key = literal[1:-1] if "/" in literal else (name, literal[1:-1])
                (self.ids if is_id else self.literals).setdefault(key, dict(file=name, line=number))

    def claim(self, claim):
        """Where a claim is made, of whose id a source may have the beginning and the rest apart."""
        for literals in (self.ids, self.literals):
            for at in range(len(claim), 0, -1):
                if claim[:at] in literals and (claim[at - 1] in "=/" or claim[at:at + 1] in ("", "/")):
                    place = literals[claim[:at]]
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
