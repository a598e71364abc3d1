"""The page of a numbered equation, and the page behind it with the library's other forms: what the templates show."""
import re
from types import SimpleNamespace

from .conclusions import number_of_ours, sentence_on
from .records import meant_by, named, record_of, symbols_in
from .text import (EQUATIONS, counted, displayed, equation_label, escaped, fails, formula, label, prose, symbol, typeset,
                   without_marks)

LONGEST_FORMULA = 500  # longer ones are left to the record: nobody reads them, and they take seconds to typeset
ABBREVIATED, DIVISORS = "Abbreviations", "where no divisor is zero"  # steps of the record that are no steps of the argument
ROLES = {"both": "on the formula as printed and as shipped", "printed": "on the formula as printed",
         "shipped": "on the formula as shipped", "observation": "on what the text says about it"}
KINDS = {"refinement": "a refinement of a shipped formula", "restated": "a definition restated",
         "consequence": "a consequence of shipped formulas", "argument": "with an argument that a person gave",
         "observation": "observed"}
# Values to start from, inside the domain of every formula; those of the modes are lists.
SAMPLES = {"R": "0.8", "zeta": "0.05", "tau": "1", "beta": "0.3", "mu": "1.5", "V_dk_re": "1.2", "V_dk_im": "-0.4",
           "V_dj_re": "0.9", "V_dj_im": "-0.7", "U_dj": "0.25", "U_dk": "0.15", "U_j": "0.25", "U_k": "0.15", "G_j": "0.1",
           "G_k": "0.12", "psi_ji": "0.6", "psi_li": "0.7", "psi_ki": "0.5", "eta_0": "0.8", "eta_prime_0": "-0.3",
           "phi_j": "0.4", "sgn_x_dot": "1", "X_j": "1.1", "S_dj": "1.3", "H_j": "0.4", "gamma_j": "2", "r": "0.9", "k_1": "3",
           "P": "2", "m_1": "2", "omega": "1.5", "A": "-1.7", "B": "0.4", "C": "0.9", "Q": "1.2", "V_k_abs": "6", "x_k0": "0.6",
           "x_prime_k0": "-0.2"}
SAMPLES_OF_MODES = {"R": "0.8, 0.3", "zeta": "0.05, 0.03", "psi_k": "0.6, 0.7", "psi_j": "0.6, -0.7", "psi_l": "0.5, 0.8"}


# Claims


def steps_of(run, record):
    """The steps of a claim: a sentence and formulas each; what abbreviations stand for is looked up and comes last."""
    steps = []
    for step in record["steps"]:
        text, latex, here = step["text"], meant_by(run, record["claim"], step["latex"]), step["text"] == ABBREVIATED
        if text == DIVISORS and steps:
            steps[-1].update(text=steps[-1]["text"].removesuffix("."), condition=text + "\n" + displayed(latex))
            continue
        said, long = typeset(step.get("text_latex", text), record["claim"]), len(latex) > LONGEST_FORMULA and not here
        steps.append({"here": here, "text": "Here" if here else said + (":" if latex else "."), "condition": "",
                      "latex": "" if long else latex, "left_out": len(latex) if long else 0})
    return sorted(steps, key=lambda step: step["here"])


def claim_view(run, sources, claim, equation):
    """A claim in full; its steps stand on the page of the equation that its id begins with, else of its first one."""
    record, again = record_of(run, claim["id"]), claim.get("same_as", "")
    home = sorted(record["equations"], key=lambda number: number != record["claim"].partition("/")[0])[0]
    witness, thresholds = claim.get("witness", {}), claim.get("thresholds", [])
    again = f" (it says the same as {escaped(again)})" if again else ""
    return dict(
        claim, record=record, home=home, here=home == equation, place=sources.claim(claim["id"]),
        label=label("claim", record["claim"]),
        bears=f"{KINDS.get(claim['kind'], 'derived')}{again}, {ROLES.get(claim['role'], 'a step of the argument')}",
        witness=witness if witness != run.entries[equation]["witness"] else {},  # which stands at the head of the page
        said=sentence_on(run, claim["id"], claim["verdict"]), thresholds=[number_of_ours(threshold) for threshold in thresholds],
        whatever=claim["verdict"] == "refuted" and not any(t["decides"] for t in thresholds),
        steps=steps_of(run, record))


def sorted_claims(entry):
    """The equation's own claims, about the paper's formula and not about a form of it; all others; observations."""
    decides = lambda claim: claim["role"] != "step" and not claim.get("same_as")
    is_form = lambda claim: claim["kind"] == "refinement"
    observations = [claim for claim in entry["claims"] if claim["role"] == "observation"]
    claims = [claim for claim in entry["claims"] if claim not in observations]
    its = [claim for claim in claims if decides(claim) and claim["id"].startswith(entry["equation"] + "/")]
    own = [claim for claim in its if not is_form(claim)]
    if all(claim["role"] == "printed" for claim in own):  # (A.12) is decided by how a shipped formula follows from others
        own += [claim for claim in its if is_form(claim)]
    first = {re.sub("/N=.*", "", claim["id"]): claim for claim in reversed(own)}  # of the numbers of masses one is shown
    own = [claim for claim in own if first[re.sub("/N=.*", "", claim["id"])] is claim]
    others = sorted((claim for claim in claims if claim not in own), key=lambda claim: not decides(claim) or is_form(claim))
    if not own:  # (26) is decided by the claims on (A.13)
        own = [claim for claim in others if decides(claim) and not is_form(claim)] or others[:1]
        others = [claim for claim in others if claim not in own]
    return sorted(own, key=lambda claim: claim["role"] == "printed"), others, observations  # first what holds


# Witnesses and statements


def witness_names(run, witness, claim=""):
    """The values of a witness with their names typeset, as the derivation has them if it does; last what fails and what holds."""
    latex = {name: meant_by(run, claim, run.symbols.get(name) or symbol(name, True)) for name in witness}
    words = {"derived": "what holds", "under test": "as printed" if claim.endswith("/printed") else "the formula"}
    return [(formula(latex[name]) if latex[name] else prose(words.get(name, name)), witness[name])
            for name in sorted(witness, key=["under test", "derived"].__contains__)]


def statement_of(run, entry):
    """The printed formula and the one that holds, with the difference marked where a person has marked it."""
    departure, read = run.departures[entry["equation"]], entry["statement"]
    held = departure.holds or entry["correction"]
    plain = without_marks(held)
    why = "".join(displayed(part) if at % 2 else f"<p>{typeset(part, 'docs/ledger/departures.json')}</p>"
                  for at, part in enumerate(re.split(r"\$\$(.*?)\$\$", departure.why)) if part)
    return SimpleNamespace(why=why, printed=departure.printed or read, held=held, plain=plain or read,
                           short=held and max(map(len, (read, plain))) < 110, symbols=symbols_in(run.notation, f"{read} {plain}"))


def theorems_of(ledger):
    """All theorems of the kernel by their names, in the order of the equations: what each says, and of which equations."""
    theorems = {}
    for entry in ledger:
        for theorem in entry["kernel"]["theorems"] + entry["kernel"]["negations"]:
            theorems.setdefault(theorem["name"], theorem | {"equations": []})["equations"].append(entry["equation"])
    return theorems


# The page


def in_namespace(functions, name):
    return [function for function in functions if f"::{name}::" in function["name"]]


def equation_view(run, sources, entry):
    """All that the two pages of an equation show."""
    equation, functions = entry["equation"], entry["functions"]
    at = EQUATIONS.index(equation)
    paper, forms = in_namespace(functions, "paper"), in_namespace(functions, "evaluation")
    callers = [function for function in functions if function not in paper and function not in forms]
    own, others, observations = ([claim_view(run, sources, claim, equation) for claim in claims]
                                 for claims in sorted_claims(entry))
    accuracy = [row for row in run.accuracy if row["type"] == "double" and equation in row["equations"]]
    more = [what for there, what in (
        (forms, "the forms that keep their digits"), (others, counted(len(others), "further claim", "further claims")),
        (accuracy, "the measured accuracy"), (callers, "the functions that use it")) if there]
    return dict(
        entry=entry, equation=equation, name=equation_label(equation), statement=statement_of(run, entry),
        fails=fails(entry["printed"]), more=more, accuracy=accuracy, place=run.places.get(equation),
        previous=EQUATIONS[at - 1] if at else None, next=EQUATIONS[at + 1] if at + 1 < len(EQUATIONS) else None,
        own=own, others=others, observations=observations, paper=paper, forms=forms, callers=callers,
        code=run.formulas.get(equation), questions=run.questions.get(equation, []),
        figures=[named(run.figures, name, "a figure of the run; run ./verify figures") for name in entry["figures"]],
        tests=[(name, verdict, named(run.tests, name, "a test that ran"))
               for key, verdict in (("tests_failed", "failed"), ("tests", "passed")) for name in entry[key]])
