"""What can be wrong with the pages before Doxygen reads them."""
import re

from .text import EQUATIONS, equation_label

LATEX = re.compile(r"\\(?:frac|bar\{|overline|sqrt|beta|tau|zeta|psi|begin\{|left|cos|sin)")
RAW = re.compile(r"\\f\$(.*?)\\f\$|\\f\[(.*?)\\f\]|\\htmlonly.*?\\endhtmlonly", re.S)


def faults_of_formula(latex):
    """What is wrong with a formula: nothing may open that does not close."""
    braces = re.sub(r"[^{}]|\\.", "", latex, flags=re.S)
    while "{}" in braces:
        braces = braces.replace("{}", "")
    return ["has a formula whose braces do not match"] * (braces != "") + ["has a formula within a formula"] * (r"\f[" in latex)


def faults_of_pages(pages):
    """A sentence for each equation without a page, label that is there twice or not at all, formula that is not closed or whose
    braces do not match, LaTeX or a dollar outside of a formula, and place-holder that nothing replaced."""
    faults, labels, texts = [], set(), {}
    for name, text in pages.items():
        for latex in (found[1] or found[2] or "" for found in RAW.finditer(text)):
            faults += [f"page {name} {fault}: {latex[:60]}" for fault in faults_of_formula(latex)]
        texts[name] = RAW.sub("", text)
        if found := re.search(r"\\(f[$\[\]]|htmlonly).*", texts[name], re.S):
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
