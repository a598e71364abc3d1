"""What can be wrong with the pages before Doxygen reads them."""
import re

from .text import EQUATIONS, equation_label

LATEX = re.compile(r"\\(?:frac|bar\{|overline|sqrt|beta|tau|zeta|psi|begin\{|f\[|f\]|left|cos|sin)")
RAW = {r"\f$": r"\f$", r"\f[": r"\f]", r"\htmlonly": r"\endhtmlonly"}


def outside(name, text, faults):
    """The text without formulas and raw blocks."""
    out, at = "", 0
    for found in re.finditer(r"\\f\$|\\f\[|\\htmlonly", text):
        if found.start() < at:
            continue
        out += text[at:found.start()]
        end = text.find(RAW[found[0]], found.end())
        if end < 0:
            faults.append(f"page {name} has a formula that is not closed: {text[found.start():][:60]}")
            return out
        inner = text[found.end():end]
        at = end + len(RAW[found[0]])
        if found[0] == r"\htmlonly":
            continue
        if not braces_match(inner):
            faults.append(f"page {name} has a formula whose braces do not match: {inner[:60]}")
        if r"\f[" in inner:
            faults.append(f"page {name} has a formula within a formula")
    return out + text[at:]


def braces_match(latex):
    depth = 0
    for brace in re.findall(r"[{}]", re.sub(r"\\.", "", latex, flags=re.S)):
        depth += 1 if brace == "{" else -1
        if depth < 0:
            return False
    return depth == 0


def faults_of_pages(pages):
    """A sentence for each equation without a page, label that is there twice or not at all, formula that is not closed or whose
    braces do not match, LaTeX or a dollar outside of a formula, and place-holder that nothing replaced."""
    faults, labels = [], {}
    texts = {name: outside(name, text, faults) for name, text in pages.items()}
    for name, text in texts.items():
        for label in re.findall(r"(?:\{#|\\section |\\subsection |\\anchor )([^\s}]*)", text):
            if label in labels:
                faults.append(f"label {label} is there twice, on page {name}")
            labels[label] = name
    for name, text in texts.items():
        for found in LATEX.finditer(text):
            faults.append(f"page {name} has LaTeX outside of a formula: {text[found.start():][:40]}")
        if found := re.search(r"(?<!\\)\$", text):
            faults.append(f"page {name} has a dollar outside of a formula: {text[found.start():][:40]}")
        if "{{" in text:
            faults.append(f"page {name} has a place-holder that nothing replaced")
        for label in re.findall(r"\\(?:ref|subpage) ([^\s}]*)", text):
            if "::" not in label and label not in labels:
                faults.append(f"page {name} links to {label}, a label that is not there")
    return faults + [f"equation ({equation}) has no page" for equation in EQUATIONS if equation_label(equation) not in labels]
