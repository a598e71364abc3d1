"""Passes over the HTML that Doxygen wrote: links to sources and pages; headings, what of Doxygen's pages nobody reads, the list
for the search; and the links of the whole site are followed."""
import json
import os
import re
from xml.etree import ElementTree

from .doxygen import cut, text_of_html, trim

PAPER = "https://doi.org/10.1016/j.jsv.2022.117085"
LONGEST_TEXT = 1200  # bytes that the search keeps of a page


# Links to sources and pages


def read_tags(tagfile, root):
    """The addresses of pages by their labels, and of sources by their paths from the root."""
    addresses = {}
    for compound in ElementTree.parse(tagfile).iterfind("compound"):
        path, name, file = map(compound.findtext, ("path", "name", "filename"))
        if compound.get("kind") == "page":
            addresses[f"page:{name}"] = file.removesuffix(".html") + ".html"
        elif compound.get("kind") == "file":
            addresses[f"source:{os.path.relpath(root / path / name, root)}"] = file.removesuffix(".html") + "_source.html"
    return addresses


def with_links(page, addresses, missing, targets):
    """A page with its links `source:FILE:LINE`, `source:FILE` and `page:LABEL` resolved."""
    def resolved(link):
        target, line = link[1], ""
        if target not in addresses:
            target, _, line = target.rpartition(":")
        if target not in addresses or (line and not re.fullmatch("[0-9]{1,6}", line)):
            missing.add(link[1])
            return link[0]
        address = addresses[target] + (f"#l{int(line):05d}" if line else "")
        targets.add(address)
        return f'href="{address}"'

    return re.sub(r'href="((?:source|page):[^"]*)"', resolved, page)


def link(site, tagfile, source):
    """Resolves the links of all pages; with faults nothing is written."""
    addresses, changed, faults, targets = read_tags(tagfile, source.resolve()), {}, set(), set()
    for file in sorted(site.rglob("*.html")):
        missing = set()
        changed[file] = with_links(file.read_text(), addresses, missing, targets)
        faults |= {f"{file.name} links to {target}, which the site does not have" for target in missing}
    for file, text in {} if faults else changed.items():
        file.write_text(text)
    return f"links to {len(targets)} places in the sources and pages", sorted(faults)


# Headings, tables, the search


def readable_source(page):
    """The page of a source without the marks that Doxygen reads in a comment."""
    page = re.sub(r"\\f\$ ?(.*?) ?\\f\$", r"$\1$", page)
    page = re.sub(r"\\f\[ ?|\\f\]", lambda mark: "$$", page)
    return re.sub(r"@eq\{([^}]*)\}", r"(\1)", page).replace("@brief ", "")


def finished_page(page):
    """A page as readers get it: its title as the heading of first order, wide tables in boxes that scroll."""
    if "<h1>" in page and 'class="memtitle"' not in page:  # sections stand below the title
        page = re.sub("(</?h)([123])>", lambda heading: f"{heading[1]}{int(heading[2]) + 1}>", page)
    page = re.sub(r'<div class="title">(.*?)(?=</div>|<div)', r'<div><h1 class="title">\1</h1>', page, count=1, flags=re.S)
    boxed = r'<div class="table-box" tabindex="0">\g<0></div>'
    page = re.sub('<table class="markdownTable">.*?</table>', boxed, page, flags=re.S)
    page = cut(page, '<div class="summary">', "</div>")  # its links lead to headings that are left out where all is private
    return re.sub('<div class="(fragment|memproto)">', r'<div class="\1" tabindex="0">', page)


def shortened(html):
    """What the search keeps of a text: not too much, and formulas without their TeX."""
    text = re.sub(r"\\[()]|[\\{}]", "", text_of_html(html))
    return text.encode()[:LONGEST_TEXT].decode(errors="ignore")


def kind_of_page(name):
    """0 an equation, 1 a figure or the derivation, 2 another text, 3 what is behind an equation, 4 code: the search's order."""
    if name.startswith("eq_"):
        return 3 if "_more" in name else 0
    if name.startswith(("figure_", "derivation_")):
        return 1
    of_code = name.startswith(("namespace", "struct", "class", "dir_", "functions", "globals", "group__"))
    return 4 if of_code or "_8" in name or "-members" in name else 2


def between(text, opening, closing):
    """What stands between two marks; empty where they are not there."""
    found = re.search(re.escape(opening) + "(.*?)" + re.escape(closing), text, re.S)
    return found[1] if found else ""


def search_documents(page, name):
    """What the search knows of a page: an entry for the page and one for each documented name on it."""
    title = text_of_html(between(page, '<h1 class="title">', "</h1>"))
    if not title:
        return []
    if name_of_equation := between(page, '<span class="named">', "</span>"):
        title += ": " + shortened(name_of_equation)
    body = between(page, '<div class="contents">', "<footer")
    for opening, closing in (('<div class="eq-nav">', "</div>"), ('<p class="eq-contents">', "</p>"),
                             ('<div class="copies">', "</div>"), ("<form", "</form>"), (r"\[", r"\]")):
        body = cut(body, opening, closing)
    first, *items = body.split('<h2 class="memtitle">')
    found = [(title, name, first)]
    for item in items:
        heading = item.partition("</h2>")[0]
        anchor, named = between(heading, 'href="#', '"'), heading.partition("</span>")[2]
        if anchor and "</span>" in heading:
            documented = '<div class="memdoc">'
            found.append((text_of_html("</span>" + named), f"{name}#{anchor}", documented + item.partition(documented)[2]))
    kind = kind_of_page(name)
    return [{"kind": kind, "text": shortened(text), "title": title, "url": url} for title, url, text in found]


def fault_of_link(page, target, site, anchors):
    """Why a link leads nowhere, or elsewhere; None for one that is followed within the site."""
    if "//" in target or target.startswith("mailto:"):
        return f"{page} leads elsewhere: {target}"
    file, _, anchor = re.sub(r"\?[^#]*", "", target).partition("#")
    place = anchors.get(file or page)
    if place is None:
        return None if (site / file).exists() else f"{page} leads to {file}, which is not there"
    return f"{page} leads to {target}, but there is no such place on that page" if anchor and anchor not in place else None


def finish(site):
    """Finishes all pages of a site, writes the list for the search and the map of the site, and follows all links."""
    before = {file.name: file.read_text() for file in sorted(site.glob("*.html"))}
    texts = trim({name: readable_source(text) if name.endswith("_source.html") else finished_page(text)
                  for name, text in before.items()})
    for name in before.keys() - texts.keys():
        (site / name).unlink()
    texts = dict(sorted(texts.items()))
    for name, text in texts.items():
        if text != before.get(name):
            (site / name).write_text(text)
    documents = sum((search_documents(text, name) for name, text in texts.items() if not name.endswith("_source.html")), [])
    (site / "sitemap.txt").write_text("".join(f"{name}\n" for name in texts if kind_of_page(name) < 4))
    listed = json.dumps(documents, indent=0, ensure_ascii=False)
    (site / "search-documents.js").write_text(f"window.searchDocuments = {listed};\n")
    anchors = {name: set(re.findall(r' (?:id|name)="([^"]*)"', text)) for name, text in texts.items()}
    links = [(name, target) for name, text in texts.items() for target in re.findall(r' (?:href|src)="([^"]*)"', text)
             if target and target != PAPER and not target.startswith(("data:", "javascript:void"))]
    faults = [fault for fault in (fault_of_link(name, target, site, anchors) for name, target in links) if fault]
    return f"{len(texts)} pages, {len(links)} links followed, {len(documents)} entries for the search", faults
