"""Text for Doxygen: what is special to it is escaped; formulas, symbols and the numbers of equations become what they are."""
import math
import re
from contextlib import contextmanager
from functools import cache

EQUATIONS = [str(n) for n in range(1, 89)] + [f"A.{n}" for n in range(1, 16)]
GREEK = set("alpha beta gamma delta zeta eta theta kappa mu pi phi psi sigma tau omega Omega Sigma Psi".split())
BARRED = {"X": r"\overline{X}", "x": r"\bar{x}", "K": r"\overline{K}", "C": r"\overline{C}", "M": r"\overline{M}"}
WORD = re.compile(r"\w+", re.ASCII)
OPERATORS = {"<=": "≤", ">=": "≥", "->": "→", "sqrt": "√"}
TOKEN = re.compile(r"""(?<![\w\\])\((?P<equation>(?:A\.)?[0-9]+)\)|<=|>=|->|sqrt(?=\()|
    (?P<number>(?<![\w.])(?:\d+\.\d{9,}|\d+(?:\.\d+)?e[+-]?\d+)(?![\w.]*\w))|
    (?P<function>sinh?|cosh?|exp)\((?P<of>\w+)\)|
    (?<=[./:`#])(?<!(?<!\w)1/)(?!r_n,i)\w+|\w+(?=[(:*`]|\.\w)|  # part of a path or of a name
    (?P<word>r_n,i|\w+)(?P<value>=\d(?:[\d.]*\d)?(?:e[+-]?\d+)?|\^\d+(?![\w.]))?(?P<primes>'*)|.""", re.A | re.S | re.X)


class Fault(Exception):
    """Why a page cannot be made, in a sentence."""


@contextmanager
def told_in(faults):
    """What is made within may have a fault, which is added to a list."""
    try:
        yield
    except Fault as fault:
        faults.append(str(fault))


def html(text):
    """Text for an attribute or a raw block of HTML."""
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;").replace('"', "&quot;")


def escaped(text):
    """Text that Doxygen shows as it is."""
    return re.sub(r"[\\@$#%*_`\[\]]", r"\\\g<0>", html(text))


formula = r"\f${}\f$".format  # in a line
displayed = "\n\\f[ {} \\f]\n".format  # on a line of its own


def raw(text):
    """A text of Doxygen's as HTML, for the head of a fold, which can have no link in it."""
    text = re.sub(r"\\f\$(.*?)\\f\$", r"\(\1\)", text)
    text = re.sub(r'\\ref (\w+) "([^"]*)"', r"\2", text)
    return re.sub(r"\\([@$#%*_`\[\]])", r"\1", text)


def label(kind, name):
    return re.sub(r"\W", "_", f"{kind}_{name}", flags=re.ASCII)


def equation_label(equation):
    return label("eq", equation)


def equation_link(equation):
    return rf'\ref {equation_label(equation)} "({equation})"'


def equation_links(equations):
    return ", ".join(map(equation_link, equations)) or "nothing"


def source_link(place, shown):
    """A link to a line of a source, resolved when the site is there."""
    return f'<a href="source:{place["file"]}:{place["line"]}">{escaped(shown)}</a>'


@cache
def symbol(name, alone):
    """LaTeX of a symbol that the run names in plain text, e.g. `zeta_i`; empty where it is none. Alone, a letter is one. V_dj,
    U_dj, S_dj, v_di, u_di, s_di of the paper have a d that code leaves out."""
    if name in GREEK:
        return "\\" + name
    if alone and len(name) == 1:
        return BARRED.get(name, name)
    base, _, below = name.partition("_")
    if not 1 <= len(below) <= 3 or "_" in below or base not in GREEK and len(base) != 1:
        return ""
    if base in tuple("VUSvus") and not below.startswith("d"):
        below = "d" + below
    return BARRED.get(base, "\\" + base if base in GREEK else base) + "_{" + {"lim": r"\lim"}.get(below, below) + "}"


def legible(number):
    """A decimal of a program to six digits where it has all digits of a double, with a power of ten where it has an exponent."""
    if re.fullmatch(r"-?\d+\.\d{9,}", number):
        return digits(float(number), 6).replace("$", "")
    return digits(float(number), min(6, len(re.sub(r"e.*|\D", "", number)))).replace("$", "") if "e" in number else number


def spelled(text):
    """A text with the names of scenes in words: `2DOF j=2 l=1 #7` is two masses, j=2, l=1, scene 7."""
    masses = {"S": "one mass", "2": "two masses", "3": "three masses", "4": "four masses", "5": "five masses"}
    text = re.sub(r"\b([S2-5])DOF\b( (?=\w+=))?", lambda name: masses[name[1]] + (", " if name[2] else ""), text)
    text = re.sub(r"(=[^\s;()]*[^\s;(),]) (?=[a-zA-Z]\w*=|#\d|undamped)", r"\1, ", text)
    text = re.sub(r"(?<= )#(?=\d)", "scene ", text).replace("seed 2022 N", "seed 2022, N")
    grid = "on the grid of the paper's scenes, "
    return text.replace(f"off by up to 0 % {grid}", f"right {grid}off by up to ")


def token_text(found):
    """What is shown in place of an equation's number, of a number, a symbol, a function of one, an operator, or of other text."""
    text, word, value, argument = found[0], found["word"], found["value"] or "", symbol(found["of"] or "", False)
    if found["equation"] in EQUATIONS:
        return equation_link(found["equation"])
    if found["number"]:
        return formula(legible(text)) if "\\" in legible(text) else legible(text)
    if argument:
        return formula(rf"\{found['function']}({argument})")
    if not word:
        return OPERATORS.get(text) or escaped(text)
    latex = "r_{n,i}" if word == "r_n,i" else symbol(word, False) or (word if value and re.fullmatch("[A-Za-z]", word) else "")
    if not latex:
        return escaped(word) + prose(value) + found["primes"]
    after = f"^{{{value[1:]}}}" if value[:1] == "^" else "=" + legible(value[1:]) if value else ""
    return formula(latex + after + found["primes"])


@cache
def prose(text):
    """A sentence of the run: escaped, its symbols typeset, its scenes in words, the numbers of equations linked."""
    return TOKEN.sub(token_text, spelled(text))


def typeset(text, place):
    """Text with formulas between dollars, code between backquotes and links, [words](page:label); the rest as `prose`."""
    marked = r"\$[^$]*\$|`[^`]*`|\[[^\]]*\]\(page:\w+\)"
    if unclosed := re.search("[$`].*", re.sub(marked, "", text)):
        raise Fault(f"a formula or code must be closed, not '{unclosed[0][:40]}', in {place}")
    out = ""
    for part in re.split(f"({marked})", text):
        if link := re.fullmatch(r"\[(.*)\]\(page:(.*)\)", part):
            out += f'<a href="{link[2]}.html">{link[1]}</a>'
        elif part.startswith("$"):
            out += formula(part[1:-1])
        else:
            out += f"<code>{escaped(part[1:-1])}</code>" if part.startswith("`") else prose(part)
    return out


def sentence(note):
    """A sentence that a note becomes: its first word with a capital unless it is a symbol, a full stop at its end."""
    word = WORD.match(note)
    if len(note) > 1 and note[0].islower() and not (word and symbol(word[0], True)):
        note = note[0].upper() + note[1:]
    return prose(note) + ("" if note.endswith(".") else ".")


def witness_value(value):
    """A fraction typeset, a decimal with the digits that somebody reads."""
    if fraction := re.fullmatch("(-?)([0-9]+)/([0-9]+)", value):
        return formula(rf"{fraction[1]}\tfrac{{{fraction[2]}}}{{{fraction[3]}}}")
    return prose(value.replace("E", "e") if re.fullmatch(r"-?[0-9.]+E-?\d+", value) else value)


def digits(value, count):
    """A number to so many digits, 0.0134 or 4.3 x 10^6; one that has fewer is written with these, 0.4 and not 0.400."""
    rounded = f"{value:.{count - 1}e}"
    mantissa, power = rounded.split("e")
    exact = math.isclose(float(rounded), value, rel_tol=1e-9)
    if value == 0 or -4 <= int(power) < 6:
        return f"{float(rounded):.15g}" if exact else f"{float(rounded):.{max(count - 1 - int(power), 0)}f}"
    return rf"${mantissa}\cdot10^{{{int(power)}}}$"


def counted(n, one, many):
    return f"{n} {one if n == 1 else many}"


def verdict_text(verdict):
    return {"illegible": "illegible in the text at hand", "not_applicable": "not applicable"}.get(verdict, verdict)


def verdict_mark(verdict):
    return f'<span class="verdict {verdict.replace("_", "-")}">{verdict_text(verdict)}</span>'


def fails(verdict):
    """Whether a printed form does not hold as it stands."""
    return verdict in ("refuted", "illegible")


def statement_that_holds(entry):
    return entry["correction"] or entry["statement"]


def without_marks(latex):
    return latex.replace(r"\misprint", "").replace(r"\mended", "")


def function_link(function):
    name = function["name"]
    shown = name.removeprefix("denhartog::")
    if name.endswith("::operator"):  # the index of functions cuts its name here; Doxygen knows the class
        name, shown = name[:-10], shown + "()"
    return rf'\ref {name} "{shown}"'


def claim_link(record):
    return rf'\ref {label("claim", record["claim"])} "{record["claim"]}"'
