"""What of Doxygen's pages nobody reads is left out, the long pages of namespaces are parted by header, and the page of a type
does not say twice what it says."""
import re
from collections import defaultdict
from copy import deepcopy
from itertools import takewhile

from lxml import html as lxml_html

from .text import html

OF_TYPE = ("struct", "class", "union")
LEFT_OUT = ("dir_", "functions", "globals", "namespacemembers", "classes.html", "hierarchy.html")


def first(tree, path):
    """What an XPath finds first, or None."""
    return next(iter(tree.xpath(path)), None)


def text_of(tree, left_out="self::script|self::style"):
    """The text of an element without that of some elements in it, with single blanks."""
    return " ".join(" ".join(tree.xpath(f".//text()[not(ancestor::*[{left_out}])]")).split())


def drop(*elements):
    for element in elements:
        element.drop_tree()


def boxes(tree):
    """What documents a name, for each name of a page: an anchor, a title and a box."""
    return [(title.getprevious(), title, title.getnext()) for title in tree.find_class("memtitle")]


def is_left_out(name, tree):
    """Whether a reader of the site has no use for a page."""
    if name.startswith(LEFT_OUT) or name.endswith(("-members.html", "_8cpp.html")):
        return True
    if name.startswith(OF_TYPE):
        made_from = first(tree, "//hr/following::li[1]/text()")
        return made_from and not re.match("src/(denhartog/(?!program/)|conformance/)", made_from)
    return name.endswith(("_8hpp.html", "_8h.html")) and first(tree, '//li[@class="navelem"]/a/text()') != "src"


def relink(tree, own, kept, out_of_site, moved):
    """Mends the links of a page to what is left out: to a file's page they lead to its source, elsewhere their text stays."""
    for link in tree.xpath("//a[@href]"):
        target = link.get("href")
        file = target.partition("#")[0]
        source = file.removesuffix(".html") + "_source.html"
        if file not in out_of_site:
            link.set("href", moved.get(target, target))
        elif source == own:
            drop(link)  # to itself: "Go to the documentation of this file."
        elif source in kept:
            link.set("href", source)
        else:
            link.drop_tag()


def drop_idle_parts(tree, out_of_site):
    """Of the lists of types and files drops what is left out; of every page drops links to headings that may be left out, and
    links that have no name."""
    for row in tree.xpath('//table[@class="directory"]//tr'):
        if first(row, './/span[@class="icon"]/text()') == "C" and first(row, './/a[@class="el"]/@href') in out_of_site:
            drop(row)
    drop(*tree.xpath('//div[@class="levels" or @class="summary"]|//a[span/@class="icondoc"]'))


def description_first(tree):
    """Moves the description of a type or a namespace to the place of the sentence that begins its page."""
    for brief in tree.xpath('(//div/p[a="More..."])[1]'):
        heading = first(tree, '//a[@id="details"]/following-sibling::h2[1]')
        described = takewhile(lambda each: each.get("class") != "groupheader" and each.tag != "hr", list(heading.itersiblings()))
        for element in (heading.getprevious(), *described):
            brief.addprevious(element)
        drop(brief, heading)


def drop_empty_sections(tree):
    """Drops the headings and the tables of declarations under which nothing is left."""
    for heading in tree.xpath('//h2[@class="groupheader" and not(ancestor::table)]'):
        after = heading.getnext()
        if after is None or after.tag == "hr" or after.get("class") == "groupheader":
            drop(heading)
    drop(*tree.xpath('//table[@class="memberdecls" and not(.//tr[contains(@class, ":")])]'))


# The pages of namespaces


def split_by_header(name, tree, declared):
    """Splits the page of a namespace: a list of names by header stays, what is said of them goes to a page for each header.
    Returns these pages, and the places that moved."""
    description_first(tree)
    items, pages, moved = defaultdict(list), {}, {}
    for box in boxes(tree):
        source = first(box[2], './/p[@class="definition"]/a[2]/@href')
        file = declared.get(f"{name}#{box[0].get('id')}") or source and source.removesuffix("_source.html")
        items[file].append(box)
    items.pop(None, None)
    if len(items) < 2:
        return pages, moved
    title = first(tree, '//h1[@class="title"]/text()').removeprefix("Namespace ")
    documentation = first(tree, '//div/h2[@class="groupheader"]')
    frame = deepcopy(tree)
    del first(frame, '//div[@class="contents"]')[:]
    listed = ""
    for file, of_file in sorted(items.items()):
        page = f"{name.removesuffix('.html')}_in_{file}.html"
        header = re.sub("_(.)", lambda mark: {"2": "/", "8": "."}.get(mark[1], "_"), file)  # in_2mode_8hpp: in/mode.hpp
        by_name = {}  # of overloads the first
        for anchor, shown, _ in of_file:
            by_name.setdefault(text_of(shown, "@class='permalink'").partition(" [")[0], anchor.get("id"))
        names = ", ".join(f'<a class="el" href="{page}#{anchor}">{html(shown)}</a>' for shown, anchor in by_name.items())
        listed += f'<dt><a class="el" href="{page}">{header}</a></dt>\n<dd>{names}</dd>\n'
        pages[page] = deepcopy(frame)
        first(pages[page], '//h1[@class="title"]').text = f"{title} in {header}"
        first(pages[page], "//title").text = f"{title} in {header} - denhartog"
        of_page = first(pages[page], '//div[@class="contents"]')
        of_page.append(lxml_html.fragment_fromstring(
            f'<p>The source: <a class="el" href="{file}_source.html">{header}</a>. All of the namespace: '
            f'<a class="el" href="{name}">{title}</a>.</p>'))
        for element in sum(of_file, ()):
            moved |= {f"{name}#{anchor}": f"{page}#{anchor}" for anchor in element.xpath("descendant-or-self::*/@id")}
            of_page.append(element)
    types = first(tree, '//table[.//a[@id="nested-classes"]]')
    if types is not None:
        drop(first(types, './tr[@class="heading"]|./tbody/tr[@class="heading"]'))
        count = len(types.xpath('.//tr[starts-with(@class, "memitem:")]'))
        folded = lxml_html.fragment_fromstring(f"<details><summary>Types: {count}</summary></details>")
        types.addprevious(folded)
        folded.append(types)
    places = set(tree.xpath("//tr//@id"))
    for table in tree.xpath('//table[.//a/@id[. = "func-members" or . = "enum-members" or . = "var-members" or '
                            '. = "typedef-members"]]'):  # names that have a box have no row
        drop(*(row for row in table.xpath('.//tr[contains(@class, ":")]') if row.get("class").partition(":")[2] not in places))
    by_header = f'<h2 class="groupheader">By header</h2>\n<dl class="by-header">\n{listed}</dl>'
    for element in lxml_html.fragments_fromstring(by_header):
        documentation.addprevious(element)
    drop_empty_sections(tree)
    return pages, moved


# The page of a type


def class_page(tree, name):
    """The page of a type as a reader wants it: the description comes first. A member whose documentation is the sentence beside
    its declaration has no box of its own; its name leads to the line of the source. Every place that a page may link to stays."""
    for box in boxes(tree):
        said, anchor = first(box[2], './div[@class="memdoc"]'), box[0].get("id")
        source, link = first(said, './/p[@class="definition"]/a/@href'), f'//a[@href="{name}#{anchor}"]'
        # What is more than a sentence, the line of the source and who calls whom.
        more = said.xpath(".//dl|.//div|.//pre|.//table|.//ul|.//ol") + said.xpath('.//p[not(@class="reference")]')[2:]
        declared = first(tree, f'//tr[@class="memitem:{anchor}"][1]{link}')
        if source and not more and declared is not None:
            declared.attrib.update({"id": anchor, "href": source})
            drop(*tree.xpath(f'//tr[@class="memdesc:{anchor}"]{link}'), *box)
    drop_empty_sections(tree)
    description_first(tree)
    heading = first(tree, '//h1[@class="title"]')
    origin = first(tree, '//hr[starts-with(following-sibling::text(), "The documentation for")]')
    heading.text = re.sub(" (Struct|Class|Union) .*Reference$", "", heading.text)
    if origin is not None:
        origin.tail = "Declared in:"


def trim(texts):
    """The pages of the site by the names of their files, as trees: what is left out is not there, and links follow."""
    trees = {name: lxml_html.document_fromstring(text) for name, text in texts.items()}
    out_of_site = {name for name, tree in trees.items() if is_left_out(name, tree)}
    trees = {name: tree for name, tree in trees.items() if name not in out_of_site}
    # The header that declares a name, by its place on the page of a namespace, as the pages of the headers have it.
    rows = '//td[contains(@class, "ItemRight")]/a[@class="el" and starts-with(@href, "namespace")]/@href'
    moved, declared = {}, {place: page.removesuffix(".html") for page, tree in trees.items()
                           if page.endswith(("_8hpp.html", "_8h.html")) for place in tree.xpath(rows)}
    for name, tree in list(trees.items()):
        drop_idle_parts(tree, out_of_site)
        if name.startswith(OF_TYPE):
            class_page(tree, name)
        elif name.startswith("namespacedenhartog"):
            pages, places = split_by_header(name, tree, declared)
            trees |= pages
            moved |= places
    for name, tree in trees.items():
        relink(tree, name, trees, out_of_site, moved)
    return trees
