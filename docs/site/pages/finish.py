"""What Doxygen wrote becomes the site: links to sources, headings, what of Doxygen's pages nobody reads, the list for the search;
and the links of the whole site are followed."""
import json
import os
import re
from xml.etree import ElementTree

from lxml import html as lxml_html

PAPER = "https://doi.org/10.1016/j.jsv.2022.117085"
LONGEST_TEXT = 1200  # bytes that the search keeps of a page
# What is no text of a page for the search: what leads elsewhere, what is to be filled in, and what documents a name by itself.
NOT_TEXT = """self::script or self::style or self::form or self::h2/@class='memtitle' or
              contains(' eq-nav eq-contents copies memitem ', concat(' ', @class, ' '))"""
# Pages of Doxygen's that nobody reads: indices of letters and folders, lists that repeat a type, what a source without names is.
LEFT_OUT = re.compile(r"(dir_|functions|globals|namespacemembers|classes\.|hierarchy\.).*|.*(-members|_8cpp)\.html")


def first(tree, path):
    """What an XPath finds first, or None."""
    return next(iter(tree.xpath(path)), None)


def text_of(tree, left_out="self::script|self::style"):
    """The text of an element without that of some elements in it, with single blanks."""
    return " ".join(" ".join(tree.xpath(f".//text()[not(ancestor::*[{left_out}])]")).split())


def sources_of(tagfile, root):
    """The pages of sources by their paths from the root."""
    files = ElementTree.parse(tagfile).iterfind("compound[@kind='file']")
    return {os.path.relpath(root / file.findtext("path") / file.findtext("name"), root):
            file.findtext("filename").removesuffix(".html") + "_source.html" for file in files}


def finished_page(page, sources):
    """A page as readers get it: its title as the heading of first order, links to sources resolved, wide tables in boxes that
    scroll."""
    if "<h1>" in page and 'class="memtitle"' not in page:  # sections stand below the title
        page = re.sub("(</?h)([123])>", lambda heading: f"{heading[1]}{int(heading[2]) + 1}>", page)
    page = re.sub(r'<div class="title">(.*?)(?=</div>|<div)', r'<div><h1 class="title">\1</h1>', page, count=1, flags=re.S)
    boxed = r'<div class="table-box" tabindex="0">\g<0></div>'
    page = re.sub('<table class="markdownTable">.*?</table>', boxed, page, flags=re.S)
    page = re.sub('<div class="(fragment|memproto)">', r'<div class="\1" tabindex="0">', page)
    # A link to a source that the site does not have stays, and is found as a fault.
    return re.sub(r'(?<=href=")source:([^:"]*):?([^"]*)',
                  lambda link: sources.get(link[1], link[0]) + (f"#l{link[2]:>05}" if link[2] else ""), page)


def trim(texts):
    """The pages of the site by the names of their files, as trees, without those that are left out: a link to the page of a file
    leads to its source, the text of others stays."""
    trees = {name: lxml_html.document_fromstring(text) for name, text in texts.items() if not LEFT_OUT.fullmatch(name)}
    for name, tree in trees.items():
        for links in tree.find_class("summary"):  # to the headings below, also to some that are not there
            links.drop_tree()
        for link in tree.xpath("//a[@href]"):
            file = link.get("href").partition("#")[0]
            source = file.removesuffix(".html") + "_source.html"
            if source == name and LEFT_OUT.fullmatch(file):
                link.drop_tree()  # to itself: "Go to the documentation of this file."
            elif LEFT_OUT.fullmatch(file) and source in trees:
                link.set("href", source)
            elif LEFT_OUT.fullmatch(file):
                link.drop_tag()
    return trees


def shortened(text):
    """What the search keeps of a text: not too much, and formulas without their TeX."""
    text = re.sub(r"\\\[.*?\\\]|\\[()]|[\\{}]", "", text)
    return text.encode()[:LONGEST_TEXT].decode(errors="ignore")


def kind_of_page(name):
    """0 an equation, 1 a figure or the derivation, 2 another text, 3 what is behind an equation, 4 code: the search's order."""
    if name.startswith("eq_"):
        return 3 if "_more" in name else 0
    if name.startswith(("figure_", "derivation_")):
        return 1
    return 4 if "_8" in name or name.startswith(("namespace", "struct", "class")) else 2


def search_documents(tree, name):
    """What the search knows of a page: an entry for the page and one for each documented name on it."""
    title, named = first(tree, '//h1[@class="title"]'), first(tree, '//span[@class="named"]')
    if title is None:
        return []
    title = text_of(title) + ("" if named is None else ": " + shortened(text_of(named)))
    found = [(title, name, text_of(first(tree, '//div[@class="contents"]'), NOT_TEXT))]
    for heading in tree.find_class("memtitle"):  # between its anchor and its box
        said = text_of(first(heading.getnext(), './/div[@class="memdoc"]'))
        found.append((text_of(heading, "@class='permalink'"), f"{name}#{heading.getprevious().get('id')}", said))
    return [{"kind": kind_of_page(name), "text": shortened(text), "title": title, "url": url} for title, url, text in found]


def fault_of_link(page, target, site, anchors):
    """Why a link leads nowhere, or elsewhere; None for one that is followed within the site."""
    if "//" in target or target.startswith("mailto:"):
        return f"{page} leads elsewhere: {target}"
    file, _, anchor = re.sub(r"\?[^#]*", "", target).partition("#")
    place = anchors.get(file or page)
    if place is None:
        return None if (site / file).exists() else f"{page} leads to {file}, which is not there"
    return f"{page} leads to {target}, but there is no such place on that page" if anchor and anchor not in place else None


def finish(site, tagfile, source):
    """Finishes all pages of a site, writes the list for the search and the map of the site, and follows all links."""
    sources, files = sources_of(tagfile, source.resolve()), sorted(site.glob("*.html"))
    texts = {file.name: file.read_text() for file in files}
    trees = trim({name: finished_page(text, sources) for name, text in texts.items()})
    for file in files:
        file.unlink()
    for name, tree in trees.items():
        (site / name).write_text(lxml_html.tostring(tree, encoding="unicode", doctype="<!DOCTYPE html>"))
    documents = sum((search_documents(tree, name) for name, tree in trees.items() if not name.endswith("_source.html")), [])
    (site / "sitemap.txt").write_text("".join(f"{name}\n" for name in trees if kind_of_page(name) < 4))
    listed = json.dumps(documents, indent=0, ensure_ascii=False)
    (site / "search-documents.js").write_text(f"window.searchDocuments = {listed};\n")
    anchors = {name: set(tree.xpath("//@id|//a/@name")) for name, tree in trees.items()}
    links = [(name, target) for name, tree in trees.items() for target in tree.xpath("//@href|//@src")
             if target and target != PAPER and not target.startswith(("data:", "javascript:void"))]
    faults = [fault for fault in (fault_of_link(name, target, site, anchors) for name, target in links) if fault]
    return f"{len(trees)} pages, {len(links)} links followed, {len(documents)} entries for the search", faults
