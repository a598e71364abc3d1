"""A pytest plugin: each certified question is a test of a function of yours.

    pytest --denhartog-function=module:function [--denhartog-group=GROUPS] [--denhartog-filter=REGEX] [--denhartog-tier=TIERS]

From a source tree, with src/python in PYTHONPATH, `-p denhartog.pytest_plugin` makes it known. The function is called as
`denhartog.conformance.run` calls it. What it skips is skipped here. The summary ends with the diagnosis of the wrong answers.
"""
from __future__ import annotations

import functools
import importlib
from typing import Any, Callable

import pytest

GOOD = ("pass", "pass-loose", "rejected")
REPORT = pytest.StashKey[Any]()


def pytest_addoption(parser: pytest.Parser) -> None:
    group = parser.getgroup("denhartog", "certified questions on friction-damped vibration")
    group.addoption("--denhartog-function", metavar="MODULE:FUNCTION",
                    help="the function that answers; without it nothing is asked")
    group.addoption("--denhartog-group", metavar="GROUPS",
                    help="groups of questions, separated by commas; default all about scenes of the paper")
    group.addoption("--denhartog-filter", metavar="REGEX", help="regular expression that must match a part of the id")
    group.addoption("--denhartog-tier", metavar="TIERS", help="must, should, stress, separated by commas; default must")


class Asked(pytest.Item):
    """One certified question."""

    def __init__(self, *, question: dict[str, Any], report: Callable[[], Any], **rest: Any) -> None:
        super().__init__(**rest)
        self.question, self.report = question, report

    def runtest(self) -> None:
        result, raised = self.report().results[self.question["id"]], self.report().raised
        if self.question["id"] in raised:
            raise raised[self.question["id"]]
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

    @functools.lru_cache(maxsize=None)
    def report() -> Any:
        """The answers to all questions that are left after pytest's own selection, judged at once."""
        config.stash[REPORT] = vectors.ask(function, [item.question for item in session.items if isinstance(item, Asked)])
        return config.stash[REPORT]

    items += [Asked.from_parent(session, name=q["id"], question=q, report=report) for q in questions]


def pytest_terminal_summary(terminalreporter: Any, config: pytest.Config) -> None:
    """What the report says about wrong answers as a whole: from the diagnosis on."""
    report = config.stash.get(REPORT, None)
    _, start, told = report.text.partition("\nDiagnosis (") if report is not None else ("", "", "")
    if start:
        terminalreporter.section("denhartog")
        terminalreporter.write_line((start + told).strip())
