"""The steady motions of many systems in one call."""
from __future__ import annotations

from typing import Any, Callable, Optional, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _batch
from ._errors import InputError
from ._results import Solutions
from ._system import System


def _objects(systems: Any) -> np.ndarray:
    """An array of systems of the shape given, or an InputError that tells what else is among them."""
    if isinstance(systems, System):
        systems = np.array(systems, dtype=object)
    elif not isinstance(systems, np.ndarray):
        systems = list(systems)
        array = np.empty(len(systems), dtype=object)
        array[:] = systems
        systems = array
    for each in systems.flat:
        if not isinstance(each, System):
            raise InputError.of("systems", "must be a System or a list of them", repr(each))
    return systems


def solve_many(systems: Union[System, Sequence[System], np.ndarray], r: ArrayLike, beta: ArrayLike,
               digits: Optional[int] = None, mu: Optional[ArrayLike] = None, masses: Union[int, Sequence[int], None] = None,
               threads: int = 0, progress: Optional[Callable[[int, int], Any]] = None) -> Solutions:
    """The steady motions of many systems, each at a point of its own: what `System.solve` has for one.

    Parameters
    ----------
    systems : sequence of System, or ndarray of them
        Systems of any number of masses. One may be there more than once. It is broadcast with `r`, `beta` and `mu`.
    r : float or array_like
        Frequency ratio, Eq. (10), positive.
    beta : float or array_like
        Friction ratio, Eq. (11), not negative.
    digits : int, from 1 to 15
        Significant digits that must be reached; without it 6 are aimed at.
    mu : float or array_like
        Static over kinetic friction in place of that of each system.
    masses : int or sequence of ints
        Masses that are wanted, from 1, which every system must have; default all.
    threads : int
        0 for as many as the machine has. The numbers are the same for any.
    progress : callable
        Called as ``progress(done, all)``; the computation ends where it returns something true.

    Returns
    -------
    Solutions
        With arrays of the broadcast shape, those over masses with the masses last: as many as the largest system has, with NaN
        for a mass that a system does not have.

    Raises
    ------
    InputError
        Where a value breaks a rule; the message names quantity, rule and value.
    Cancelled
        Where `progress` ended it.

    Examples
    --------
    >>> pair = [System(mass_ratios=[1, 1], stiffness_ratios=[1, 1], damping_ratios=zeta, contact=2, load=1) for zeta in (0.05, 0.1)]
    >>> solve_many(pair, r=0.8, beta=0.2).amplitude.shape
    (2, 2)
    """
    array = _objects(systems)
    flat = list(array.flat)
    if digits is not None and not 1 <= int(digits) <= 15:
        raise InputError.of("digits", "must be from 1 to 15", digits)
    addresses = np.array([each._handle.address.value for each in flat], dtype=np.uintp).reshape(array.shape)
    static = np.array([each.mu for each in flat]).reshape(array.shape) if mu is None else _batch.numbers("mu", mu)
    counts = [each.N for each in flat]
    least, most = min(counts, default=0), max(counts, default=0)
    listed = None if masses is None else _batch.mass_list(masses, least)
    r_array, beta_array = _batch.numbers("r", r), _batch.numbers("beta", beta)
    found = _batch.solve_systems(addresses, r_array, beta_array, static, 0 if digits is None else int(digits), listed, most,
                                 _batch.thread_count(threads), progress)
    full = [np.broadcast_to(each, found["regime"].shape).copy() for each in (r_array, beta_array, static)]
    return Solutions(r=full[0], beta=full[1], mu=full[2],
                     masses=np.arange(1, most + 1) if listed is None else listed.astype(int),
                     amplitude_error=found.pop("error"), **found)
