"""A study: the grid over which a scene varies, its division into chunks, and what is computed of each chunk.

The axes of the grid are those of the study in its order, but `sample`, frequency and friction come last. A chunk is a box of the
grid, and chunks count in the order of the grid, the last axis running fastest. No chunk divides a column of friction, nor an axis
over which exact quantiles are taken.
"""
from __future__ import annotations

import copy
import difflib
import functools
import json
import math
import pathlib
import re
from dataclasses import dataclass
from typing import Any, Mapping, Optional

import numpy as np

from . import _batch
from ._errors import InputError
from ._results import STATUSES
from ._system import System, plain

Arrays = dict[str, np.ndarray]
NO_SCENE = len(STATUSES)  # the status of a point whose sample has numbers that make no scene
MOST_POINTS_TOGETHER, MOST_CHUNKS = 2**24, 10_000_000
KINDS = {"status": np.int8, "regime": np.int8, "stops_per_period": np.int32, "periods": np.int32}  # fields that count
COLUMNS = ("r", "frequency_hz", "beta", "friction")
KEYS = {"mu": ["mu"], "zeta": ["damping_ratios"], "mass": ["masses", "mass_ratios"],
        "stiffness": ["stiffnesses", "stiffness_ratios"], "contact": ["contact"], "load": ["load"], "force": ["force"], "unbalance": ["unbalance"]}


@dataclass(frozen=True)
class Plan:
    """A study on its grid. `axes` has the values along each axis, `drawn` what was drawn for each sample, by their names."""

    study: dict[str, Any]
    axes: Arrays
    drawn: Arrays
    chunk: tuple[int, ...]

    @property
    def shape(self) -> tuple[int, ...]:
        """The number of points along each axis."""
        return tuple(values.size for values in self.axes.values())

    @property
    def boxes(self) -> tuple[int, ...]:
        """The number of chunks along each axis."""
        return tuple(-(-size // of_chunk) for size, of_chunk in zip(self.shape, self.chunk))

    @property
    def chunks(self) -> int:
        """The number of chunks."""
        return math.prod(self.boxes)

    def slices(self, K: int) -> dict[str, slice]:
        """The part of each axis that chunk K has."""
        place = np.unravel_index(K, self.boxes)
        return {name: slice(int(n) * of_chunk, min(int(n + 1) * of_chunk, values.size))
                for (name, values), n, of_chunk in zip(self.axes.items(), place, self.chunk)}

    def names_of(self, field: str) -> list[str]:
        """The axes that a field or a reduction has."""
        for r in self.study["reduce"]:
            if r["name"] == field:
                return [name for name in self.names_of(r.get("of", "")) if name not in r["over"]]
        return list(self.axes)

    def axes_of(self, r: Mapping[str, Any]) -> tuple[list[str], tuple[int, ...], list[int]]:
        """The axes that a reduction begins with; which of them it is over, and the sizes of these."""
        names = self.names_of(r.get("of", ""))
        over = tuple(n for n, name in enumerate(names) if name in r["over"])
        return names, over, [self.axes[names[n]].size for n in over]


def must(holds: bool, quantity: str, rule: str, value: object) -> None:
    """Raises an InputError unless a rule holds."""
    if not holds:
        raise InputError.of(quantity, rule, value)


# ---- the text of a study ----------------------------------------------------------------------------------------------------

def _schema() -> dict[str, Any]:
    """docs/study.schema.json, which a wheel has beside this file."""
    here = pathlib.Path(__file__).resolve()
    beside = here.with_name("study.schema.json")
    return json.loads((beside if beside.exists() else here.parents[3] / "docs/study.schema.json").read_text(encoding="utf-8"))


def _refusal(error: Any) -> InputError:
    """What jsonschema found, in the words of this package."""
    place = "".join(f"/{step}" for step in error.absolute_path)
    keys = [step for step in error.absolute_path if isinstance(step, str)] or ["the study"]
    rule_of = {"type": "must be of the type {}", "enum": "must be one of {}", "minimum": "must be at least {}",
               "maximum": "must be at most {}", "exclusiveMinimum": "must be above {}", "minItems": "must have at least {} entry",
               "pattern": "must match {}"}
    if error.validator == "additionalProperties":
        known = list(error.schema["properties"])
        key = next(key for key in error.instance if key not in known)
        near = "".join(f" (did you mean {each}?)" for each in difflib.get_close_matches(key, known, 1))
        return InputError.of(keys[-1], f"must have no keys but {', '.join(known)}{near}",
                             f"given {json.dumps(key)[:64]} (at {place})")
    if error.validator == "required":
        missing = next(key for key in error.validator_value if key not in error.instance)
        return InputError.of(missing, "must be given", f"nothing (at {place})")
    rule = rule_of.get(error.validator, "must keep the rule: " + error.schema.get("description", "see docs/study.schema.json"))
    limit = ", ".join(error.validator_value) if error.validator == "enum" else error.validator_value
    return InputError.of(keys[-1], rule.format(limit), f"{json.dumps(error.instance)[:64]} (at {place})")


def _unique(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    """An object of JSON whose keys must differ."""
    keys = [key for key, _ in pairs]
    for key in keys:
        must(keys.count(key) == 1, json.dumps(key), "must be given once", "given twice")
    return dict(pairs)


def read(text: str) -> dict[str, Any]:
    """A study from its text in JSON; docs/study.schema.json has its form."""
    def refused(number: str) -> None:
        raise InputError.of("the study", "must have finite numbers", number)

    try:
        return json.loads(text, object_pairs_hook=_unique, parse_constant=refused)
    except RecursionError as reason:
        raise InputError.of("the study", "must be JSON that is not nested deeper than a study is", "deeper") from reason
    except json.JSONDecodeError as reason:
        raise InputError.of("the study", "must be JSON", f"not: {reason}") from reason


# ---- from a study to its grid ------------------------------------------------------------------------------------------------

def _name_of(item: Mapping[str, Any]) -> str:
    """The name of what varies: r, zeta_2, mass_factor."""
    entry = f"_{int(item['entry'])}" if "entry" in item else ""
    return item["quantity"] + entry + ("_factor" if item.get("as") == "factor" else "")


def _target(name: str) -> tuple[str, Optional[int], bool]:
    """Quantity, entry and whether it is a factor, from such a name."""
    found = re.fullmatch(f"({'|'.join([*COLUMNS, *KEYS])})(?:_([1-9][0-9]*))?(_factor)?", name)
    must(found is not None, name[:64], f"must vary one of {', '.join([*COLUMNS, *KEYS])}, as in zeta_2 or mass_factor", "another")
    quantity, entry, factor = found[1], found[2], bool(found[3])
    must(not entry or quantity in ("zeta", "mass", "stiffness"), name, "must name an entry of zeta, mass, stiffness only", entry)
    must(not factor or quantity not in ("contact", "load"), name, "must be value for contact and load", "factor")
    return quantity, None if entry is None else int(entry), factor


def spaced(name: str, item: Mapping[str, Any]) -> np.ndarray:
    """The values of an axis, or the ends of bins: both ends as they are given, and those between as `denhartog map` has them."""
    numbers = [*item.get("values", ()), *(item[end] for end in ("from", "to") if end in item)]
    must(all(abs(x) <= np.finfo(float).max for x in numbers), name, "must have numbers that a double holds", "a larger one")
    if "values" in item:
        return np.array(item["values"], dtype=float)
    first, last, count = float(item["from"]), float(item["to"]), int(item["count"])
    must(last >= first, name, "must have `to` not below `from`", last)
    must(count > 1 or first == last, name, "must have `to` equal to `from` where count is 1", last)
    if item.get("scale") == "logarithmic":
        must(first > 0, name, "must have a positive `from` where the scale is logarithmic", first)
        return np.geomspace(first, last, count)
    values = first + (last - first) * (np.arange(count) / max(count - 1, 1))
    values[-1] = last
    return values


def edges_of(r: Mapping[str, Any]) -> np.ndarray:
    """The ends of the bins of a reduction."""
    bins = r["bins"]
    must(bins["to"] > bins["from"], r["name"], "must have bins whose `to` is above their `from`", bins["to"])
    return spaced(r["name"], {**bins, "count": bins["count"] + 1})


def _quantile(item: Mapping[str, Any], u: Any) -> np.ndarray:
    """The values of a variable below which it lies with the probabilities u."""
    from scipy import stats
    name = _name_of(item)
    kind = next(kind for kind in ("uniform", "loguniform", "normal", "lognormal") if kind in item)
    x = item[kind]
    low, high = x.get("from", -math.inf), x.get("to", math.inf)
    must(high > low, name, "must have `to` above `from`", high)
    if kind == "uniform":
        return stats.uniform(low, high - low).ppf(u)
    must(kind == "normal" or low > 0 or "from" not in x, name, "must have a positive `from`", low)
    if kind == "loguniform":
        return stats.loguniform(low, high).ppf(u)
    if kind == "normal":
        mean, deviation, below, above = x["mean"], x["standard_deviation"], low, high
    else:  # the logarithm is normal
        below, above = (math.log(bound) if bound > 0 else -math.inf for bound in (low, high))
        if "median" in x:
            mean, deviation = math.log(x["median"]), x["log_standard_deviation"]
        else:
            square = 1 + (x["standard_deviation"] / x["mean"]) ** 2
            mean, deviation = math.log(x["mean"] / math.sqrt(square)), math.sqrt(math.log(square))
    drawn = stats.truncnorm((below - mean) / deviation, (above - mean) / deviation, mean, deviation).ppf(u)
    return drawn if kind == "normal" else np.clip(np.exp(drawn), low, high)


def drawn_of(samples: Mapping[str, Any]) -> Arrays:
    """What is drawn for each sample. The first samples of Sobol's sequence are those of any longer study with the same seed."""
    import warnings

    from scipy.stats import qmc
    variables, count, seed = samples["variables"], int(samples["count"]), int(samples["seed"])
    if samples["method"] == "sobol":
        engine = qmc.Sobol(len(variables), seed=seed)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", UserWarning)  # any number of samples is allowed; the docs name the best ones
            u = engine.random(count) + 2.0 ** -(engine.bits + 1)  # the middle of its cell: never 0
    else:
        u = np.clip(qmc.LatinHypercube(len(variables), seed=seed).random(count), 2.0**-53, 1 - 2.0**-53)
    return {_name_of(each): _quantile(each, u[:, n]) for n, each in enumerate(variables)}


def plan_of(study: Mapping[str, Any], grid: Any = None) -> Plan:
    """A study on its grid, after every rule of it is checked; the arguments are those of `sweep.dataset`."""
    import jsonschema
    study = plain("the study", study)
    faults = list(jsonschema.Draft202012Validator(_schema()).iter_errors(study))
    if faults:  # a word that is none tells more than what else the rules then ask for
        words = [each for each in faults if each.validator == "enum"]
        raise _refusal(words[0] if words else jsonschema.exceptions.best_match(faults))
    scene = {key: value for key, value in study["scene"].items() if key not in (*COLUMNS, "frequency")}
    system = System.from_scene(scene)
    study = {"masses": np.array([system._contact_mass]), "start": "rest", "reduce": [], "points_of_a_chunk": 10**6,
             "answers": [] if "reduce" in study else ["regime", "amplitudes"], **study, "scene": scene}
    study["masses"], study["points_of_a_chunk"] = [int(k) for k in study["masses"]], int(study["points_of_a_chunk"])
    axes, drawn = _of_study(study) if grid is None else _of_grid(grid)
    study = {key: value for key, value in study.items() if key not in ("axes", "samples", "comment")}
    order = [name for name in axes if name not in ("sample", *COLUMNS)] + [name for name in ("sample", *COLUMNS) if name in axes]
    plan = Plan(study, {name: axes[name] for name in order}, drawn, ())
    for k in study["masses"]:
        must(k <= system.N and study["masses"].count(k) == 1, "masses", f"must be different masses from 1 to {system.N}", k)
    if study.get("from_ground"):
        must("base_motion" in scene, "from_ground", "must be false where neither base nor wall moves", True)
        must(study["start"] == "rest", "start", "must be rest for absolute displacements", study["start"])
    _check_columns(plan)
    _check_reductions(plan)
    plan = Plan(study, plan.axes, drawn, _chunk_of(plan))
    _check_scenes(plan)
    return plan


def _of_study(study: Mapping[str, Any]) -> tuple[Arrays, Arrays]:
    names = [_name_of(item) for item in [*study.get("axes", []), *study.get("samples", {}).get("variables", [])]]
    for name in names:
        must(names.count(name) == 1, name, "must vary once", "given twice")
    axes, drawn = {_name_of(item): spaced(_name_of(item), item) for item in study.get("axes", [])}, {}
    if "samples" in study:
        axes["sample"] = np.arange(int(study["samples"]["count"]))
        for item in study["samples"]["variables"]:
            must(item["quantity"] not in ("contact", "load"), item["quantity"], "must be an axis", "a variable")
            System.from_scene(_scene_with(study["scene"], {_name_of(item): float(_quantile(item, 0.5))}))
        drawn = drawn_of(study["samples"])
    return axes, drawn


def _of_grid(grid: Any) -> tuple[Arrays, Arrays]:
    drawn = {str(name): _batch.numbers(str(name), values) for name, values in grid.variables.items()
             if values.dims == ("sample",) and name != "sample"}
    axes = {str(name): np.arange(size) if name == "sample" else _batch.numbers(str(name), grid[name])
            for name, size in grid.sizes.items()}
    return axes, drawn


def _check_columns(plan: Plan) -> None:
    """Every point has one frequency and one friction, each an axis or drawn; a drawn factor may come on top of an axis."""
    varied = {_target(name)[0] for name in [*plan.axes, *plan.drawn] if name != "sample"}
    wanted, others = ("frequency_hz", "friction"), ("r", "beta")
    if not varied & {*wanted}:
        wanted, others = others, wanted
    for name, other in zip(wanted, others):
        factor = name + "_factor"
        must(other not in varied, other, f"must not be given together with {' or '.join(reversed(wanted))}", "given")
        must(factor not in plan.axes, factor, f"must be drawn, as a factor of the axis {name}", "an axis")
        must((name in plan.axes) + (name in plan.drawn) == 1, name, "must be an axis or a variable that is drawn", "nothing")


def _check_reductions(plan: Plan) -> None:
    masses = plan.study["masses"]
    fields = ["stops_per_period", "periods"] + [f"{kind}_{k}" for k in masses for kind in ("amplitude", "phase")]
    taken = {"regime", "status", "regime_class", *plan.axes, *plan.drawn, *fields}
    for r in plan.study["reduce"]:
        name = r["name"]
        must(name not in taken, "reduce", "must give every reduction a name of its own", name)
        must(r["statistic"] == "share" or r["of"] in fields, name, f"must be of one of {', '.join(fields)}", r.get("of"))
        there = plan.names_of(r.get("of", ""))
        for axis in r["over"]:
            must(axis in there and r["over"].count(axis) == 1, name, f"must be over different axes of {', '.join(there)}", axis)
        if "bins" in r:
            edges_of(r)
        if r["statistic"] in ("maximum", "minimum"):
            fields.append(name)
            taken |= {f"{name}_{axis}" for axis in r["over"]}
        taken |= {name, name + "_bin", name + "_probability"}


def _chunk_of(plan: Plan) -> tuple[int, ...]:
    """The shape of a chunk: of about points_of_a_chunk points, as far as the axes allow that must not be divided."""
    whole = {"beta", "friction"} & set(plan.axes)
    for r in plan.study["reduce"]:
        if r["statistic"] == "quantiles" and "bins" not in r:
            whole |= set(r["over"])
        for before in plan.study["reduce"]:
            if before["name"] == r.get("of"):
                whole |= set(before["over"])
    chunk = {name: plan.axes[name].size for name in whole}
    points = math.prod(chunk.values())
    must(points <= MOST_POINTS_TOGETHER, "reduce", f"must not keep more than {MOST_POINTS_TOGETHER} points together (columns of "
         "friction and axes of exact quantiles are not divided; quantiles with bins are taken from a histogram)", points)
    for name, values in reversed(plan.axes.items()):
        if name not in whole:
            boxes = -(-values.size // min(max(plan.study["points_of_a_chunk"] // points, 1), values.size))
            chunk[name] = -(-values.size // boxes)
            points *= chunk[name]
    shape = tuple(chunk[name] for name in plan.axes)
    chunks = Plan(plan.study, plan.axes, plan.drawn, shape).chunks
    must(chunks <= MOST_CHUNKS, "points_of_a_chunk", f"must leave at most {MOST_CHUNKS} chunks", f"such that there are {chunks}")
    return shape


def _check_scenes(plan: Plan) -> None:
    """Every value of an axis makes a scene, with all else as the scene has it."""
    for name, values in plan.axes.items():
        if name in ("r", "frequency_hz"):
            must(bool((np.isfinite(values) & (values > 0)).all()), name, "must be positive and finite", values.min())
        elif name in ("beta", "friction"):
            must(bool((np.isfinite(values) & (values >= 0)).all()), name, "must be zero or positive, and finite", values.min())
        elif name != "sample":
            for value in values:
                System.from_scene(_scene_with(plan.study["scene"], {name: value}))
    for values in plan.drawn.values():
        must(values.shape == plan.axes["sample"].shape, "sample", "must have one value of every variable", values.shape)
    if "friction" in plan.axes or "friction" in plan.drawn:
        _forces(System.from_scene(plan.study["scene"]), np.ones(1))


# ---- the points of a chunk ---------------------------------------------------------------------------------------------------

def _scene_with(scene: Mapping[str, Any], values: Mapping[str, float]) -> dict[str, Any]:
    """A scene in which some quantities have other values; frequency and friction are no part of it."""
    changed = copy.deepcopy(dict(scene))
    for name, value in values.items():
        quantity, entry, factor = _target(name)
        if quantity in COLUMNS:
            continue
        key = next((key for key in KEYS[quantity] if key in changed), KEYS[quantity][-1])
        if quantity in ("contact", "load"):
            must(value == int(value), name, "must have whole numbers that count the masses from 1", value)
            changed[key] = int(value)
        elif quantity in ("force", "unbalance"):
            must(key in changed, name, f"must be varied in scenes that have {key}", "a scene without")
            changed[key] = value * float(changed[key]) if factor else value
        elif quantity == "mu":
            changed[key] = value * float(changed.get(key, 1)) if factor else value
        else:
            must(key in changed, name, f"must be varied in scenes that have {key}", "a scene without")
            old = changed[key]
            if not isinstance(old, list):
                old = [old] * (len(System.from_scene(scene).natural_frequency_ratios) if quantity == "zeta" else 1)
            must(not isinstance(old[0], list), name, "must be varied where the scene has a list", "a matrix")
            must(entry is None or entry <= len(old), name, f"must be one of {len(old)} entries", entry)
            changed[key] = [x if entry not in (None, n) else value * float(x) if factor else value for n, x in enumerate(old, 1)]
    return changed


def _forces(system: System, hertz: np.ndarray) -> np.ndarray:
    """The force P at each frequency, in the units of the scene."""
    scene = system.scene
    if "base_displacement" in scene:
        return np.broadcast_to(system.base_force(float(scene["base_displacement"]), hz=hertz), hertz.shape)
    if "base_acceleration" in scene:
        force = system.base_force(hz=hertz, acceleration=float(scene["base_acceleration"]))
        return np.broadcast_to(force, hertz.shape)
    if "unbalance" in scene:
        omega = 2 * np.pi * hertz
        return system.m_1 * omega * omega * (float(scene["unbalance"]) / system.m_1)
    must("force" in scene, "force", "must be given (or base_displacement in its place)", "")
    return np.full(hertz.shape, float(scene["force"]))


def _points_of(system: System, plan: Plan, f: np.ndarray, F: np.ndarray, units: bool, progress: _batch.Report) -> Arrays:
    """The fields of one system at f by F points."""
    study, masses = plan.study, np.array(plan.study["masses"], dtype=np.uintp)
    further = masses, 1, progress, study.get("effort")

    def column(r: np.ndarray, beta: np.ndarray) -> Arrays:
        if study.get("from_ground"):
            solved = _batch.solve(system._handle, {"r": r[:, None], "beta": beta}, *further, mu=system.mu, digits=0, from_ground=1)
            found = {name: getattr(solved, name) for name in ("status", "regime", "stops", "periods", "amplitude")}
        else:
            found = _batch.solve_map(system._handle, r, beta, system.mu, study["start"] == "sliding", *further)
        found["stops_per_period"] = found.pop("stops")
        over_masses = {"amplitude": found.pop("amplitude")}
        if needs_phases(study) and study.get("from_ground"):
            over_masses["phase"] = solved.phase
        elif needs_phases(study):
            phase = _batch.solve(system._handle, {"r": r[:, None], "beta": beta}, *further, mu=system.mu, digits=0).phase
            over_masses["phase"] = np.where((found["regime"] >= 0)[..., None], phase, np.nan)
        return found | {f"{kind}_{k}": values[..., n] for kind, values in over_masses.items() for n, k in enumerate(masses)}

    force, unit, r = np.ones(f.size), np.ones(f.size), f
    if units:
        force, r = _forces(system, f), np.asarray(system.frequency_ratio(hz=f))
        unit = force / system.k_1
    parts = [slice(0, f.size)] if np.all(force == force[0]) else [slice(n, n + 1) for n in range(f.size)]
    columns = [column(r[part], F / force[part][0]) for part in parts]
    found = {name: np.concatenate([each[name] for each in columns]) for name in columns[0]}
    return {name: values * unit[:, None] if name.startswith("amplitude") else values for name, values in found.items()}


def needs_phases(study: Mapping[str, Any]) -> bool:
    """Whether anything needs phases."""
    return "phases" in study["answers"] or any(r.get("of", "").startswith("phase_") for r in study["reduce"])


def fields_of(plan: Plan, K: int, progress: _batch.Report = None) -> Arrays:
    """What `map` finds at every point of chunk K, and the phases of `solve` where they are needed: a name for each field."""
    part = plan.slices(K)
    axes = {name: values[part[name]] for name, values in plan.axes.items()}
    units = "friction" in {*plan.axes, *plan.drawn}
    frequency, friction = ("frequency_hz", "friction") if units else ("r", "beta")
    outer = [name for name in axes if name not in (frequency, friction)]
    shape = tuple(axes[name].size for name in outer)
    inner = tuple(axes[name].size if name in axes else 1 for name in (frequency, friction))
    none = {"status": NO_SCENE} | {name: -1 for name in KINDS if name != "status"} | {
        f"{kind}_{k}": np.nan for kind in ["amplitude", *["phase"] * needs_phases(plan.study)] for k in plan.study["masses"]}
    out = {name: np.full(shape + inner, value, KINDS.get(name, np.float64)) for name, value in none.items()}
    for place in np.ndindex(*shape):
        at = {name: float(axes[name][n]) for name, n in zip(outer, place)}
        sample = int(at.pop("sample", 0))
        at |= {name: float(values[sample]) for name, values in plan.drawn.items()}
        f, F = (axes.get(name, np.array([at.get(name)])) * at.get(name + "_factor", 1.0) for name in (frequency, friction))
        try:
            found = _points_of(System.from_scene(_scene_with(plan.study["scene"], at)), plan, f, F, units, progress)
        except InputError:  # the numbers of the sample make no scene: those of the axes were tried before
            continue
        for name, values in found.items():
            out[name][place] = values
    return {name: values.reshape([each.size for each in axes.values()]) for name, values in out.items()}


# ---- statistics --------------------------------------------------------------------------------------------------------------

def reduced(plan: Plan, r: Mapping[str, Any], K: int, x: np.ndarray) -> Arrays:
    """What chunk K has of a reduction, in which its reduced axes have one place: counts, quantiles, or what `extreme` gives."""
    names, over, sizes = plan.axes_of(r)
    if r["statistic"] == "share":
        return {"counts": np.stack([(x == regime).sum(over, keepdims=True) for regime in (0, 1, 2, -1)], -1)}
    x = np.where(x < 0, np.nan, x) if r["of"] in ("stops_per_period", "periods") else x
    if r["statistic"] in ("maximum", "minimum"):
        part = plan.slices(K)
        places = np.ix_(*(np.arange(part[name].start, part[name].stop) for name in names))
        value = np.where(np.isnan(x), -np.inf if r["statistic"] == "maximum" else np.inf, x)
        return extreme(r, {"value": value, "place": np.ravel_multi_index([places[n] for n in over], sizes)}, over)
    x = np.moveaxis(x, over, range(-len(over), 0))
    x = x.reshape(x.shape[:-len(over)] + (-1,))
    if "bins" in r:
        edges = edges_of(r)
        bins = np.searchsorted(edges, x, "right")
        bins[x == edges[-1]] = edges.size - 1  # the last bin has its upper end
        cells = np.arange(bins[..., 0].size).reshape(x.shape[:-1] + (1,)) * (edges.size + 1)
        counts = np.bincount((cells + bins)[~np.isnan(x)], minlength=bins[..., 0].size * (edges.size + 1))
        return {"counts": np.expand_dims(counts.reshape(x.shape[:-1] + (edges.size + 1,)), over)}
    value = np.full(x.shape[:-1] + (len(r["probabilities"]),), np.nan)
    some = ~np.isnan(x).all(-1)
    value[some] = np.moveaxis(np.nanquantile(x[some], r["probabilities"], axis=-1), 0, -1)
    return {"value": np.expand_dims(value, over)}


def extreme(r: Mapping[str, Any], parts: Mapping[str, Any], over: tuple[int, ...]) -> dict[str, Any]:
    """The largest or smallest value over some axes, infinite if there is none, and of several places the first."""
    value = (np.max if r["statistic"] == "maximum" else np.min)(parts["value"], axis=over, keepdims=True)
    place = np.where(parts["value"] == value, parts["place"], np.iinfo(np.int64).max)
    return {"value": value, "place": place.min(axis=over, keepdims=True)}


def finished(plan: Plan, r: Mapping[str, Any], parts: Mapping[str, Any]) -> dict[str, Any]:
    """The results of a reduction by their names, from what all chunks have of it; both are arrays of Dask."""
    names, over, sizes = plan.axes_of(r)
    if "counts" in parts:
        result = parts["counts"].sum(over)
        if r["statistic"] == "share":
            result = result / result.sum(-1, keepdims=True)
        elif r["statistic"] == "quantiles":
            result = result.map_blocks(_quantiles_of_counts, edges=edges_of(r), probabilities=r["probabilities"], dtype=float,
                                       chunks=(*result.chunks[:-1], (len(r["probabilities"]),)))
        return {r["name"]: result}
    if r["statistic"] == "quantiles":
        return {r["name"]: parts["value"].squeeze(over)}
    value, place = (array.squeeze(over) for array in extreme(r, parts, over).values())
    out = {r["name"]: value}
    for n, axis in enumerate(over):
        index = place // math.prod(sizes[n + 1:]) % sizes[n]
        out[f"{r['name']}_{names[axis]}"] = index.map_blocks(functools.partial(np.take, plan.axes[names[axis]]), dtype=float)
    return {name: np.where(np.isinf(value), np.nan, array) for name, array in out.items()}


def _quantiles_of_counts(counts: np.ndarray, edges: np.ndarray, probabilities: list[float]) -> np.ndarray:
    """Quantiles from a histogram, linear within a bin; NaN where they lie outside of the bins, or nothing was counted."""
    rows = counts.reshape(-1, counts.shape[-1])
    out = np.full((len(rows), len(probabilities)), np.nan)
    for cell, row in enumerate(rows):
        below, wanted = np.cumsum(row)[:-1], np.multiply(probabilities, row.sum())  # below: how many lie below each end of a bin
        upper = np.maximum(np.searchsorted(below, wanted), np.searchsorted(below, below[0], "right"))  # the end of its bin
        within = (wanted >= below[0]) & (upper < edges.size)
        n = upper[within]
        part = (wanted[within] - below[n - 1]) / (below[n] - below[n - 1])
        out[cell, within] = edges[n - 1] + part * (edges[n] - edges[n - 1])
    return out.reshape(counts.shape[:-1] + (len(probabilities),))


def answers_of(study: Mapping[str, Any]) -> list[str]:
    """The fields that are stored for every point."""
    masses = study["masses"]
    fields = {"regime": ["regime"], "stops": ["stops_per_period", "periods"], "amplitudes": [f"amplitude_{k}" for k in masses],
              "phases": [f"phase_{k}" for k in masses]}
    asked = [field for answer, names in fields.items() if answer in study["answers"] for field in names]
    return ["status", *asked] if asked else []


def computed(plan: Plan, K: int, progress: _batch.Report = None) -> Arrays:
    """Chunk K: the answers at its points, and its part of every reduction as `NAME:counts`, `NAME:value` and `NAME:place`."""
    fields = fields_of(plan, K, progress)
    out = {name: fields[name] for name in answers_of(plan.study)}
    for r in plan.study["reduce"]:
        part = reduced(plan, r, K, fields[r.get("of", "regime")])
        if "place" in part:  # a reduction of it finds its axes in one chunk
            fields[r["name"]] = np.where(np.isinf(part["value"]), np.nan, part["value"]).squeeze(plan.axes_of(r)[1])
        out |= {f"{r['name']}:{kind}": values for kind, values in part.items()}
    return out
