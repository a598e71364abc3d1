"""Long calls of the library, which progress and Ctrl-C can end, and the arrays that they fill."""
from __future__ import annotations

import threading
from ctypes import byref, c_void_p
from typing import Any, Callable, Iterator, Optional, Union

import numpy as np

from . import _library
from ._errors import Cancelled, InputError, whole
from ._results import Real, Solutions

Report = Optional[Callable[[int, int], Any]]
Arrays = dict[str, np.ndarray]


def run(name: str, handles: tuple[c_void_p, ...], request: Any, result: Any, progress: Report, arrays: Any,
        effort: Optional[float] = None) -> None:
    """Calls dh_map(), dh_solve_points() or dh_solve_systems() in a thread of its own and waits for it.

    A thread in C does not see Ctrl-C. The thread that waits here does, and so does `progress(done, all)`, which it calls. The
    `arrays`, to which request and result point, are kept until the library is done, even where a second Ctrl-C ends the waiting.
    """
    news, stop, ended = threading.Event(), threading.Event(), threading.Event()
    told, kept, faults = (0, 0), [arrays], []

    def tell(done: int, everything: int, _: Any) -> int:
        nonlocal told
        told = done, everything
        news.set()
        return stop.is_set()

    def work() -> None:
        try:
            if effort is not None:
                _library.call("dh_set_effort", effort, None, None)  # of this thread alone, which ends with the call
            _library.call(name, *handles, byref(request), byref(result))
        except BaseException as reason:  # it must not be lost with this thread
            faults.append(reason)
        finally:
            kept.clear()
            ended.set()
            news.set()

    request.progress = _library.Progress(tell)
    worker = threading.Thread(target=work, name="denhartog")
    worker.start()
    reported, last = 0, False
    try:
        while not last:
            news.wait()
            news.clear()
            last, (done, everything) = ended.is_set(), told
            if progress is not None and done > reported:
                reported = done
                if progress(done, everything) and not last:
                    stop.set()
    except BaseException:
        stop.set()
        raise
    finally:
        worker.join()
    if faults and stop.is_set():
        raise Cancelled(f"the function given as progress ended the computation after {told[0]} of {told[1]}")
    if faults:
        raise faults[0]


def _entries(values: Any) -> Iterator[Any]:
    """What nested lists consist of: an array of them all would turn booleans into numbers and lose masks."""
    if isinstance(values, (list, tuple)):
        for each in values:
            yield from _entries(each)
    else:
        yield values


def numbers(name: str, values: Any) -> np.ndarray:
    """An array of doubles, or an InputError that names the argument: complex numbers, dates, texts and booleans are none."""
    entries = list(_entries(values))
    masked = sum(int(np.ma.count_masked(each)) for each in entries if isinstance(each, np.ma.MaskedArray))
    if masked > 0:
        raise InputError.of(name, "must have no masked entries", f"an array with {masked} of them")
    has_booleans = any(isinstance(each, bool) or getattr(each, "dtype", None) == np.bool_ for each in entries)
    no_numbers, reason = (str, bytes, bool, np.bool_, type(None)), None
    try:
        array = np.asarray(values)
        if not has_booleans and (array.dtype.kind in "fiu" or array.dtype == object and not any(
                isinstance(each, no_numbers) for each in array.flat)):
            return array.astype(np.float64, copy=False)
    except (TypeError, ValueError) as fault:
        reason = fault
    raise InputError.of(name, "must be a number or an array of numbers", repr(values)) from reason


def number(name: str, value: Any) -> float:
    """A single number."""
    array = numbers(name, value)
    if array.size != 1:
        raise InputError.of(name, "must be a single number", f"an array of shape {array.shape}")
    return array.item()


def like(array: Any) -> Real:
    """A number for an array without dimensions."""
    array = np.asarray(array)
    return float(array) if array.ndim == 0 else array


def mass_list(masses: Any, N: int) -> np.ndarray:
    """The masses asked for, counted from 1, as the library takes them; all for None."""
    if masses is None:
        return np.arange(1, N + 1, dtype=np.uintp)
    listed = np.atleast_1d(np.asarray(masses))
    if listed.ndim != 1 or listed.size == 0 or not np.issubdtype(listed.dtype, np.integer):
        raise InputError.of("masses", "must be a mass or a list of masses, whole numbers counted from 1", repr(masses))
    for k in listed:
        if not 1 <= k <= N:
            raise InputError.of("masses", f"must be masses from 1 to {N}", k)
    return np.ascontiguousarray(listed, dtype=np.uintp)


def thread_count(threads: int) -> int:
    """The number of threads, checked; 0 for as many as the machine has."""
    return whole("threads", threads, 0, 65536, ", which is as many as the machine has,")


def digit_count(digits: Optional[int]) -> int:
    """The significant digits, checked; 0 where none are asked for."""
    return 0 if digits is None else whole("digits", digits, 1, 15)


def shape_of(**arrays: np.ndarray) -> tuple[int, ...]:
    """The shape that arrays are broadcast to, the first of them leading."""
    shape: tuple[int, ...] = ()
    for name, array in arrays.items():
        try:
            shape = np.broadcast_shapes(shape, array.shape)
        except ValueError as reason:
            raise InputError.of(name, f"must have a shape that goes with that of the arguments before it, {shape}",
                                array.shape) from reason
    return shape


def _room(shape: tuple[int, ...], masses: int, over_masses: tuple[str, ...]) -> tuple[Arrays, dict[str, int]]:
    """Arrays for what is found at points, the masses last, and where each begins."""
    kinds = {"status": np.int8, "regime": np.int8, "stops": np.intc, "periods": np.intc}
    out = {name: np.empty(shape, kind) for name, kind in kinds.items()}
    out |= {name: np.empty((*shape, masses)) for name in over_masses}
    return out, {name: array.ctypes.data for name, array in out.items()}


def solve(handle: Optional[c_void_p], points: Arrays, masses: Union[np.ndarray, int], threads: int, progress: Report,
          effort: Optional[float] = None, **settings: Any) -> Solutions:
    """dh_solve_points() of a system, or dh_solve_systems() of the systems in `points`, whose arrays are broadcast; `masses` as a
    number takes all of each system, and is that of the largest."""
    shape, listed = shape_of(**points), np.arange(1, masses + 1) if isinstance(masses, int) else masses.astype(int)
    out, found = _room(shape, listed.size, ("amplitude", "amplitude_error", "phase", "phase_error"))
    full = {name: np.array(np.broadcast_to(array, shape), order="C") for name, array in points.items()}
    for name, array in full.items():
        settings |= {name: array.ctypes.data, name + "_step": 1}
    if out["status"].size > 0:
        name, handles, kind = ("dh_solve_points", (handle,), _library.PointsRequest) if handle is not None else (
            "dh_solve_systems", (), _library.SystemsRequest)
        request = kind(count=out["status"].size, mass_count=listed.size, threads=threads,
                       masses=None if isinstance(masses, int) else masses.ctypes.data, **settings)
        result = _library.Points(step=1, masses_step=listed.size, mass_step=1, **found)
        run(name, handles, request, result, progress, (full, masses, out), effort)
    full.pop("systems", None)
    return Solutions(masses=listed, **{"mu": settings["mu"]} | full, **out)


def solve_map(handle: c_void_p, r: np.ndarray, beta: np.ndarray, mu: float, from_sliding: bool, masses: np.ndarray,
              threads: int, progress: Report, effort: Optional[float] = None, phases: bool = False,
              from_ground: bool = False) -> Arrays:
    """dh_map() over the grid of `r` and `beta`; arrays of the shape r by beta, the masses last."""
    wanted = masses.size
    out, found = _room((r.size, beta.size), wanted, ("amplitude", "phase") if phases else ("amplitude",))
    request = _library.MapRequest(
        r_count=r.size, r=r.ctypes.data, beta_count=beta.size, beta=beta.ctypes.data, mu=mu, from_sliding=int(from_sliding),
        mass_count=wanted, masses=masses.ctypes.data, threads=threads, from_ground=int(from_ground))
    result = _library.MapResult(r_step=beta.size, beta_step=1, amplitude_r_step=beta.size * wanted,
                                amplitude_beta_step=wanted, mass_step=1, **found)
    run("dh_map", (handle,), request, result, progress, (r, beta, masses, out), effort)
    return out
