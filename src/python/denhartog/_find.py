"""The inverse question: what a number of a scene has to be so that an amplitude is as wanted."""
from __future__ import annotations

import json
from ctypes import byref, c_char_p, cast, c_void_p
from typing import Any, Mapping, NamedTuple, Sequence, Union

import numpy as np

from . import _batch, _library
from ._errors import InputError, whole
from ._system import plain

_KINDS = ("crossing", "jump", "undecided", "extreme", "end of the interval")


class Place(NamedTuple):
    """A place that was found.

    Attributes
    ----------
    is_ : str
        'crossing', 'jump', 'undecided', 'extreme' or 'end of the interval', as `denhartog find --help` explains them.
    at : float
        Where it most likely is.
    between : tuple of two floats
        The interval that holds it: of a crossing, the amplitude certainly is on different sides of the value at its ends.
    amplitude, error_bound : float
        The amplitude there and the bound of its error, in the scene's unit of length, or in units of P / k_1.
    """

    is_: str
    at: float
    between: tuple[float, float]
    amplitude: float
    error_bound: float


class Found(NamedTuple):
    """What was found.

    Attributes
    ----------
    places : list of Place
        Ascending. What lies between two samples and shows at neither is not found.
    unanswered : int
        At how many values of the number no steady motion was certain.
    """

    places: list[Place]
    unanswered: int


def find(scene: Union[str, Mapping[str, Any]], vary: str, between: Sequence[float], so_that: str, samples: int = 128) -> Found:
    """What a number of a scene has to be so that an amplitude is as wanted.

    Parameters
    ----------
    scene : mapping or str
        The scene, as in the JSON of `denhartog solve`, or its text; with `r` and `beta`, or frequency, force and friction.
    vary : str
        The key of the number that varies, such as ``"friction"``; of a list with the place, ``"damping_ratios/2"``.
    between : two floats
        Its interval.
    so_that : str
        ``"amplitude of mass 2 = 0.075"``, ``"amplitude of mass 2 is least"``, or
        ``"largest amplitude of mass 2 over frequency_hz 1:10 is least"``.
    samples : int
        Parts into which the interval is divided at first.

    >>> scene = {"mass_ratios": 1, "stiffness_ratios": 1, "damping_ratios": 0.05, "contact": 1, "load": 1, "r": 0.5, "beta": 0}
    >>> [place] = find(scene, "beta", (0, 0.9), "amplitude of mass 1 = 1").places
    >>> place.is_
    'crossing'
    """
    text = (scene if isinstance(scene, str) else json.dumps(plain("scene", scene))).encode()
    ends = _batch.numbers("between", between).tolist()
    if np.shape(ends) != (2,):
        raise InputError.of("between", "must be two numbers", between)
    samples = whole("samples", samples, 2, 100_000)
    room = 4 * samples + 64
    numbers, kinds = np.empty((5, room)), np.empty(room, dtype=np.intc)
    words = [c_char_p(text), c_char_p(vary.encode()), c_char_p(so_that.encode())]
    pointers = [cast(word, c_void_p) for word in words]
    request = _library.FindRequest(scene=pointers[0], scene_length=len(text), vary=pointers[1], from_=ends[0], to=ends[1],
                                   so_that=pointers[2], samples=samples)
    arrays = {name: row.ctypes.data for name, row in zip(("at", "from_", "to", "amplitude", "error"), numbers)}
    places = _library.Places(room=room, is_=kinds.ctypes.data, **arrays)
    _library.call("dh_find", byref(request), byref(places))
    found = [Place(_KINDS[kinds[n]], at, (low, high), amplitude, error)
             for n, (at, low, high, amplitude, error) in enumerate(numbers[:, :places.count].T.tolist())]
    return Found(found, int(places.unanswered))
