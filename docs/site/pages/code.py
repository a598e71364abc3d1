"""A formula of the library as a function in another language, with a name for each computation that is needed twice.

The library writes an expression down with brackets around each operation. All languages read sums and products as Python does,
so that Python's own printer leaves out the brackets that say nothing, and the order of the operations stays.
"""
import ast
import re
from collections import Counter, namedtuple

Language = namedtuple("Language", "head assignment result pair end words prefix operators", defaults=[("$^", "")])
LANGUAGES = {
    "cxx": Language("{kind} {name}({typed}) {{", "const {0} {1} = {2};", "return {};", "return {{{}, {}}};", "}\n",
                    {"pi": "std::numbers::pi"}, "std::", (r"(?<![\w.])(\d+) / (?=\d)", r"\1.0 / ")),  # 1 / 2 is 0 there
    "python": Language("def {name}({plain}):", "{1} = {2}", "return {}", "return {} + 1j * ({})", "",
                       {"pi": "np.pi", "atan2": "np.arctan2"}, "np."),
    "matlab": Language("function y = {name}({plain})", "{1} = {2};", "y = {};", "y = complex({}, {});", "end\n",
                       {}, "", (r" ([*/]) ", r" .\1 "))}  # lists are multiplied as matrices
NAMES = {"sqrt(1 - zeta * zeta)": "w", "pi * sqrt(1 - zeta * zeta) / R": "theta", "pi * zeta / R": "delta", "pi * zeta": "delta",
         "1 / R": "Omega"}  # what the paper, or the notation page, calls a computation
MARK = re.compile(r"__\d+")  # stands for a computation in another one


def plain(text):
    return ast.unparse(ast.parse(text, mode="eval"))


def code_of(formula, language):
    """What the library computes as a function in a language."""
    say, arguments, lists = LANGUAGES[language], formula["arguments"], formula["of_modes"]
    computations, results = {}, formula["holds"]
    mark = lambda found: f"__{computations.setdefault(found[0], len(computations))}"
    while any("(" in result for result in results):  # from the innermost brackets to the outer ones
        results = [re.sub(r"\w*\([^()]*\)", mark, result) for result in results]
    uses = Counter(MARK.findall(" ".join([*computations, *results])))

    def written(text):
        text = re.sub(r"(?<![.\w])(pi\b|[a-z]\w*(?=\())", lambda word: say.words.get(word[0], say.prefix + word[0]), plain(text))
        return re.sub(*say.operators, text)

    shown, full, taken, body = {}, {}, set(arguments), ""
    kinds = {True: "std::valarray<double>", False: "double"}
    for computation, number in computations.items():
        within = lambda texts: MARK.sub(lambda found: texts[found[0]], computation)
        at, text, full[f"__{number}"] = f"__{number}", within(shown), within(full)
        if say.prefix == "std::" and text.startswith("sum("):
            text = f"({text[4:-1]}).sum()"
        shown[at] = text
        if uses[at] > 1 and not re.fullmatch(r"\(-\w+\)", text):
            names = [NAMES.get(plain(full[at]))] + [f"t{n}" for n in range(1, 100)]
            shown[at] = next(name for name in names if name and name not in taken)
            taken.add(shown[at])
            is_list = "sum(" not in full[at] and not set(lists).isdisjoint(re.findall(r"\w+", full[at]))
            body += f"    {say.assignment.format(kinds[is_list], shown[at], written(text))}\n"
    results = [written(MARK.sub(lambda found: shown[found[0]], result)) for result in results]
    typed = [f"const {kinds[True]}& {each}" if each in lists else f"double {each}" for each in arguments]
    head = say.head.format(name=formula["name"], plain=", ".join(arguments), typed=", ".join(typed),
                           kind="std::complex<double>" if len(results) > 1 else "double")
    return f"{head}\n{body}    {(say.pair if len(results) > 1 else say.result).format(*results)}\n{say.end}"


def javascript_of(formula, form):
    """What the library computes, or what is printed, for the script of a page: not for reading, a sum taken mode by mode."""
    lists, words = formula["of_modes"], {"pi": "Math.PI", "sum(": "sum((i) => "}
    in_script = lambda word: words.get(word, f"{word}[i]" if word in lists else "Math." + word if word[-1] == "(" else word)
    results = [re.sub(r"[A-Za-z]\w*\(?", lambda word: in_script(word[0]), result) for result in formula[form]]
    sums = [f"sum = (term) => {lists[0]}.reduce((all, _, i) => all + term(i), 0)"] if lists else []
    return f"({', '.join(formula['arguments'] + sums)}) => [{', '.join(results)}]"
