"""What can be wrong with the pages before Doxygen reads them."""
import re

from .text import EQUATIONS, equation_label

LATEX = re.compile(r"\\(?:frac|bar\{|overline|sqrt|beta|tau|zeta|psi|begin\{|left|cos|sin)")
RAW = re.compile(r"\\f\$.*?\\f\$|\\f\[.*?\\f\]|\\htmlonly.*?\\endhtmlonly", re.S)


def faults_of_pages(pages):
    """A sentence for each equation without a page, label that is there twice or not at all, formula that is not closed,
    LaTeX or a dollar outside of a formula, and place-holder that nothing replaced. KaTeX rejects a formula that is wrong in itself."""
    faults, labels, texts = [], set(), {name: RAW.sub("", text) for name, text in pages.items()}
    for name, text in texts.items():
        if found := re.search(r"\\(f[$\[\]]|htmlonly).*", text, re.S):
            faults.append(f"page {name} has a formula that is not closed: {found[0][:60]}")
    for name, text in texts.items():
        for label in re.findall(r"(?:\{#|\\section |\\subsection |\\anchor )([^\s}]*)", text):
            if label in labels:
                faults.append(f"label {label} is there twice, on page {name}")
            labels.add(label)
    for name, text in texts.items():
        for what, mark in (("LaTeX", LATEX), ("a dollar", re.compile(r"(?<![\\f])\$"))):
            faults += [f"page {name} has {what} outside of a formula: {text[at.start():][:40]}" for at in mark.finditer(text)]
        if "{{" in text:
            faults.append(f"page {name} has a place-holder that nothing replaced")
        for label in re.findall(r"\\(?:ref|subpage) ([^\s}]*)", text):
            if "::" not in label and label not in labels:
                faults.append(f"page {name} links to {label}, a label that is not there")
    return faults + [f"equation ({equation}) has no page" for equation in EQUATIONS if equation_label(equation) not in labels]
