"""What of Doxygen's pages nobody reads is left out, the long pages of namespaces are parted by header, and the page of a type
does not say twice what it says."""
import re
from collections import defaultdict

from .text import html

CONTENTS, CONTENTS_END = '<div class="contents">', "</div><!-- contents -->"
GROUP, TITLE, ORIGIN = '<h2 class="groupheader">', '<h2 class="memtitle">', "<hr/>The documentation for this "
DETAILS = '<a name="details" id="details"></a>'
OF_TYPE = ("struct", "class", "union")
LEFT_OUT = ("dir_", "functions", "globals", "namespacemembers", "classes.html", "hierarchy.html")
WORDS = {"\nPublic Types</h2>": "\nTypes</h2>", "\nPublic Member Functions</h2>": "\nFunctions</h2>",
         "\nStatic Public Member Functions</h2>": "\nStatic functions</h2>", "\nPublic Attributes</h2>": "\nMembers</h2>",
         "\nStatic Public Attributes</h2>": "\nStatic members</h2>"} | {
    f">{doxygens} Documentation</h2>": f">The {ours} in detail</h2>" for doxygens, ours in {
        "Constructor &amp; Destructor": "constructors", "Member Function": "functions", "Member Data": "members",
        "Member Typedef": "types", "Member Enumeration": "enumerations", "Friends And Related Function": "friends"}.items()}
ENTITIES = {"&lt;": "<", "&gt;": ">", "&quot;": '"', "&#39;": "'", "&#160;": " ", "&le;": "<=", "&ge;": ">=", "&amp;": "&"}


def cut(text, opening, closing):
    return re.sub(re.escape(opening) + ".*?" + re.escape(closing), "", text, flags=re.S)


def text_of_html(html):
    """The text of a piece of HTML: no tags, no scripts, single blanks."""
    text = re.sub("<[^>]*>?", " ", cut(cut(html, "<script", "</script>"), "<style", "</style>"))
    text = re.sub("[ \n\t]+", " ", text).lstrip(" ")
    for entity, meant in ENTITIES.items():
        text = text.replace(entity, meant)
    return text.removesuffix(" ")


def first(pattern, text):
    """What a pattern with a group finds first; empty where nothing."""
    found = re.search(pattern, text, re.S)
    return found[1] if found else ""


def header_name(stem):
    """The name of a header in the name of its page: `formulas_2mode_8hpp` is formulas/mode.hpp."""
    return re.sub("_(.)", lambda mark: {"2": "/", "8": "."}.get(mark[1], "_"), stem)


def is_left_out(name, text):
    """Whether a reader of the site has no use for a page."""
    if name.startswith(LEFT_OUT) or name.endswith(("-members.html", "_8cpp.html")):
        return True
    if name.startswith(OF_TYPE):
        made_from = re.search("was generated from the following file.*?<li>([^<]*)<", text, re.S)
        return made_from is not None and not re.match("src/(denhartog/(?!program/)|conformance/)", made_from[1])
    return name.endswith(("_8hpp.html", "_8h.html")) and first(r'<li class="navelem">(?:(?!</li>).)*?>([^<]*)<', text) != "src"


def relinked(page, own, kept, out_of_site):
    """A page without its links to what is left out: to a file's page they lead to its source, elsewhere their text stays."""
    def mended(link):
        file = link["target"].partition("#")[0]
        if file not in out_of_site:
            return link[0]
        source = file.removesuffix(".html") + "_source.html"
        if source == own:
            return ""  # to itself: "Go to the documentation of this file."
        return f'{link["before"]}{source}{link["after"]}{link["shown"]}</a>' if source in kept else link["shown"]

    return re.sub(r'(?P<before><a [^>]*?href=")(?P<target>[^"]*)(?P<after>"[^>]*>)(?P<shown>.*?)</a>', mended, page, flags=re.S)


def whole_list(page, out_of_site):
    """The lists of types and files: what is left out has no row, and all rows are shown, as no script opens them."""
    def row(found):
        if '<span class="icon">C</span>' in found[0] and first('href="([^"]*)"', found[0]) in out_of_site:
            return ""
        text = found[0].replace(' style="display:none;"', "", 1)
        return re.sub(r'<a (?:(?!<a ).)*?<span class="icondoc"></span></a>', "", text, count=1)  # a link that has no name

    page = re.sub(r'<tr id="row_.*?</tr>', row, page, flags=re.S)
    return re.sub(r'<div class="levels">.*?</div>', "", page, count=1, flags=re.S)


def description_first(page, name):
    """The page of a type or a namespace with its description in place of the sentence that begins it."""
    more = f'<a href="{name}#details">More...</a></p>'
    described = re.search(rf"{DETAILS}.*?</h2>(.*?)(?={GROUP}|{ORIGIN}|\Z)", page, re.S)
    if more not in page or not described:
        return page
    page = page[:described.start()] + page[described.end():]
    brief, _, after = page.partition(more)
    return brief.rpartition("<p>")[0] + DETAILS + described[1] + after


# The pages of namespaces


def declared_in(texts):
    """The header that declares a name, by its place on the page of a namespace, as the pages of the headers have it."""
    rows = r'class="mem(?:Templ)?ItemRight"[^>]*><a class="el" href="(namespace[^"]*#[^"]*)"'
    return {place: page.removesuffix(".html") for page, text in texts.items() if page.endswith(("_8hpp.html", "_8h.html"))
            for place in re.findall(rows, text)}


def part(name, texts, declared):
    """Parts the page of a namespace: a list of names by header stays, what is said of them goes to a page for each header.
    Returns the places that moved."""
    texts[name] = description_first(texts[name], name)
    found = re.fullmatch(f"(.*?)({re.escape(CONTENTS)}.*?)({re.escape(CONTENTS_END)}.*)", texts[name], re.S)
    if not found:
        return {}
    head, body, foot = found.groups()
    items = defaultdict(list)
    ends = rf'(?=<a id="[^"]*" name="[^"]*"></a>\s*{TITLE}|{GROUP}|\Z)'
    for item in re.finditer(rf'<a id="([^"]*)"(?:(?!<a id=").)*?{TITLE}(.*?)</h2>.*?{ends}', body, re.S):
        file = declared.get(f"{name}#{item[1]}") or first(r'of file <a class="el" href="([^"]*)_source\.html', item[0])
        items[file].append((item[1], text_of_html(item[2].partition("</span>")[2]), item[0]))
    without_file = items.pop("", [])
    if len(items) < 2:
        return {}
    title = first(r'<h1 class="title">(.*?)</h1>', head).partition(" Namespace")[0]
    head = head.replace(f"{title} Namespace Reference", f"Namespace {title}")
    listed, moved = "", {}
    for file, of_file in sorted(items.items()):
        page, header = f"{name.removesuffix('.html')}_in_{file}.html", header_name(file)
        by_name = {shown.partition(" [")[0]: anchor for anchor, shown, _ in reversed(of_file)}  # of overloads the first
        names = ", ".join(f'<a class="el" href="{page}#{anchor}">{html(shown)}</a>' for shown, anchor in reversed(by_name.items()))
        listed += f'<dt><a class="el" href="{page}">{header}</a></dt>\n<dd>{names}</dd>\n'
        for _, _, text in of_file:
            moved |= {f"{name}#{anchor}": f"{page}#{anchor}" for anchor in re.findall(' id="([^"]*)"', text)}
        named = re.sub('(?<=<h1 class="title">).*?(?=</h1>)', f"{title} in {header}", head, count=1, flags=re.S)
        named = re.sub("(?<=<title>).*?(?=</title>)", f"{title} in {header} - denhartog", named, count=1, flags=re.S)
        texts[page] = (f'{named}{CONTENTS}\n<p>The source: <a class="el" href="{file}_source.html">{header}</a>. All of the '
                       f'namespace: <a class="el" href="{name}">{title}</a>.</p>\n{"".join(item[2] for item in of_file)}{foot}')
    tables = ""
    for kind in ("func", "enum", "var", "typedef"):  # the tables of declarations
        table = '<table class="memberdecls">'
        found = re.search(rf'{table}(?:(?!{table}).)*?<a id="{kind}-members".*?</table>', body, re.S)
        if found:
            tables += found[0]
            body = body.replace(found[0], "", 1)
    before = body.partition(" Documentation</h2>")[0].rpartition(GROUP)[0]
    types = re.search(r'<table class="memberdecls">\s*<tr class="heading">(?:(?!</tr>).)*?<a id="nested-classes".*?</table>', before, re.S)
    if types:
        listed_types = re.sub("<tr class=\"heading\">.*?</tr>", "", types[0], count=1, flags=re.S)
        count = types[0].count('<tr class="memitem:')
        before = before.replace(types[0], f"<details>\n<summary>Types: {count}</summary>\n{listed_types}</details>\n")
    told = {anchor.partition("#")[2] for anchor in moved} | {item[0] for item in without_file}
    rows = [row[0] for row in re.finditer(r'<tr class="memitem:(\w+)">.*?</tr>\s*(?:<tr class="memdesc:\1">.*?</tr>)?', tables, re.S)
            if f' id="{row[1]}"' in row[0] and row[1] not in told]  # of names that have no box of their own
    rest = f'<table class="memberdecls">{"".join(rows)}</table>' * bool(rows) + "".join(item[2] for item in without_file)
    texts[name] = f'{head}{before}{GROUP}By header</h2>\n<dl class="by-header">\n{listed}</dl>\n{rest}{foot}'
    return moved


# The page of a type


def line_of_source(box):
    """The line of the source that a box leads to, if the box says nothing but a sentence, this line and who calls whom."""
    said = box.partition('<div class="memdoc">')[2]
    if re.search("<(dl|div|pre|table|ul|ol)", said) or said.count("<p") - said.count('<p class="reference">') > 2:
        return ""
    return first('<p class="definition">Definition at line <a class="el" href="([^"]*)"', said)


def class_page(page, name):
    """The page of a type as a reader wants it: the description comes first. A member whose documentation is the sentence beside
    its declaration has no box of its own; its name leads to the line of the source. Every place that a page may link to stays."""
    start = re.search(rf'<a id="[^"]*" name="[^"]*"></a>\s*{TITLE}', page)
    if start:
        declared, boxes = page[:start.start()], page[start.start():]
        ends = rf'(?=<a id="[^"]*" name="[^"]*"></a>\s*{TITLE}|{GROUP}|{ORIGIN}|\Z)'

        def kept(box):
            nonlocal declared
            source, anchor = line_of_source(box[0]), box[1]
            row = re.search(rf'<tr class="memitem:{anchor}">.*?</tr>', declared, re.S)
            link = f'<a class="el" href="{name}#{anchor}">'
            if not source or not row or link not in row[0]:
                return box[0]
            rest = declared[row.start():].replace(link, f'<a class="el" id="{anchor}" href="{source}">', 1)
            declared = declared[:row.start()] + rest.replace(f'<a href="{name}#{anchor}">More...</a>', "", 1)
            return ""

        boxes = re.sub(rf'<a id="([^"]*)" name="[^"]*"></a>\s*{TITLE}.*?{ends}', kept, boxes, flags=re.S)
        page = declared + boxes
        page = re.sub(rf"{GROUP}(?:(?!</h2>).)*</h2>\n*(?={GROUP}|{ORIGIN})", "", page, flags=re.S)  # of nothing
    page = description_first(page, name)
    for doxygens, ours in WORDS.items():
        page = page.replace(doxygens, ours, 1)
    page = re.sub(r"(<h1(?:(?!</h1>).)*) (?:Struct|Class|Union)(?:(?!</h1>).)* Reference</h1>", r"\1</h1>", page, 1, re.S)
    return re.sub(rf"{ORIGIN}[^:]*:", "<hr/>Declared in:", page, count=1)


def trim(texts):
    """The pages of the site by the names of their files: what is left out is not there, and links follow."""
    out_of_site = {name for name, text in texts.items() if is_left_out(name, text)}
    texts = {name: text for name, text in texts.items() if name not in out_of_site}
    for name in ("annotated.html", "concepts.html", "files.html", "namespaces.html"):
        if name in texts:
            texts[name] = whole_list(texts[name], out_of_site)
    moved, declared = {}, declared_in(texts)
    for name in list(texts):
        if name.startswith(OF_TYPE):
            texts[name] = class_page(texts[name], name)
        elif name.startswith("namespacedenhartog"):
            moved |= part(name, texts, declared)
    follow = lambda page: re.sub('href="(namespace[^"]*)"', lambda link: f'href="{moved.get(link[1], link[1])}"', page)
    return {name: follow(relinked(text, name, texts, out_of_site)) for name, text in texts.items()}
