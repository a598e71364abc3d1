"""The generated pages of the site: what they say, what they refuse, and what the checks of the finished site do not let through.

Needs DENHARTOG_SOURCE_DIR. Ends with status 77 where Jinja2, lxml or Graphviz is missing.
"""
import json
import math
import os
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile
import unittest
from collections import defaultdict
from types import SimpleNamespace

PROJECT = pathlib.Path(os.environ["DENHARTOG_SOURCE_DIR"])
sys.path.insert(0, str(PROJECT / "docs/site"))
sys.dont_write_bytecode = True

try:
    import jinja2
    from lxml import html as lxml_html
except ImportError as missing:
    print(f"skipped: {missing} (Debian packages python3-jinja2 and python3-lxml)")
    sys.exit(77)
if not shutil.which("dot"):
    print("skipped: no dot (Debian package graphviz)")
    sys.exit(77)

from pages import finish, site, text
from pages.code import code_of, javascript_of
from pages.equations import equation_view
from pages.site import faults_of_pages
from pages.records import Departure, faults_of_departures, read_symbols, stands_in, symbols_in
from pages.sources import Sources
from pages.text import EQUATIONS, Fault, displayed, equation_label, equation_link, escaped, formula, html, prose, symbol, witness_value


def entry(number, **more):
    return {"equation": number, "section": "2.3", "kind": "result", "statement": f"a_{{{number}}}=b", "printed": "unknown",
            "departure": "none", "correction": "", "correction_by": "", "shipped": "unknown", "witness": {}, "functions": [],
            "as_printed": [], "claims": [], "tests": [], "tests_failed": [], "figures": [], "rests_on": [], "used_by": [],
            "printed_note": "", "in_print": "", "remark": "", "consequence": "", "no_function": "",
            "scene": {}, "kernel": {"status": "not_run", "theorems": [], "negations": []}} | more


class SmallRun:
    """Two equations, (37) and (38), of which (38) rests on (37), with a claim each; the rest of the paper left out."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.write("src/f.hpp", "namespace denhartog::paper {\n\n/// @brief X.\ntemplate <class T>\nT amplitude(const T& x) {\n"
                                "    return x < 1 ? x : 2;\n}\n}\n")
        self.write("derivation/c.cpp", 'const char* id = "38/amplitude";\nconst char* other = "37/sine";\n')
        self.write("docs/chapter/chapter.md", "# All\n\n{{claims 37}}\n\n{{claims 38}}\n")
        refuted = entry("38", rests_on=["37"], printed="refuted", shipped="proved", departure="misprint", correction="a=c",
                        witness={"V_jr": "1/3"}, tests=["the amplitude is right"],
                        functions=[{"name": "denhartog::paper::amplitude", "file": "src/f.hpp", "line": 5}])
        ledger = [entry("37", used_by=["38"]), refuted]
        self.run = SimpleNamespace(ledger=ledger, entries={each["equation"]: each for each in ledger}, claims={}, symbols={"V_jr": r"\mathrm{Re}\,V_{dj}"},
                                   certificates={}, theorems="", figures={}, accuracy=[], chart="", batch="", conformance={},
                                   departures=defaultdict(Departure), notation=[], places={}, statements=[], in_words={}, stand_for=[],
                                   names={number: "A name" for number in EQUATIONS}, formulas={},
                                   tests={"the amplitude is right": {"file": "tests/t.cpp", "line": 1}}, questions={},
                                   motion=[[0.0] * 3] * 4, audit="All.\n\n| equation |\n|---|\n",
                                   benchmark=[("solver", "15.02", "14.43", "0.00017", "1.000")],
                                   run={"agreement": [{"group": "a", "scenes": 1} | dict.fromkeys(
                                       ("double", "50 digits"), {"worst": 1e-15, "scene": "b"})], "stand_ins": [{"name": "sinc", "header": "evaluation/special.hpp",
                                                                        "theorem": r"x \mapsto \sin(x)/x"}]})
        self.entry = refuted
        self.add_claim(ledger[0], "37/sine")
        self.add_claim(refuted, "38/amplitude")

    def write(self, name, content):
        (self.folder / name).parent.mkdir(parents=True, exist_ok=True)
        (self.folder / name).write_text(content)

    def add_claim(self, row, name):
        row["claims"].append({"id": name, "role": "shipped", "verdict": "proved", "what": "The amplitude", "assumptions": ["R_i > 0"],
                              "kind": "derived", "kernel": {"status": "not_run"}})
        self.run.claims[name] = {"claim": name, "equations": [row["equation"]], "title": "The amplitude", "verdict": "proved",
                                 "steps": [{"text": "A quadratic", "latex": "x^2=y"}]}

    def render(self, template, **view):
        return site.environment(self.run, Sources(self.folder)).get_template(template + ".html").render(view)

    def page(self, number):
        view = equation_view(self.run, Sources(self.folder), self.run.entries[number])
        more = self.render("equation_more", **view) if view["more"] else ""
        return self.render("equation", **view) + more

    def chapter(self, written):
        self.write("docs/chapter/chapter.md", written)
        faults = []
        views = site.chapter_views(self.run, site.read_chapter(self.folder / "docs/chapter"), faults)
        return [self.render("chapter", **view) for view in views], faults


class Case(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.small = SmallRun(self.folder / "small")

    def assertTells(self, faults, *parts):
        for part in parts:
            self.assertTrue(any(part in fault for fault in faults), f"{part} is not among {faults}")

    def assertHas(self, page, *parts):
        for part in parts:
            self.assertIn(part, page)


class Words(Case):
    def test_escaped(self):
        """What is special to Doxygen and HTML is escaped."""
        self.assertEqual(escaped('a < b & c @ d # 5 % \\ _x_ *y* "z"'),
                         "a &lt; b &amp; c \\@ d \\# 5 \\% \\\\ \\_x\\_ \\*y\\* &quot;z&quot;")
        self.assertEqual(html('<a href="b">&'), "&lt;a href=&quot;b&quot;&gt;&amp;")

    def test_symbols(self):
        """Symbols in plain text become the paper's; one letter is a symbol only by itself."""
        for name, alone, latex in (
                ("zeta_i", False, r"\zeta_{i}"), ("V_dj", False, "V_{dj}"), ("U_j", True, "U_{dj}"), ("x", True, r"\bar{x}"),
                ("X_j", False, r"\overline{X}_{j}"), ("R1", False, ""), ("beta_lim", False, r"\beta_{\lim}"), ("mode_functions", False, ""), ("S", False, "")):
            self.assertEqual(symbol(name, alone), latex, name)

    def test_prose(self):
        """A sentence of the run gets its links and symbols, and paths stay as they are."""
        for said, shown in (
                ("by (46) and (A.7)", r'by \ref eq_46 "(46)" and \ref eq_A_7 "(A.7)"'),
                ("sin(2) is no equation, nor (2022), (0)", "sin(2) is no equation, nor (2022), (0)"),
                ("zeta_i <= 1 -> R_i", r"\f$\zeta_{i}\f$ ≤ 1 → \f$R_{i}\f$"),
                ("mode_functions.hpp, beta.hpp", r"mode\_functions.hpp, beta.hpp"),
                ("off by 1.8e+02 %, at 0.10000000000000001", r"off by 180 \%, at 0.1"), ("1.2e-07 and R2e5", r"\f$1.2\cdot10^{-7}\f$ and R2e5"),
                ("SDOF zeta=0.10000000000000001", r"one mass, \f$\zeta=0.1\f$"), ("zeta=1e-06, seed=1e5", r"\f$\zeta=1\cdot10^{-6}\f$, seed=100000"),
                ("off by up to 0 % on the grid of the paper's scenes, 44.8 % at random",
                 r"right on the grid of the paper's scenes, off by up to 44.8 \% at random"),
                ("2DOF j=2 l=1 #7", r"two masses, \f$j=2\f$, \f$l=1\f$, scene 7"),
                ("SDOF zeta=0.001 r=0.95.", r"one mass, \f$\zeta=0.001\f$, \f$r=0.95\f$."),
                ("x_j'/sin(tau)", r"\f$\bar{x}_{j}'\f$/\f$\sin(\tau)\f$"),
                ("zeta_i > 0 or 1/R_i not odd", r"\f$\zeta_{i}\f$ &gt; 0 or 1/\f$R_{i}\f$ not odd"),
                ("tests/limits/R_i", r"tests/limits/R\_i"), ("zeta/r_n,i", r"\f$\zeta\f$/\f$r_{n,i}\f$")):
            self.assertEqual(prose(said), shown)
        self.assertEqual(text.raw(prose("(46) and zeta_i, a_b_c")), r"(46) and \(\zeta_{i}\), a_b_c")
        for value, shown in (("-329/333", r"\f$-\tfrac{329}{333}\f$"), ("0.25", "0.25"),
                             ("0.105313493022638536325369615526715714", "0.105313"),
                             ("0.40000000000000002", "0.4"), ("-7.816875436426E-4", "-0.000781688")):
            self.assertEqual(witness_value(value), shown)

    def test_tables(self):
        """Tables of the surveys stay Markdown, with links and formulas, and a ragged row is refused."""
        self.assertEqual(site.tables("## Head\n\n| a | b |\n|---|--:|\n| (38) | 2e-9 |\n\nA note.\n", "speed"),
                         "\\section speed_1 Head\n\n| a | b |\n|---|--:|\n"
                         '| \\ref eq_38 "(38)" | \\f$2\\cdot10^{-9}\\f$ |\n\nA note.')
        with self.assertRaisesRegex(Fault, "as many cells"):
            site.tables("| a | b |\n|---|---|\n| 1 |\n", "x")

    def test_notation(self):
        """The symbols of a formula are those of the notation page, of other masses too, and not parts of other symbols."""
        symbols = read_symbols("| $G_k$ | `G_k` | a sum | (35) | m |\n| $\\beta$ | `beta` | friction ratio | (11) | |\n"
                               "\n## Symbols of ours\n| $q$ | `q` | ours | | |\n")
        self.assertEqual([(name, each.equations, each.units) for name, each in symbols_in(symbols, r"\beta G_j")],
                         [("G_j", ["35"], "m"), (r"\beta", ["11"], "")])
        self.assertFalse(stands_in(r"\beta_{\lim}", r"\beta"))
        self.assertFalse(stands_in(r"\Gamma", "a"))


class Code(Case):
    ROOT = "sqrt((1-(zeta*zeta)))"
    THETA = f"((pi*{ROOT})/R)"
    DAMPING = f"(sin({THETA})/((R*{ROOT})*(cosh(((pi*zeta)/R))+cos({THETA}))))"

    def formula(self, *holds, arguments="R zeta a b x", of_modes=""):
        return {"name": "f", "arguments": arguments.split(), "of_modes": of_modes.split(), "holds": holds, "printed": holds}

    def test_languages(self):
        """A formula is code in each language, with names for what is needed twice and no bracket that says nothing."""
        self.assertEqual(code_of(self.formula(self.DAMPING, arguments="R zeta"), "python"),
                         "def f(R, zeta):\n    w = np.sqrt(1 - zeta * zeta)\n    theta = np.pi * w / R\n"
                         "    return np.sin(theta) / (R * w * (np.cosh(np.pi * zeta / R) + np.cos(theta)))\n")
        pair = self.formula("atan2(a,b)", "((1/2)*(-a))", arguments="a b")
        for formula, language, lines in (
                (self.formula(self.DAMPING), "matlab", "theta = pi .* w ./ R;"), (self.formula("(a-((b-1)*(-a)))"), "cxx", "return a - (b - 1) * -a;"),
                (pair, "cxx", "std::complex<double> f(double a, double b) {\n    return {std::atan2(a, b), 1.0 / 2 * -a};\n}\n"),
                (pair, "python", "return np.arctan2(a, b) + 1j * (1 / 2 * -a)\n"), (pair, "matlab", "y = complex(atan2(a, b), 1 ./ 2 .* -a);"),
                (self.formula("(2*sum((x*x)))", of_modes="x"), "python", "2 * np.sum(x * x)"),
                (self.formula("(2*sum((x*x)))", of_modes="x"), "cxx", "return 2 * (x * x).sum();"),
                (self.formula("sum(((x*a)/(x*a)))", of_modes="x"), "cxx",
                 "const std::valarray<double> t1 = x * a;\n    return (t1 / t1).sum();")):
            self.assertIn(lines, code_of(formula, language))
        self.assertEqual(javascript_of(self.formula("(pi*sum((x*sin(x))))", arguments="x", of_modes="x"), "printed"),
                         "(x, sum = (term) => x.reduce((all, _, i) => all + term(i), 0)) => "
                         "[(Math.PI*sum((i) => (x[i]*Math.sin(x[i]))))]")

    def test_order(self):
        """The operations keep their order: the code gives the same double as the expression with all its brackets."""
        functions = {name: getattr(math, name) for name in ("sqrt", "sin", "cos", "cosh", "pi")}
        for expression in (self.DAMPING, "(a+(b+(x-(a-b))))", "(a*(b*(x/(a/b))))", "((-((a*b)/x))/R)", "((-a)-(-(b*(-x))))"):
            scope = {"np": SimpleNamespace(**functions)}
            exec(code_of(self.formula(expression), "python"), scope)
            for seed in range(50):
                values = [random.Random(seed).uniform(0.1, 0.9) * (n + 1) / 5 for n in range(5)]
                self.assertEqual(scope["f"](*values), eval(expression, functions | dict(zip(("R", "zeta", "a", "b", "x"), values))), expression)


class Checks(Case):
    def doxygen(self, wrong):
        """What Doxygen says, with the options of the site, of a page (2) that has something after a link to (1)."""
        pages = self.folder / "wrong"
        pages.mkdir(exist_ok=True)
        for number, said in (("1", "x"), ("2", equation_link("1") + formula(r"\frac{a}{b}") + displayed("|x|") + wrong)):
            (pages / f"eq_{number}.md").write_text(f"# Equation ({number}) {{#eq_{number}}}\n\n{said}\n")
        options = (PROJECT / "docs/site/Doxyfile").read_text() + f"INPUT = {pages}\nINPUT_FILTER =\nGENERATE_TAGFILE =\n"
        return subprocess.run(["doxygen", "-"], input=options, cwd=PROJECT, env=os.environ | {"DENHARTOG_SITE": str(self.folder)},
                              stderr=subprocess.PIPE, text=True)

    @unittest.skipUnless(shutil.which("doxygen"), "needs Doxygen")
    def test_faults_for_doxygen(self):
        """Doxygen takes sound pages; unknown and doubled labels, raw LaTeX and open formulas are faults to it."""
        for sound in ("", "\\htmlonly[block]\n$ \\frac \\endhtmlonly"):
            self.assertEqual(self.doxygen(sound).returncode, 0)
        for wrong, told in ((r'\ref figure_nowhere "a figure"', "unable to resolve reference to 'figure_nowhere'"),
                            (r'\subpage nowhere "a page"', "unable to resolve reference to 'nowhere'"),
                            ("\\anchor eq_2\n", "multiple use of section label 'eq_2'"),
                            ("\\anchor eq_1\n", "multiple use of section label 'eq_1'"),
                            (r"the \frac{a}{b} of", r"unknown command '\frac'"), (r"the \beta of", r"unknown command '\beta'"),
                            (r"\f$ a + b", "inside formula"), (r"\f[ a + b", "inside formula"),
                            ("\\htmlonly[block]\n<p>", "without end marker")):
            found = self.doxygen(wrong)
            self.assertIn(told, found.stderr)
            self.assertNotEqual(found.returncode, 0, wrong)

    def test_faults(self):
        """Dollars outside of formulas and place-holders are faults."""
        page = equation_link("A.8") + formula(r"\frac{a}{b}") + displayed("|x|") + "\\htmlonly[block]\n$ {{ \\endhtmlonly"
        self.assertEqual(faults_of_pages({"eq_1": page}), [])
        for wrong, told in (("price 5 $ x", "page eq_1 has a dollar outside of a formula"),
                            ("{{equation 26}}", "page eq_1 has a place-holder")):
            self.assertTells(faults_of_pages({"eq_1": page + wrong}), told)

    def test_departures(self):
        """A departure is said in words, with the difference marked, and what it says must fit what is printed."""
        departure = SimpleNamespace(said="The sign of $b$ is wrong, see (37).", printed=r"a_{38}=\misprint{b}", holds=r"a=\mended{-b}",
                                    why="At $\\tau=0$ it is $$c$$ and not $b$.")
        departures = self.small.run.departures = defaultdict(Departure, {"38": departure})
        page = self.small.page("38")
        self.assertHas(page, r'The sign of \f$b\f$ is wrong, see \ref eq_37 "(37)".', r"\f[ a_{38}=\misprint{b} \f]")
        self.assertHas(page, r"<p>At \f$\tau=0\f$ it is </p>", r"\f[ c \f]", r"<p> and not \f$b\f$.</p>")
        self.assertLess(page.index("mended"), page.index("Why it is wrong"))
        self.assertLess(page.index("Why it is wrong"), page.index("The proof"))
        self.assertLess(page.index("The proof"), page.index("The function"))
        faults = lambda departures: faults_of_departures(departures, self.small.run.ledger)
        self.assertEqual(faults(departures), [])
        self.assertTells(faults(defaultdict(Departure)), "has no sentence")
        self.assertTells(faults(defaultdict(Departure, {"37": Departure(said="x", why="y")})), "does not depart")
        departure.printed = r"a_{38}=\misprint{c}"
        self.assertTells(faults(departures), "is not the printed formula")
        departure.printed, departure.holds = "a_{38}=b", "a=-b"
        self.assertTells(faults(departures), "shows no difference")
        departure.why = ""
        self.assertTells(faults(departures), "does not say why")


class Pages(Case):
    def test_equation(self):
        """The page of an equation has statement, correction, witness, function, steps, test and neighbours."""
        page = self.small.page("38")
        self.assertTrue(page.startswith("# Equation (38) {#eq_38}\n"))
        self.assertHas(page, r"\f[ a_{38}=b \f]", r"\f[ a=c \f]", r"\f$\mathrm{Re}\,V_{dj}\f$ = \f$\tfrac{1}{3}\f$",
                       r'\ref denhartog::paper::amplitude "paper::amplitude"', 'href="source:src/f.hpp:5"', "x < 1 ? x : 2;",
                       'href="source:derivation/c.cpp:1"', r"\f[ x^2=y \f]", 'href="source:tests/t.cpp:1"', r"previous: \ref eq_37",
                       r"next: \ref eq_39", r'<dt>Rests on</dt><dd>\ref eq_37 "(37)"</dd>')

    def test_snippet(self):
        """A snippet has the lines of the source from its template head to its closing brace."""
        snippet = Sources(self.small.folder).snippet(self.small.entry["functions"][0])
        self.assertEqual(snippet.text, "template <class T>\nT amplitude(const T& x) {\n    return x < 1 ? x : 2;\n}")

    def test_brief(self):
        """A function behind an equation has the sentence that tells it apart."""
        self.assertEqual(Sources(self.small.folder).snippet(self.small.entry["functions"][0]).brief, "X.")
        lines = ["/// @brief Of \\f$ u \\f$, where", "/// it is small.", "/// \\f[ x \\f]", "/// @eq{38}", "int f();"]
        self.assertEqual(Sources.brief(lines, 4), r"Of \f$ u \f$, where it is small.")
        self.assertEqual(Sources.brief(["", "int f();"], 1), "")

    def test_numbers_of_masses(self):
        """Of a claim for several numbers of masses one stands on the page of the equation, the others behind it."""
        for n in (1, 2):
            self.small.add_claim(self.small.entry, f"38/sum/N={n}")
        self.small.write("derivation/d.cpp", 'const char* id = "38/sum/";\n')
        view = equation_view(self.small.run, Sources(self.small.folder), self.small.entry)
        self.assertEqual([claim["id"] for claim in view["own"]], ["38/amplitude", "38/sum/N=1"])
        self.assertEqual([claim["id"] for claim in view["others"]], ["38/sum/N=2"])

    def test_what_is_missing(self):
        """A function that is not at its line, a claim without source or record, a test or a figure that is nowhere: no page."""
        def changed(change, told):
            self.setUp()
            change(self.small)
            with self.assertRaisesRegex(Fault, told):
                self.small.page("38")

        changed(lambda small: small.entry["functions"][0].update(line=6), "paper::amplitude must stand where the ledger has it")
        changed(lambda small: small.add_claim(small.entry, "nowhere"), "claim nowhere must be made in a source")
        changed(lambda small: small.run.claims.pop("38/amplitude"), "38/amplitude must be a claim with its steps")
        changed(lambda small: small.entry["tests"].append("a test that is nowhere"), "a test that is nowhere must be a test that ran")
        changed(lambda small: small.entry["figures"].append("none"), "none must be a figure of the run")

    def test_chapter(self):
        """The chapter replaces place-holders by the run's LaTeX and lists what it does not show."""
        (page,), faults = self.small.chapter("# All\n\nBy (37), $a<b$ in `code`.\n\n{{equation 38}}\n\n{{steps 38/amplitude}}\n\n{{claims 37}}\n")
        self.assertEqual(faults, [])
        self.assertHas(page, r'By \ref eq_37 "(37)", \f$a<b\f$ in <code>code</code>.', r"\f[ a=c\tag{38} \f]", r"\f[ x^2=y \f]", "37/sine")

    def test_chapter_with_pictures(self):
        """What is misprinted is said where it stands, and a chapter shows figures, pages to explore and links."""
        run = self.small.run
        run.departures["38"] = Departure(said="The sign is wrong.", why="y")
        run.places["38"] = "plane.html#r=1&b=2"
        run.figures["f"] = SimpleNamespace(name="f", label="figure_f", full_title="F", caption="It falls")
        (page,), faults = self.small.chapter("# All\n\nSee [this page](page:one_mass), (37).\n\n{{equation 38}}\n\n{{figure f}}\n\n{{explore 38}}\n\n"
                                             "{{claims 37}}\n\n{{claims 38}}\n")
        self.assertEqual(faults, [])
        self.assertHas(page, '<a href="one_mass.html">this page</a>, \\ref eq_37', "The print differs: The sign is wrong.", "eq_38_why",
                       'src="figures/f.svg"', 'src="explore/plane.html#r=1&amp;b=2"')

    def test_conclusions(self):
        """A statement of the text has its verdict, and the sentence on its claim the numbers of the run."""
        run = self.small.run
        record = run.claims["38/amplitude"]
        record |= {"witness": [{"name": "system", "value": "2DOF j=2 l=1 zeta=0.1"}, {"name": "r", "value": "0.29999999999999999"},
                               {"name": "beta", "value": "0.5"}, {"name": "cases", "value": "41"}, {"name": "error", "value": "0.1234"}],
                   "thresholds": [{"what": "error", "taken": 0.01, "turns": 1234567.0, "empty": 1, "decides": True}]}
        claims = [{"id": "38/amplitude", "verdict": "refuted"}]
        run.statements = [{"section": "Abstract", "statement": "It is small", "verdict": "refuted", "claims": claims, "remark": ""}]
        words = run.in_words["38/amplitude"] = {"verdict": "refuted", "words": "{system}: at $r={r}$ by {error:%} in {cases} cases."}
        page = lambda: self.small.render("conclusions")
        self.assertHas(page(), "1 statement,", '<strong>It is small.</strong> <span class="verdict refuted">false</span>',
                       r"Two masses, contact on mass 2, load on mass 1, \f$\zeta=0.1\f$: at \f$r=0.3\f$ by 12 \% in 41 cases.",
                       r"Error: we took 0.01; it would hold with \f$1.2\cdot10^{6}\f$.", "machine.html#N=2&amp;g=1&amp;k=1&amp;z=0.161803,0.0618034",
                       r"\ref claim_38_amplitude")
        words["words"] = "{nothing}"
        with self.assertRaisesRegex(Fault, "has no value {nothing}"):
            page()
        words |= {"words": "x", "verdict": "measured"}
        with self.assertRaisesRegex(Fault, "is refuted, its sentence is for measured"):
            page()
        del run.in_words["38/amplitude"]
        with self.assertRaisesRegex(Fault, "no sentence on 38/amplitude"):
            page()
        run.in_words["37/sine"] = words
        with self.assertRaisesRegex(Fault, "speaks of 37/sine"):
            page()

    def test_digits(self):
        """A number has the digits that it means."""
        for value, count, shown in ((0.4000000000000000222, 3, "0.4"), (0.0134123, 2, "0.013"), (43.744, 2, "44"), (0.99996, 3, "1.00"), (0, 2, "0"),
                                    (123456.7, 2, "120000"), (4281955.6, 2, r"$4.3\cdot10^{6}$"), (-1.8e-05, 2, r"$-1.8\cdot10^{-5}$")):
            self.assertEqual(text.digits(value, count), shown)

    def test_faults_of_the_chapter(self):
        """An unknown place-holder, claim or equation, an open formula and a claim that is left out are faults of the chapter."""
        _, faults = self.small.chapter("# All\n\n{{proof 38}}\n\n{{steps 38/none}}\n\n{{equation 99}}\n\n{{equation 38\n\n"
                                       "open $x\n\n{{claims 38}}\n")
        self.assertTells(faults, "{{proof 38}}", "{{steps 38/none}}", "{{equation 99}}", "not {{equation 38,", "must be closed",
                         "claim 37/sine is on a result")
        self.assertNotIn("38/amplitude", " ".join(faults))

    def test_borrowed_symbols(self):
        """A symbol that a claim borrows is shown as what it stands for, in steps and in witnesses."""
        self.small.run.stand_for = [{"claims": "38/.*", "symbols": [["x", r"\\eta"], [r"\\mathrm\{Re\}\\,V_\{dj\}", r"\\eta'"]]}]
        self.assertHas(self.small.page("38"), r"\f[ \eta^2=y \f]", r"\f$\eta'\f$ = ")

    def test_typeset_steps(self):
        """Formulas within a sentence of a step and the run's own names of symbols are typeset."""
        step = self.small.run.claims["38/amplitude"]["steps"][0]
        step["text_latex"] = "With $a_1$ as in (37)"
        self.small.run.symbols["V_jr"] = "V'_{jr}"
        self.assertHas(self.small.page("38"), r'With \f$a_1\f$ as in \ref eq_37 "(37)":', r"\f$V'_{jr}\f$ = ")
        step["text_latex"] = "With $a_1"
        with self.assertRaisesRegex(Fault, "must be closed"):
            self.small.page("38")

    def test_accuracy(self):
        """What the tests measured stands on the page of its equation alone."""
        self.small.run.accuracy.append({
            "function": "u", "equations": ["38"], "zone": "R near 1", "points": 7, "printed": None, "shipped": 1.5, "shipped_at": "0x1.8p-1",
            "type": "double"})
        self.assertHas(self.small.page("38"), "<td>R near 1</td><td>7</td><td>not finite</td><td>1.5</td>")
        self.assertNotIn("0x1.8p-1", self.small.page("37"))

    def test_kernel(self):
        """The kernel's verdict has theorems with their statements, and lemmas with what their letters stand for."""
        run = self.small.run
        theorem = {"name": "amplitude", "status": "checked", "says": "It is zeta_i"}
        self.small.entry["kernel"] = {"status": "checked", "theorems": [theorem], "negations": []}
        self.small.entry["claims"][0]["kernel"] = {"status": "checked", "file": "a.v", "lemmas": 4}
        self.small.add_claim(self.small.entry, "37/sine")  # without a lemma
        run.theorems = "Definition amplitude : Prop :=\n  forall x, x < 1.\n\nDefinition other : Prop := True.\n"
        lemma = {"generators": [{"name": "g", "stands_for": "sin x"}], "statement": "g = g"}
        run.certificates["38/amplitude"] = {"lemmas": [lemma] * 4}
        page = self.small.page("38")
        self.assertHas(page, '<span class="verdict proved">checked</span> <strong>Theorem amplitude</strong>: It is ', "x, x < 1.",
                       "<code>g</code> stands for <code>sin x</code>.", "4 identities", "The other 1 are in a.v.",
                       'unknown">not run</span> Claim <code>37/sine</code>.')
        self.assertNotIn("True", page)

    def test_overviews(self):
        """Departures and the index count what the ledger has."""
        self.small.run.departures["38"] = Departure(said="x", why="y")
        self.assertHas(self.small.render("errata"), "1 of the 2 equations depart", r"\ref claim_38_amplitude")
        self.assertHas(self.small.render("stand_ins"), "<code>sinc</code>", r"\f$x \mapsto \sin(x)/x\f$")
        self.assertHas(self.small.render("equations"), "2 equations", "1 refuted",
                       r'\subpage eq_38 "(38)"', "2.3 The mass in contact")

    def test_whole_site(self):
        """A run whose departures or pages have a fault is refused."""
        make = lambda: site.make_pages(self.small.run, Sources(self.small.folder), self.small.folder / "docs/chapter")
        rest = [entry(number) for number in EQUATIONS if number not in ("37", "38")]
        self.small.run.ledger += rest
        self.small.run.entries |= {each["equation"]: each for each in rest}
        self.assertTells(make()[1], "(38) departs from the print and has no sentence")
        self.small.run.departures["38"] = Departure(said="{{x}}", why="y")
        self.assertTells(make()[1], "page eq_38 has a place-holder")
        self.small.run.departures["38"] = Departure(said="x", why="y")
        self.small.run.entries["67"]["remark"] = "it errs on the unsafe side of (69)"
        pages, faults = make()
        self.assertEqual((faults, len(pages)), ([], 103 + 14))
        self.assertHas(pages["eq_67"], r'<p>It errs on the unsafe side of \ref eq_69 "(69)".</p>')
        files = site.script_files(self.small.run)
        self.assertEqual(json.loads(files["statements.json"])["38"], {"said": "as printed: refuted. x", "latex": "a=c"})
        self.assertEqual(files["sections.js"], 'window.siteSections = {\n"section 2.3": "equations.html#equations_2_3"\n};\n')

    def test_graph(self):
        """In the graph every equation stands below what it rests on, with a link and its verdict; no line repeats two others."""
        rows = json.loads((PROJECT / "docs/ledger/equations.json").read_text())
        self.small.run.ledger = [entry(row["equation"], rests_on=row["rests_on"]) for row in rows]
        self.small.run.ledger[5]["printed"] = "refuted"
        page = lxml_html.fromstring("<div>" + self.small.render("equation_graph").partition("\\htmlonly[block]")[2] + "</div>")
        nodes = {node.findtext("title"): node for node in page.find_class("node") if node.tag == "g"}
        lines = [line.findtext("title").split("->") for line in page.find_class("edge")]
        height = {number: float(node.xpath(".//text/@y")[0]) for number, node in nodes.items()}
        self.assertEqual(sorted(nodes), sorted(EQUATIONS))
        self.assertEqual(nodes["6"].get("class"), "node refuted")
        self.assertEqual([(link.get("href"), link.get("aria-label")) for link in nodes["6"].iter("a")],
                         [("eq_6.html", "Equation (6), refuted as printed")])
        above = {row["equation"]: set(row["rests_on"]) for row in rows}
        for ground, number in lines:
            self.assertLess(height[ground], height[number])
            self.assertIn(ground, above[number])
        leads = lambda number: above[number].union(*map(leads, above[number]))
        for number, grounds in above.items():
            indirect = set().union(*map(leads, grounds))
            self.assertEqual({ground for ground, to in lines if to == number}, grounds - indirect)


class Finished(Case):
    def setUp(self):
        super().setUp()
        self.write("tags.xml", '<tagfile>\n<compound kind="file">\n<name>mode.hpp</name>\n'
                               f'<path>{self.folder.resolve()}/checkout/src/a/</path>\n<filename>a_2mode_8hpp</filename>\n'
                               '<member kind="function"><name>d</name></member>\n</compound>\n</tagfile>\n')

    def write(self, name, content):
        (self.folder / name).parent.mkdir(parents=True, exist_ok=True)
        (self.folder / name).write_text(content)

    def finish(self):
        return finish.finish(self.folder / "site", self.folder / "tags.xml", self.folder / "checkout")

    def test_links_to_sources(self):
        """Links to lines of sources are resolved through the tag file, or reported."""
        self.write("site/a_2mode_8hpp_source.html", '<a id="l00042"></a>')
        self.write("site/eq_46.html", '<a href="source:src/a/mode.hpp:42">x</a><a href="source:src/a/mode.hpp">y</a>')
        self.assertEqual(self.finish()[1], [])
        self.assertHas((self.folder / "site/eq_46.html").read_text(),
                       '<a href="a_2mode_8hpp_source.html#l00042">x</a><a href="a_2mode_8hpp_source.html">y</a>')
        self.write("site/bad.html", '<a href="source:src/a/mode.hpp:43"><a href="source:src/b.hpp:1">'
                                    '<a href="source:src/a/mode.hpp:x"><a href="source:">')
        self.assertEqual(len(self.finish()[1]), 4)
        self.assertTells(self.finish()[1], "leads to source:src/b.hpp", "#l0000x, but", "leads to source:, which",
                         "leads to a_2mode_8hpp_source.html#l00043, but there is no such place")

    def test_headings_and_tables(self):
        """A page gets its title as a heading, and a table a box to scroll in."""
        for before, after in (
                ('<div class="headertitle"><div class="title">E (46)</div></div>', '<div class="headertitle"><div><h1 class="title">E (46)</h1></div></div>'),
                ('<div class="title">T</div><h1>S</h1><h2>U</h2>', '<div><h1 class="title">T</h1></div><h2>S</h2><h3>U</h3>'),
                ('<table class="markdownTable">x</table>y', '<div class="table-box" tabindex="0"><table class="markdownTable">x</table></div>y'),
                ('<div class="title">f<div class="ingroups">g</div></div>', '<div><h1 class="title">f</h1><div class="ingroups">g</div></div>')):
            self.assertEqual(finish.finished_page(before, {}), after)

    def test_search(self):
        """The search knows a page and each documented name on it."""
        page = ('<h1 class="title">paper</h1><div class="contents"><p>The formulas, R &lt; 1.</p>'
                '<a id="a1" name="a1"></a><h2 class="memtitle"><span class="permalink"><a href="#a1">&#9670;</a></span>d()</h2>'
                '<div class="memitem"><div class="memproto">d(tau)</div><div class="memdoc"><p>Free <b>motion</b> \\(d_i\\).</p>'
                '</div></div></div>')
        documents = lambda page, name: finish.search_documents(lxml_html.document_fromstring(page), name)
        self.assertEqual(documents(page, "paper.html"),
                         [{"kind": 2, "text": "The formulas, R < 1.", "title": "paper", "url": "paper.html"},
                          {"kind": 2, "text": "Free motion d_i.", "title": "d()", "url": "paper.html#a1"}])
        self.assertEqual(documents("<p>no heading</p>", "x.html"), [])
        named = '<h1 class="title">Equation (69)</h1><div class="contents"><p><span class="named">Boundary of sliding</span></p></div><footer>'
        self.assertEqual([each["title"] for each in documents(named, "eq_69.html")], ["Equation (69): Boundary of sliding"])
        kinds = [finish.kind_of_page(name) for name in ("eq_57.html", "figure_fig07.html", "errata.html", "eq_57_more.html",
                                                        "structdenhartog_1_1Boundary.html")]
        self.assertEqual(kinds, sorted(set(kinds)))
        self.assertEqual(finish.text_of(lxml_html.fromstring("<p><script>x</script> a\n <i>b</i>&amp;lt; </p>")), "a b &lt;")

    def test_faults_of_the_site(self):
        """A broken link, a missing place and an address elsewhere are faults of the site."""
        self.write("site/a.html", '<h1 class="title">A</h1><div class="contents"><a href="b.html#there">b</a> '
                                  '<a href="#own" id="own">o</a> <a href="b.html?q=1">q</a>'
                                  ' <script src="search-documents.js"></script></div>')
        self.write("site/b.html", '<p id="there">b</p>')
        place = self.folder / "site"
        self.assertEqual(self.finish(), ("2 pages, 4 links followed, 1 entries for the search", []))
        self.assertTrue((place / "search-documents.js").exists() and (place / "sitemap.txt").exists())
        self.write("site/paper.html", f'<a href="{finish.PAPER}">the paper</a>')
        self.assertEqual(self.finish()[1], [])
        for wrong in ('<a href="none.html">x</a>', '<a href="b.html#nowhere">x</a>', '<a href="#nowhere">x</a>', '<img src="none.svg">',
                      '<a href="https://example.org">x</a>', '<a href="mailto:x">x</a>'):
            self.write("site/c.html", wrong)
            self.assertEqual(len(self.finish()[1]), 1, wrong)

    def test_trim(self):
        """The site leaves out pages that nobody reads; links to a file lead to its source, and the text of others stays."""
        trees = finish.trim({
            "eq_80.html": '<a href="structA-members.html">list</a> <a href="c_8h.html#there">c</a>',
            "structA-members.html": "<p>",
            "y_8cpp.html": "<p>", "c_8h.html": '<a href="y_8cpp.html#there">y</a>', "functions_vars.html": "<p>",
            "y_8cpp_source.html": '<div class="summary"><a href="#nowhere">Functions</a></div>'
                                  '<a href="y_8cpp.html">Go to the documentation of this file.</a><a href="dir_1.html">B</a>'})
        texts = {name: lxml_html.tostring(tree, encoding="unicode") for name, tree in trees.items()}
        self.assertEqual(list(texts), ["eq_80.html", "c_8h.html", "y_8cpp_source.html"])
        self.assertHas(texts["eq_80.html"], '>list <a href="c_8h.html#there">c</a><')
        self.assertHas(texts["y_8cpp_source.html"], ">B<")
        self.assertNotRegex(texts["y_8cpp_source.html"], "Go to|nowhere")
        self.assertHas(texts["c_8h.html"], '<a href="y_8cpp_source.html">y</a>')


if __name__ == "__main__":
    unittest.main()
