"""The generated pages of the site: `docs/site/make` has them written, runs Doxygen over them, and has them finished.

What is read on a page stands in its template, `../templates/NAME.html`: HTML with the commands of Doxygen that resolve links.
`site` renders the templates; a new page needs a template and its name in `site.make_pages`. `records` loads what a run wrote;
`equations`, `chapter` and `conclusions` prepare it; `sources` finds places and lines in the sources; `code` writes formulas in
other languages; `text` makes words, symbols and numbers of equations what they are on a page. `finish` mends what Doxygen
writes, makes the list for the search, and follows every link.
"""
