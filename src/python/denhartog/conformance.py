"""Grades a function of yours against the certified vectors, by the command line program ``denhartog conform``.

The function answers a question, a dict as the page docs/protocol.md has it, with keys ``id``, ``quantity``, ``scene`` and, where
the quantity needs them, ``mass``, ``tau`` and ``samples``:

* it returns a number, a sequence of numbers, or the name of a regime; a complex number counts as its two parts;
* it returns None, or raises NotImplementedError, for what it does not compute;
* it raises ValueError (InputError is one) where the question breaks a rule, such as a negative mass.

Any other exception counts as a wrong answer and stands in the report under `raised`.

>>> from denhartog import conformance
>>> report = conformance.run(my_function, group="boundary")  # doctest: +SKIP
>>> print(report)                                            # doctest: +SKIP
"""
from __future__ import annotations

import json
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
from dataclasses import dataclass, field
from typing import Any, Callable, Iterable, Mapping, Optional, Sequence, Union

import numpy as np

from ._errors import Error, InputError

Question = dict[str, Any]
Function = Callable[[Question], Any]
_ASKED = ("id", "quantity", "scene", "mass", "tau", "samples")


@dataclass(frozen=True, repr=False)
class Report:
    """What became of the answers.

    Attributes
    ----------
    conforms : bool
        Whether every answer of the tier ``must`` is right.
    counts : dict
        Number of answers by verdict, such as ``{"pass": 380, "wrong": 0, ...}``.
    scores : list of dicts
        The same for each tier and group, with the median and the worst number of digits.
    diagnosis : dict
        Which known mistakes explain the wrong answers.
    results : dict
        By id of the question: verdict, answer, truth, error. The page docs/conformance-output.md has the members.
    raised : dict
        By id of the question: the exception that the function raised.
    text : str
        The report in words, which is also ``str(report)``.
    """

    conforms: bool
    counts: dict[str, int]
    scores: list[dict[str, Any]]
    diagnosis: dict[str, Any]
    results: dict[str, dict[str, Any]]
    raised: dict[str, BaseException] = field(default_factory=dict)
    text: str = ""

    def __str__(self) -> str:
        told = [f"{id_}: the function raised {reason!r}" for id_, reason in list(self.raised.items())[:10]]
        more = [f"and {len(self.raised) - 10} more"] if len(self.raised) > 10 else []
        return "\n".join([self.text.rstrip(), *([""] if told else []), *told, *more])

    def __repr__(self) -> str:
        counts = ", ".join(f"{number} {verdict}" for verdict, number in self.counts.items() if number)
        return f"<{'conforms' if self.conforms else 'does not conform'}: {counts}>"


class Vectors:
    """The certified vectors and the program that judges answers to them.

    Parameters
    ----------
    program : path
        The command line program; default what the environment variable DENHARTOG_PROGRAM names, or `denhartog` of the PATH.
    vectors : path
        Folder of the vectors; default the one that the program was built with.
    filter : str
        Regular expression that the ids have to match somewhere.
    group, tier : str or sequence of str
        Groups, such as ``boundary``, and tiers: ``must``, ``should``, ``stress``; default all that are about scenes of the paper.
    systems : bool
        Whether to ask about systems beyond the paper as well; the group ``systems`` stands for these alone.
    method : str
        By which the function answers; it decides the tolerances. ``denhartog conform list --methods`` has them.
    """

    def __init__(self, program: Union[str, "os.PathLike[str]", None] = None, *,
                 vectors: Union[str, "os.PathLike[str]", None] = None, filter: Optional[str] = None,
                 group: Union[str, Sequence[str], None] = None, tier: Union[str, Sequence[str], None] = None,
                 systems: bool = False, method: str = "closed-form") -> None:
        named = str(program or os.environ.get("DENHARTOG_PROGRAM") or "denhartog")
        found = shutil.which(named)
        if found is None:
            raise Error(f"the program that has the certified vectors is not found: {named}. Build denhartog from its sources and "
                        "give the path of bin/denhartog as program, or in the environment variable DENHARTOG_PROGRAM")
        self.program = found
        self.folder = pathlib.Path(vectors) if vectors is not None else self._folder_of_program()
        if not any(self.folder.glob("*.jsonl")):
            raise InputError(f"vectors must be a folder with files *.jsonl (in a clone tests/conformance/vectors), but is "
                             f"{self.folder}")
        self._selection = ["--vectors", str(self.folder), *(["--systems"] if systems else [])]
        for option, value in (("--filter", filter), ("--group", group), ("--tier", tier)):
            if value is not None:
                self._selection += [option, value if isinstance(value, str) else ",".join(value)]
        self._method = ["--method", method]

    def questions(self) -> list[Question]:
        """The questions of the selection, in the order of the vectors."""
        listed = self._run(["list", *self._selection]).splitlines()[1:]
        lines = [line for path in self.folder.glob("*.jsonl") for line in path.read_text(encoding="utf-8").splitlines()]
        vectors = {vector["id"]: vector for vector in map(json.loads, lines)}
        found = [vectors[line.split()[0]] for line in listed if line.strip()]
        return [{name: vector[name] for name in _ASKED if name in vector} for vector in found]

    def grade(self, answers: Iterable[Mapping[str, Any]], raised: Optional[dict[str, BaseException]] = None) -> Report:
        """Judges answers: dicts with ``id`` and ``value``, ``skip`` or ``reject``; what is missing counts as skipped."""
        with tempfile.TemporaryDirectory(prefix="denhartog-") as folder:
            path = pathlib.Path(folder, "answers.jsonl")
            path.write_text("".join(json.dumps(answer) + "\n" for answer in answers), encoding="utf-8")
            grade = ["grade", *self._selection, *self._method, str(path)]
            found = json.loads(self._run([*grade, "--format", "json"]))
            text = self._run(grade).replace(str(path), "answers")
        return Report(found["conforms"], found["counts"], found["scores"], found["diagnosis"],
                      {result["id"]: result for result in found["results"]}, raised or {}, text)

    def ask(self, function: Function, questions: Iterable[Question]) -> Report:
        """Asks a function questions of the selection, and judges its answers."""
        raised: dict[str, BaseException] = {}
        return self.grade([answer(function, question, raised) for question in questions], raised)

    def _run(self, arguments: list[str]) -> str:
        done = subprocess.run([self.program, "conform", *arguments], capture_output=True, text=True, check=False)
        if done.returncode not in (0, 1):  # 1: the answers do not conform
            message = done.stderr.strip().removeprefix("denhartog: ")
            raise InputError(message) if done.returncode == 2 else Error(f"{self.program} conform: {message}")
        return done.stdout

    def _folder_of_program(self) -> pathlib.Path:
        told = re.search(r"--vectors TEXT=(.*)", self._run(["list", "--help"]))
        if told is None:
            raise Error(f"{self.program} does not tell where its vectors are: give their folder as vectors")
        return pathlib.Path(told[1].strip())


def answer(function: Function, question: Question, raised: dict[str, BaseException]) -> dict[str, Any]:
    """The answer of a function to a question, as the protocol has it; an exception is added to `raised`."""
    id_ = question["id"]
    try:
        value = function(question)
        if value is None:
            return {"id": id_, "skip": "None was returned"}
        if isinstance(value, str):
            return {"id": id_, "value": value}
        if isinstance(value, (complex, np.complexfloating)):
            value = [value.real, value.imag]
        listed = np.atleast_1d(np.asarray(value, dtype=float)).ravel()
        return {"id": id_, "value": [x if np.isfinite(x) else str(x) for x in listed.tolist()]}
    except NotImplementedError as reason:
        return {"id": id_, "skip": str(reason) or "NotImplementedError was raised"}
    except ValueError as reason:
        return {"id": id_, "reject": str(reason) or "ValueError was raised"}
    except Exception as reason:  # a fault of the function: the other questions go on
        raised[id_] = reason
        return {"id": id_, "value": f"raised {type(reason).__name__}"}


def run(function: Function, program: Union[str, "os.PathLike[str]", None] = None, filter: Optional[str] = None,
        **selection: Any) -> Report:
    """Asks a function the questions of the vectors, in this process, and judges its answers.

    Parameters
    ----------
    function : callable
        ``function(question: dict)`` returns the value; see the head of this module.
    program, filter, **selection
        As of `Vectors`: also `vectors`, `group`, `tier`, `systems`, `method`.

    Returns
    -------
    Report
        Raises `Error` where the program or the vectors are not found.
    """
    vectors = Vectors(program, filter=filter, **selection)
    return vectors.ask(function, vectors.questions())
