"""A formula of the library as a function in another language, with a name for each computation that is needed twice.

The library writes an expression down with brackets around each operation. All four languages read sums and products as Python
does, so that Python's own printer leaves out the brackets that say nothing, and the order of the operations stays.
"""
import ast
import re
from collections import Counter, namedtuple
from functools import cache

Language = namedtuple("Language", "head assignment result pair end pi prefix loop")
LANGUAGES = {
    "cxx": Language("{type} {name}({typed}) {{", "const double {} = {};", "return {};", "return {{{}, {}}};", "}\n",
                    "std::numbers::pi", "std::",
                    "double {0} = 0;\n    for (std::size_t i = 0; i < {1}.size(); ++i) {{\n{2}        {0} += {3};\n    }}\n"),
    "python": Language("def {name}({plain}):", "{} = {}", "return {}", "return {} + 1j * ({})", "", "np.pi", "np.", ""),
    "matlab": Language("function y = {name}({plain})", "{} = {};", "y = {};", "y = complex({}, {});", "end\n", "pi", "", ""),
    "javascript": Language("function {name}({plain}) {{", "const {} = {};", "return {};", "return [{}, {}];", "}\n",
                           "Math.PI", "Math.",
                           "let {0} = 0;\n    for (let i = 0; i < {1}.length; ++i) {{\n{2}        {0} += {3};\n    }}\n")}
NAMES = {"sqrt(1 - zeta * zeta)": "w", "pi * sqrt(1 - zeta * zeta) / R": "theta", "pi * zeta / R": "delta", "pi * zeta": "delta",
         "1 / R": "Omega"}  # what the paper, or the notation page, calls a computation


key_of = cache(ast.unparse)  # the same for the same computation


class Writer(ast.NodeTransformer):
    """Writes one formula in one language; within a loop over the modes, `scope` is what is summed."""

    def __init__(self, formula, language):
        self.formula, self.language, self.scope, self.body = formula, LANGUAGES[language], "", ""
        self.uses, self.names, self.taken = Counter(), {}, set(formula["arguments"])

    def function(self, name, expressions):
        """The lines of the function."""
        results = [ast.parse(expression, mode="eval").body for expression in expressions]
        for result in results:
            self.count(result, "")
        written = [self.text(self.visit(result)) for result in results]
        pair, arguments, of_modes = len(results) > 1, self.formula["arguments"], self.formula["of_modes"]
        typed = [("const std::vector<double>& " if each in of_modes else "double ") + each for each in arguments]
        head = self.language.head.format(name=name, type="std::complex<double>" if pair else "double", plain=", ".join(arguments),
                                         typed=", ".join(typed))
        return f"{head}\n{self.body}    {self.language[3 if pair else 2].format(*written)}\n{self.language.end}"

    def text(self, node):
        """A computation as text: C++ would divide integers as integers, and MATLAB multiply lists as matrices."""
        text = ast.unparse(node)
        if self.language is LANGUAGES["cxx"]:
            return re.sub(r"(?<![\w.])(\d+) / (?=\d)", r"\1.0 / ", text)
        return re.sub(r" ([*/]) ", r" .\1 ", text) if self.language is LANGUAGES["matlab"] else text

    def count(self, node, scope):
        """How often a computation is needed; what stands within a loop over the modes stays there."""
        key = scope, key_of(node)
        self.uses[key] += 1
        if self.uses[key] == 1:
            inner = key[1] if key[1].startswith("sum(") and self.language.loop else scope
            for child in ast.iter_child_nodes(node):
                self.count(child, inner)

    def visit(self, node):
        """A computation with names for what is needed twice, whose assignments stand in the body."""
        plain = isinstance(node, (ast.Name, ast.Constant, ast.operator, ast.unaryop, ast.expr_context))
        if plain or isinstance(node, ast.UnaryOp) and isinstance(node.operand, (ast.Name, ast.Constant)):
            return super().visit(node)
        key = self.scope, key_of(node)
        if key not in self.names:
            made = super().visit(node)
            if self.uses[key] < 2:
                return made
            self.names[key] = self.free([NAMES.get(key[1])] + [f"t{n}" for n in range(1, 100)])
            self.body += f"    {self.language.assignment.format(self.names[key], self.text(made))}\n"
        return ast.Name(self.names[key])

    def free(self, names):
        """The first of the names that is not taken."""
        name = next(name for name in names if name and name not in self.taken)
        self.taken.add(name)
        return name

    def visit_Name(self, node):
        indexed = self.scope and node.id in self.formula["of_modes"]
        return ast.Name(self.language.pi if node.id == "pi" else f"{node.id}[i]" if indexed else node.id)

    def visit_Call(self, node):
        name = node.func.id
        if name == "sum" and self.language.loop:
            return self.loop(node)
        name = "arctan2" if name == "atan2" and self.language.prefix == "np." else name
        return ast.Call(ast.Name(self.language.prefix + name), [self.visit(each) for each in node.args], [])

    def loop(self, node):
        """A sum over the modes in a loop with names of its own."""
        name, before, outside = self.free(["sum"] + [f"sum_{n}" for n in range(2, 100)]), self.body, self.scope
        text, self.body, self.scope = key_of(node), "", key_of(node)
        term = self.text(self.visit(node.args[0]))
        lines = "".join(f"    {line}\n" for line in self.body.splitlines())
        first = next(each for each in self.formula["of_modes"] if each in text)
        self.body, self.scope = f"{before}    {self.language.loop.format(name, first, lines, term)}", outside
        return ast.Name(name)


def code_of(formula, language, form="holds"):
    """What the library computes as a function in a language, or what is printed, where it is refuted."""
    return Writer(formula, language).function(formula["name"] + ("" if form == "holds" else "_as_printed"), formula[form])
