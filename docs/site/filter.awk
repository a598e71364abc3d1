# Input filter of Doxygen: the project's own tags become links, and $...$ in Markdown becomes a formula.
#
# @eq{28,A.8}         links to the pages of the equations, label eq_28, eq_A_8; what is no number stays text
# @erratum{40}        a link to what the page says of the printed form
# @derivation{name}   a link to derivation/name.cpp, resolved by `pages finish`
# @domain{...}        a paragraph; commas and all
# What is documented stands in the headers of the library and the derivation, but for those whose first line is a plain comment;
# of these and of all other sources nothing is declared, and the site shows them as they are. No line is added or taken away: line
# numbers stay true.

function label(number) {
    gsub(/\./, "_", number)
    return "eq_" number
}

function linked(list, parts, n, i, number, out) {
    n = split(list, parts, ",")
    out = ""
    for (i = 1; i <= n; ++i) {
        number = parts[i]
        gsub(/^ +| +$/, "", number)
        if (number ~ /^([0-9]+|A\.[0-9]+)$/)
            out = out (i > 1 ? "\\, " : "") "\\ref " label(number) " \"(" number ")\""
        else
            out = out (i > 1 ? "\\, " : "") number
    }
    return out
}

# The first @tag{...} of a line, braces balanced; start and length in AT and LENGTH, what is inside in INSIDE.
function find_tag(line, tag, i, depth, c) {
    AT = index(line, "@" tag "{")
    if (!AT) return 0
    depth = 0
    for (i = AT + length(tag) + 1; i <= length(line); ++i) {
        c = substr(line, i, 1)
        if (c == "{") ++depth
        if (c == "}" && --depth == 0) {
            LENGTH = i - AT + 1
            INSIDE = substr(line, AT + length(tag) + 2, LENGTH - length(tag) - 3)
            return 1
        }
    }
    return 0
}

function put(line, text) {
    return substr(line, 1, AT - 1) text substr(line, AT + LENGTH)
}

function formulas(line, out, at) {
    out = ""
    while ((at = index(line, "$")) > 0) {
        out = out substr(line, 1, at - 1)
        line = substr(line, at + 1)
        at = index(line, "$")
        if (!at) return out "$" line
        out = out "\\f$" substr(line, 1, at - 1) "\\f$"
        line = substr(line, at + 1)
    }
    return out line
}

# Numbers of equations in running text, (46) or (A.8), as links to their pages; a formula or a piece of code is left alone.
function numbers(line, out, at, before, number) {
    out = ""
    while (match(line, /\\f\$[^$]*\$|`[^`]*`|\((A\.)?[0-9]+\)/)) {
        at = RSTART
        number = substr(line, at + 1, RLENGTH - 2)
        before = at > 1 ? substr(line, at - 1, 1) : substr(out, length(out), 1)
        out = out substr(line, 1, at - 1)
        if (substr(line, at, 1) == "(" && before !~ /[A-Za-z0-9_^\]]/ && is_equation(number))
            out = out "\\ref " label(number) " \"(" number ")\""
        else
            out = out substr(line, at, RLENGTH)
        line = substr(line, at + RLENGTH)
    }
    return out line
}

function is_equation(number) {
    return number ~ /^A\./ ? substr(number, 3) + 0 >= 1 && substr(number, 3) + 0 <= 15 : number + 0 >= 1 && number + 0 <= 88
}

# Paths of sources in a Markdown text, `model/scene.hpp`, as links: from the project's root, or from src/denhartog.
function sources(line, out, path, full) {
    out = ""
    while (match(line, /`[a-z_0-9\/-]+\/[a-z_0-9]+\.[hc]pp`/)) {
        path = substr(line, RSTART + 1, RLENGTH - 2)
        full = path ~ /^(src|derivation|tests|paper-figures|docs)\// ? path : (path ~ /^denhartog\// ? "src/" : "src/denhartog/") path
        out = out substr(line, 1, RSTART - 1) "<a href=\"source:" full "\"><code>" path "</code></a>"
        line = substr(line, RSTART + RLENGTH)
    }
    return out line
}

# Words between double asterisks as strong ones: Doxygen does not know those that begin or end with a link or a mark.
function strong(line, out, found) {
    out = ""
    while (match(line, /`[^`]*`|\*\*/)) {
        found = substr(line, RSTART, RLENGTH)
        if (found == "**") {
            bold = !bold
            found = bold ? "<b>" : "</b>"
        }
        out = out substr(line, 1, RSTART - 1) found
        line = substr(line, RSTART + RLENGTH)
    }
    return out line
}

# A label for a page from the name of its file: docs/reading-order.md is reading_order, docs/ledger/README.md is ledger.
function page_label(file, parts, n, name) {
    n = split(file, parts, "/")
    name = parts[n] == "README.md" ? parts[n - 1] : parts[n]
    sub(/\.md$/, "", name)
    gsub(/-/, "_", name)
    return name
}

FNR == 1 {
    file = index(FILENAME, ENVIRON["PWD"] "/") == 1 ? substr(FILENAME, length(ENVIRON["PWD"]) + 2) : FILENAME
    markdown = file ~ /^docs\/.*\.md$/
    shown_only = file ~ /\.cpp$/ || file ~ /^(docs|tests|paper-figures|derivation\/offers)\/.*\.hpp$/ || (file ~ /^src\// && /^\/\/ /)
}
shown_only { # the paragraph at the head of the source alone
    if (FNR == 1) brief = ""
    if (/^\/\/ / && (FNR == 1 || brief != "")) {
        brief = brief (brief == "" ? "" : " ") substr($0, 4)
        print ""
        next
    }
    gsub(/,/, "\\,", brief)
    while (match(brief, /`[^`]*`/)) # Doxygen does not look for code in an alias
        brief = substr(brief, 1, RSTART - 1) "<code>" substr(brief, RSTART + 1, RLENGTH - 2) "</code>" substr(brief, RSTART + RLENGTH)
    print (brief != "" ? "/// @shown{" numbers(brief) "}" : FNR == 1 ? "/// @file" : "")
    brief = ""
    next
}

markdown {
    if (/^```/) code = !code
    if (!code) {
        if (/^# / && !/\{#/ && !titled++ && page_label(FILENAME) != "index") $0 = $0 " {#" page_label(FILENAME) "}"
        gsub(/\]\(\.\.\/paper-figures\/README\.md\)/, "](@ref figures_page)")
        gsub(/\]\(\.\.\/derivation\/kernel\/Statements\.v\)/, "](@ref theorems)")
        while (match($0, /<!--page [a-z_]+-->/)) { # a link to a page that is only on the site
            $0 = substr($0, 1, RSTART - 1) "<a href=\"" substr($0, RSTART + 9, RLENGTH - 12) ".html\">" substr($0, RSTART + RLENGTH)
            sub(/<!--\/-->/, "</a>")
        }
        $0 = strong($0)
        if (/^<!-- figure [a-z_]+: .* -->$/) { # a picture that the run has drawn; the sources have none to show
            at = index($0, ": ")
            picture = "figures/" substr($0, 13, at - 13) ".svg"
            $0 = "<p><a href=\"" picture "\"><img src=\"" picture "\" alt=\"" substr($0, at + 2, length($0) - at - 5) "\"></a></p>"
        }
        if (/^\$\$.*\$\$$/) # a formula, alone on its line
            $0 = "\\f[ " substr($0, 3, length($0) - 4) " \\f]"
        else
            $0 = sources(/^#/ ? formulas($0) : numbers(formulas($0)))
    }
    print
    next
}

/\/\/[\/!]/ {
    if (/\\f\[/) displayed = 1
    if (!displayed) $0 = numbers($0)
    if (/\\f\]/) displayed = 0
    while (find_tag($0, "eq")) $0 = put($0, "@equations{" linked(INSIDE) "}")
    while (find_tag($0, "erratum")) $0 = put($0, "@departures{" linked(INSIDE) "}")
    while (find_tag($0, "derivation")) $0 = put($0, "@derived{<a href=\"source:derivation/" INSIDE ".cpp\">derivation/" INSIDE ".cpp</a>}")
    while (find_tag($0, "domain")) {
        inside = INSIDE
        gsub(/,/, "\\,", inside)
        gsub(/<=/, "\\&le;", inside)
        gsub(/>=/, "\\&ge;", inside)
        gsub(/<</, "≪", inside)
        gsub(/</, "\\&lt;", inside)
        $0 = put($0, "@holds_for{" inside "}")
    }
}
{ print }
