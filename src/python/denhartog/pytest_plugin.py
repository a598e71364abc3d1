"""A pytest plugin: each certified question is a test of a function of yours.

    pytest --denhartog-function=module:function [--denhartog-group=GROUPS] [--denhartog-filter=REGEX] [--denhartog-tier=TIERS]

The function is called as `denhartog.conformance.run` calls it. What it skips is skipped here.
"""
from __future__ import annotations

import importlib
from typing import Any

import pytest

GOOD = ("pass", "pass-loose", "rejected")


def pytest_addoption(parser: pytest.Parser) -> None:
    group = parser.getgroup("denhartog", "certified questions on friction-damped vibration")
    group.addoption("--denhartog-function", metavar="MODULE:FUNCTION",
                    help="the function that answers; without it nothing is asked")
    group.addoption("--denhartog-group", metavar="GROUPS",
                    help="groups of questions, separated by commas; default all about scenes of the paper")
    group.addoption("--denhartog-filter", metavar="REGEX", help="regular expression that must match a part of the id")
    group.addoption("--denhartog-tier", metavar="TIERS", help="must, should, stress, separated by commas; default must")


class Grading:
    """The answers to all questions that are left after pytest's own selection, judged at once."""

    def __init__(self, vectors: Any, function: Any) -> None:
        self.vectors, self.function, self.report = vectors, function, None

    def result(self, session: pytest.Session, id_: str) -> Any:
        if self.report is None:
            from .conformance import answer
            raised: dict[str, BaseException] = {}
            questions = [item.question for item in session.items if isinstance(item, Asked)]
            self.report = self.vectors.grade([answer(self.function, question, raised) for question in questions], raised)
        return self.report.results[id_], self.report.raised.get(id_)


class Asked(pytest.Item):
    """One certified question."""

    def __init__(self, *, question: dict[str, Any], grading: Grading, **rest: Any) -> None:
        super().__init__(**rest)
        self.question, self.grading = question, grading

    def runtest(self) -> None:
        result, reason = self.grading.result(self.session, self.question["id"])
        if reason is not None:
            raise reason
        if result["verdict"] == "skipped":
            pytest.skip(result.get("reason", "skipped"))
        if result["verdict"] not in GOOD:
            told = [f"{name}: {result[name]}" for name in ("reason", "answer", "truth", "error", "equation") if name in result]
            head, scene = f"{result['verdict']}, {result['quantity']}", f"scene: {self.question['scene']}"
            pytest.fail("\n".join([head, *told, scene]), pytrace=False)

    def reportinfo(self) -> tuple[Any, None, str]:
        return self.path, None, f"{self.question['id']} {self.question['quantity']}"


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(session: pytest.Session, config: pytest.Config, items: list[pytest.Item]) -> None:
    named = config.getoption("--denhartog-function")
    if not named:
        return
    from . import Error
    from .conformance import Vectors
    module, _, name = named.partition(":")
    try:
        function = getattr(importlib.import_module(module), name)
        vectors = Vectors(filter=config.getoption("--denhartog-filter"), group=config.getoption("--denhartog-group"),
                          tier=config.getoption("--denhartog-tier") or "must")
        questions = vectors.questions()
    except (AttributeError, ImportError, ValueError, Error) as reason:
        raise pytest.UsageError(f"--denhartog-function={named}: {reason}") from reason
    grading = Grading(vectors, function)
    items += [Asked.from_parent(session, name=q["id"], question=q, grading=grading) for q in questions]
