"""Exceptions in place of the statuses of the C interface."""
from __future__ import annotations

import re
from decimal import Decimal
from numbers import Real
from operator import index

_PARTS = re.compile(r"(?:(.*), but is )?(.*?)(?: \(at ([^()]*)\))?", re.S)  # QUANTITY RULE, but is VALUE (at PLACE)


class Error(Exception):
    """Base of all exceptions of this package."""


class InputError(Error, ValueError):
    """A number or a text breaks a rule.

    Attributes
    ----------
    quantity : str
        What breaks the rule, e.g. ``"beta"`` or ``"masses"``.
    rule : str
        The rule, e.g. ``"must be zero or positive, and finite"``.
    value : str or None
        The value that breaks it, as text; None where the message gives none.
    place : str or None
        Where the value stands in the scene, as a JSON pointer such as ``/masses/1`` (counted from 0), or by line and column;
        None where the message gives none.
    """

    def __init__(self, message: str) -> None:
        super().__init__(message)
        rest, value, self.place = _PARTS.fullmatch(message).groups()
        rest, self.value = (value, None) if rest is None else (rest, value)
        words = re.match(r"((?:the|a|an) .*?|\S+) (.*)", rest, re.S)  # "the selection must ...": the verb ends the quantity
        if words and words[1].startswith(("the ", "a ", "an ")):
            words = re.match(r"(.*?) ((?:must|is|cannot) .*)", rest, re.S) or words
        self.quantity, self.rule = words.groups() if words else ("", rest)

    @classmethod
    def of(cls, quantity: str, rule: str, value: object) -> "InputError":
        """An error with the message that the library would write."""
        return cls(f"{quantity} {rule}" + (f", but is {value}" if value != "" else ""))


def whole(quantity: str, value: object, least: int, most: int, meaning: str = "") -> int:
    """A whole number from `least`, whose `meaning` the error tells, to `most`; a boolean is none."""
    try:
        number = int(value) if isinstance(value, (Real, Decimal)) else index(value)
        if not isinstance(value, bool) and number == value and least <= number <= most:
            return number
    except (TypeError, ValueError, OverflowError):
        pass
    raise InputError.of(quantity, f"must be a whole number from {least}{meaning} to {most}", repr(value))


class DomainError(Error):
    """A formula was asked for where it does not hold, e.g. at the resonance of a mode without damping."""


class PrecisionError(Error):
    """The digits asked for were not reached, the work allowed is spent, or a result is beyond the range of a double."""


class Cancelled(Error):
    """The function given as ``progress`` ended the computation. There is no result."""
