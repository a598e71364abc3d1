"""The graph of what rests on what: where each equation stands, and the lines between them."""
from collections import defaultdict
from graphlib import TopologicalSorter
from types import SimpleNamespace

WIDTH, HEIGHT, COLUMN, ROW, MARGIN, TOP = 42, 24, 48, 46, 8, 34  # of a box, from box to box, at the edges


def layout(ledger, columns=3):
    """Row and column of each equation, in the band of its section, at most so many columns wide; what does not fit goes on in the
    row below. The bands are in the order of the paper, but the Appendix stands after Section 2.2, which asks for it."""
    grounds, depth = {entry["equation"]: entry["rests_on"] for entry in ledger}, {}  # the ledger sees that there is no way round
    for equation in TopologicalSorter(grounds).static_order():  # below all that it rests on
        depth[equation] = 1 + max((depth[ground] for ground in grounds[equation]), default=-1)
    levels = defaultdict(lambda: defaultdict(list))
    for entry in ledger:
        levels[depth[entry["equation"]]][entry.get("section", "")].append(entry["equation"])
    order = sorted({section for level in levels.values() for section in level},
                   key=lambda section: section.replace("Appendix", "2.2 and its appendix"))
    width = {section: min(columns, max(len(level.get(section, ())) for level in levels.values())) for section in order}
    places, line = {}, 0
    for _, level in sorted(levels.items()):
        for section, cell in level.items():
            left = sum(width[before] for before in order[:order.index(section)])
            for i, equation in enumerate(cell):
                places[equation] = (line + i // width[section], left + i % width[section])
        line = 1 + max(row for row, _ in places.values())
    return places


def graph_of(ledger):
    """The picture: bands, lines and the middle of each box, in pixels."""
    places = layout(ledger)
    sections = defaultdict(list)
    for entry in ledger:
        sections[entry["section"]].append(places[entry["equation"]][1])
    bands = [SimpleNamespace(section=section, left=MARGIN + min(at) * COLUMN - (COLUMN - WIDTH) // 2,
                             wide=(max(at) - min(at) + 1) * COLUMN) for section, at in sections.items()]
    middle = {equation: (MARGIN + column * COLUMN + WIDTH / 2, TOP + row * ROW + HEIGHT / 2)
              for equation, (row, column) in places.items()}
    edges, below = [], {}
    for entry in sorted(ledger, key=lambda entry: places[entry["equation"]][0]):
        direct = set(entry["rests_on"])
        below[entry["equation"]] = direct.union(*(below[ground] for ground in direct))
        for ground in sorted(direct - set().union(*(below[ground] for ground in direct))):  # others follow from these
            (x, y), (to_x, to_y) = middle[ground], middle[entry["equation"]]
            y, to_y = y + HEIGHT / 2, to_y - HEIGHT / 2
            bend, aside = (to_y - y) / 2, COLUMN * 2 / 3 if x == to_x and to_y - y > ROW else 0  # not behind the boxes between
            edges.append((ground, entry["equation"], f"M {x:.1f} {y:.1f} C {x + aside:.1f} {y + bend:.1f} {to_x + aside:.1f} "
                                                     f"{to_y - bend:.1f} {to_x:.1f} {to_y:.1f}"))
    rows, across = (max(place[n] for place in places.values()) for n in (0, 1))
    return SimpleNamespace(bands=sorted(bands, key=lambda band: band.left), edges=edges, places=middle,
                           width=2 * MARGIN + across * COLUMN + WIDTH, height=TOP + MARGIN + rows * ROW + HEIGHT)
