"""Long calls of the library, which progress and Ctrl-C can end, and the arrays that they fill."""
from __future__ import annotations

import ctypes
import threading
from typing import Any, Callable, Optional

import numpy as np

from . import _library
from ._errors import Cancelled, InputError

Report = Optional[Callable[[int, int], Any]]


def run(name: str, handles: tuple[ctypes.c_void_p, ...], request: Any, result: Any, progress: Report, arrays: Any,
        effort: Optional[float] = None) -> None:
    """Calls dh_map(), dh_solve_points() or dh_solve_systems() in a thread of its own and waits for it.

    A thread in C does not see Ctrl-C. The thread that waits here does, and so does the function `progress`, which it calls.

    Parameters
    ----------
    name, handles, request, result
        The function and its arguments.
    progress : callable or None
        Called as ``progress(done, all)`` in the calling thread; the call ends where it returns something true.
    arrays
        What `request` and `result` point to: kept until the library is done, even where a second Ctrl-C ends the waiting.
    effort : float or None
        Operations allowed for each point, default those of the library.
    """
    library = _library.library()
    news, ended = threading.Event(), threading.Event()
    state = {"done": 0, "all": 0, "stop": 0, "fault": None, "arrays": arrays}

    def told(done: int, everything: int, _: Any) -> int:
        state["done"], state["all"] = done, everything
        news.set()
        return state["stop"]

    def work() -> None:
        try:
            if effort is not None:
                _library.call("dh_set_effort", effort, None, None)  # of this thread alone, which ends with the call
            status = getattr(library, name)(*handles, ctypes.byref(request), ctypes.byref(result))
            if status != 0:
                state["fault"] = _library.fault(status)  # the message is kept for each thread by itself
        except BaseException as reason:  # it must not be lost with this thread
            state["fault"] = reason
        finally:
            state["arrays"] = None
            ended.set()
            news.set()

    request.progress = _library.Progress(told)
    worker = threading.Thread(target=work, name="denhartog")
    worker.start()
    reported = 0
    try:
        while True:
            news.wait()
            news.clear()
            last, done = ended.is_set(), state["done"]
            if progress is not None and done > reported:
                reported = done
                if progress(done, state["all"]) and not last:
                    state["stop"] = 1
            if last:
                break
    finally:
        if not ended.is_set():
            state["stop"] = 1
        worker.join()
    if state["fault"] is not None:
        if state["stop"]:
            raise Cancelled(f"the function given as progress ended the computation after {state['done']} of {state['all']}")
        raise state["fault"]


def numbers(name: str, values: Any) -> np.ndarray:
    """An array of doubles, or an InputError that names the argument."""
    try:
        return np.asarray(values, dtype=np.float64)
    except (TypeError, ValueError) as reason:
        raise InputError.of(name, "must be a number or an array of numbers", repr(values)) from reason


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
    if not 0 <= threads <= 65536:
        raise InputError.of("threads", "must be from 0, which is as many as the machine has, to 65536", threads)
    return int(threads)


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


def _flat(array: np.ndarray, shape: tuple[int, ...]) -> tuple[np.ndarray, int]:
    """An array's elements, one for each point, and the step between them: a single element has the step 0."""
    if array.ndim == 0:
        return np.ascontiguousarray(array).reshape(-1), 0
    return np.ascontiguousarray(np.broadcast_to(array, shape)).reshape(-1), 1


def _of_points(shape: tuple[int, ...], wanted: int) -> dict[str, np.ndarray]:
    out = {name: np.empty(shape, dtype) for name, dtype in
           (("status", np.int8), ("regime", np.int8), ("stops", np.intc), ("periods", np.intc))}
    out.update({name: np.empty(shape + (wanted,)) for name in ("amplitude", "error", "phase", "phase_error")})
    return out


def solve_points(handle: ctypes.c_void_p, r: np.ndarray, beta: np.ndarray, mu: float, digits: int, masses: np.ndarray,
                 threads: int, progress: Report, effort: Optional[float] = None) -> dict[str, np.ndarray]:
    """dh_solve_points() over `r` broadcast with `beta`; arrays of the broadcast shape, the masses last."""
    shape, wanted = shape_of(r=r, beta=beta), masses.size
    out = _of_points(shape, wanted)
    if out["status"].size == 0:
        return out
    (flat_r, r_step), (flat_beta, beta_step) = _flat(r, shape), _flat(beta, shape)
    request = _library.PointsRequest(
        count=out["status"].size, r=_library.pointer(flat_r), r_step=r_step, beta=_library.pointer(flat_beta),
        beta_step=beta_step, mu=mu, digits=digits, mass_count=wanted, masses=_library.pointer(masses, ctypes.c_size_t),
        threads=threads)
    result = _library.Points(step=1, masses_step=wanted, mass_step=1, **_addresses(out))
    run("dh_solve_points", (handle,), request, result, progress, (flat_r, flat_beta, masses, out), effort)
    return out


def solve_systems(addresses: np.ndarray, r: np.ndarray, beta: np.ndarray, mu: np.ndarray, digits: int,
                  masses: Optional[np.ndarray], most_masses: int, threads: int, progress: Report) -> dict[str, np.ndarray]:
    """dh_solve_systems() over the systems at `addresses` broadcast with `r`, `beta` and `mu`; arrays of the broadcast shape."""
    shape = shape_of(systems=addresses, r=r, beta=beta, mu=mu)
    wanted = most_masses if masses is None else masses.size
    out = _of_points(shape, wanted)
    if out["status"].size == 0:
        return out
    (flat_systems, system_step), (flat_r, r_step) = _flat(addresses, shape), _flat(r, shape)
    (flat_beta, beta_step), (flat_mu, mu_step) = _flat(beta, shape), _flat(mu, shape)
    request = _library.SystemsRequest(
        count=out["status"].size, systems=_library.pointer(flat_systems, ctypes.c_void_p), system_step=system_step,
        r=_library.pointer(flat_r), r_step=r_step, beta=_library.pointer(flat_beta), beta_step=beta_step,
        mu=_library.pointer(flat_mu), mu_step=mu_step, digits=digits, mass_count=0 if masses is None else wanted,
        masses=_library.pointer(masses, ctypes.c_size_t), threads=threads)
    result = _library.Points(step=1, masses_step=wanted, mass_step=1, **_addresses(out))
    run("dh_solve_systems", (), request, result, progress, (flat_systems, flat_r, flat_beta, flat_mu, masses, out))
    return out


def solve_map(handle: ctypes.c_void_p, r: np.ndarray, beta: np.ndarray, mu: float, from_sliding: bool, masses: np.ndarray,
              threads: int, progress: Report, effort: Optional[float] = None) -> dict[str, np.ndarray]:
    """dh_map() over the grid of `r` and `beta`; arrays of the shape r by beta, the masses last."""
    shape, wanted = (r.size, beta.size), masses.size
    out = {name: np.empty(shape, dtype) for name, dtype in
           (("status", np.int8), ("regime", np.int8), ("stops", np.intc), ("periods", np.intc))}
    out["amplitude"] = np.empty(shape + (wanted,))
    request = _library.MapRequest(
        r_count=r.size, r=_library.pointer(r), beta_count=beta.size, beta=_library.pointer(beta), mu=mu,
        from_sliding=int(from_sliding), mass_count=wanted, masses=_library.pointer(masses, ctypes.c_size_t), threads=threads)
    result = _library.MapResult(r_step=beta.size, beta_step=1, amplitude_r_step=beta.size * wanted,
                                amplitude_beta_step=wanted, mass_step=1, **_addresses(out))
    run("dh_map", (handle,), request, result, progress, (r, beta, masses, out), effort)
    return out


def _addresses(arrays: dict[str, np.ndarray]) -> dict[str, Any]:
    kinds = {"b": ctypes.c_byte, "i": ctypes.c_int, "d": ctypes.c_double}
    return {name: _library.pointer(array, kinds[array.dtype.char]) for name, array in arrays.items()}
