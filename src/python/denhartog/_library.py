"""Finds and loads the shared library, declares its functions, and turns its statuses into exceptions."""
from __future__ import annotations

import ctypes
import functools
import os
import pathlib
from ctypes import POINTER, c_char_p, c_double, c_int, c_size_t, c_ssize_t, c_uint, c_void_p
from typing import Any

from ._errors import DomainError, Error, InputError, PrecisionError

NAME = "libdenhartog.so.0"
ABI_VERSION = 0  # DH_ABI_VERSION of the header that the structs below are taken from

Progress = ctypes.CFUNCTYPE(c_int, c_size_t, c_size_t, c_void_p)
_numbers, _bytes, _integers, _indices = POINTER(c_double), POINTER(ctypes.c_byte), POINTER(c_int), POINTER(c_size_t)


class Sized(ctypes.Structure):
    """A struct whose first member is its size."""

    def __init__(self, **members: Any) -> None:
        super().__init__(size=ctypes.sizeof(type(self)), **members)


class Boundary(Sized):
    """dh_boundary"""

    _fields_ = [("size", c_size_t), ("exact", c_double), ("paper", c_double), ("approximate", c_double),
                ("sticking", c_double), ("sticking_exists", c_int)]


class Summary(Sized):
    """dh_summary"""

    _fields_ = [("size", c_size_t), ("regime", c_int), ("on_boundary", c_int), ("unique", c_int), ("symmetric", c_int),
                ("periods", c_int), ("rest_interval_exists", c_int), ("stops", c_size_t), ("rest_from", c_double),
                ("rest_to", c_double), ("rest_error", c_double), ("relative_error", c_double)]


class Mass(Sized):
    """dh_mass"""

    _fields_ = [("size", c_size_t), ("amplitude", c_double), ("error", c_double), ("phase", c_double),
                ("phase_error", c_double), ("moves", c_int)]


class MapRequest(Sized):
    """dh_map_request"""

    _fields_ = [("size", c_size_t), ("r_count", c_size_t), ("r", _numbers), ("beta_count", c_size_t), ("beta", _numbers),
                ("mu", c_double), ("from_sliding", c_int), ("mass_count", c_size_t), ("masses", _indices),
                ("threads", c_uint), ("progress", Progress), ("context", c_void_p)]


class MapResult(Sized):
    """dh_map_result"""

    _fields_ = [("size", c_size_t), ("r_step", c_ssize_t), ("beta_step", c_ssize_t), ("status", _bytes),
                ("regime", _bytes), ("stops", _integers), ("periods", _integers), ("amplitude_r_step", c_ssize_t),
                ("amplitude_beta_step", c_ssize_t), ("mass_step", c_ssize_t), ("amplitude", _numbers)]


class PointsRequest(Sized):
    """dh_points_request"""

    _fields_ = [("size", c_size_t), ("count", c_size_t), ("r", _numbers), ("r_step", c_ssize_t), ("beta", _numbers),
                ("beta_step", c_ssize_t), ("mu", c_double), ("digits", c_int), ("mass_count", c_size_t),
                ("masses", _indices), ("threads", c_uint), ("progress", Progress), ("context", c_void_p)]


class SystemsRequest(Sized):
    """dh_systems_request"""

    _fields_ = [("size", c_size_t), ("count", c_size_t), ("systems", POINTER(c_void_p)), ("system_step", c_ssize_t),
                ("r", _numbers), ("r_step", c_ssize_t), ("beta", _numbers), ("beta_step", c_ssize_t), ("mu", _numbers),
                ("mu_step", c_ssize_t), ("digits", c_int), ("mass_count", c_size_t), ("masses", _indices),
                ("threads", c_uint), ("progress", Progress), ("context", c_void_p)]


class Points(Sized):
    """dh_points"""

    _fields_ = [("size", c_size_t), ("step", c_ssize_t), ("status", _bytes), ("regime", _bytes), ("stops", _integers),
                ("periods", _integers), ("masses_step", c_ssize_t), ("mass_step", c_ssize_t), ("amplitude", _numbers),
                ("error", _numbers), ("phase", _numbers), ("phase_error", _numbers)]


_PROTOTYPES = {
    "dh_system_from_json": [c_char_p, c_size_t, POINTER(c_void_p)],
    "dh_system_masses": [c_void_p, _indices, _indices, _indices],
    "dh_natural_frequency_ratios": [c_void_p, c_size_t, _numbers, _numbers],
    "dh_natural_frequency_ratio_errors": [c_void_p, c_size_t, _numbers, _numbers],
    "dh_sum_errors": [c_void_p, c_double, c_size_t, _numbers, _numbers, _numbers, _numbers, _numbers],
    "dh_boundary_errors": [c_void_p, c_double, c_double, POINTER(Boundary)],
    "dh_sums": [c_void_p, c_double, c_size_t, _numbers, _numbers, _numbers, _numbers, _numbers],
    "dh_boundaries": [c_void_p, c_double, c_double, POINTER(Boundary)],
    "dh_boundaries_proved": [c_void_p, c_double, c_double, POINTER(Boundary), POINTER(Boundary)],
    "dh_set_effort": [c_double, c_void_p, c_void_p],
    "dh_solve": [c_void_p, c_double, c_double, c_double, c_int, POINTER(c_void_p)],
    "dh_solve_proved": [c_void_p, c_double, c_double, c_double, c_int, POINTER(c_void_p)],
    "dh_solution_is_proved": [c_void_p, _integers],
    "dh_solution_summary": [c_void_p, POINTER(Summary)],
    "dh_solution_mass": [c_void_p, c_size_t, POINTER(Mass)],
    "dh_solution_contact": [c_void_p, POINTER(Mass)],
    "dh_solution_stops": [c_void_p, c_size_t, _numbers, _numbers],
    "dh_solution_stop_errors": [c_void_p, c_size_t, _numbers, _numbers],
    "dh_solution_motion": [c_void_p, c_size_t, c_size_t, _numbers, _numbers],
    "dh_map": [c_void_p, POINTER(MapRequest), POINTER(MapResult)],
    "dh_solve_points": [c_void_p, POINTER(PointsRequest), POINTER(Points)],
    "dh_solve_systems": [POINTER(SystemsRequest), POINTER(Points)],
}


def _candidates() -> list[str]:
    """Where the library may be: in the package, where DENHARTOG_LIBRARY says, where the system looks."""
    beside = pathlib.Path(__file__).with_name(NAME)
    if beside.exists():
        return [str(beside)]
    named = os.environ.get("DENHARTOG_LIBRARY")
    return [named] if named else [NAME]


def _loaded() -> ctypes.CDLL:
    path = _candidates()[0]
    try:
        return ctypes.CDLL(path)
    except OSError as reason:
        raise ImportError(
            f"denhartog cannot load its shared library: {reason}. It needs {NAME} in the package's folder, at the path that the "
            "environment variable DENHARTOG_LIBRARY names, or where the system's loader looks, and the system's MPFR, GMP, FLINT "
            "and Arb (on Debian 12 the packages libmpfr6, libgmp10, libflint17 and libflint-arb2)") from reason


@functools.lru_cache(maxsize=None)
def library() -> ctypes.CDLL:
    """The loaded library with its functions declared.

    Raises
    ------
    ImportError
        Where it is not found, or is of another ABI version than this package.
    """
    found = _loaded()
    version = found.dh_abi_version()
    if version != ABI_VERSION:
        raise ImportError(f"the shared library of denhartog must have ABI version {ABI_VERSION}, but {found._name} has {version}")
    found.dh_version.restype = found.dh_last_message.restype = found.dh_status_text.restype = c_char_p
    found.dh_status_text.argtypes = [c_int]
    for name in ("dh_system_destroy", "dh_solution_destroy"):
        getattr(found, name).argtypes, getattr(found, name).restype = [c_void_p], None
    for name, arguments in _PROTOTYPES.items():
        try:
            getattr(found, name).argtypes = arguments
        except AttributeError as reason:
            raise ImportError(f"the shared library of denhartog must have {name}, but {found._name}, version "
                              f"{found.dh_version().decode()}, does not: it is too old for this package") from reason
    return found


def fault(status: int) -> BaseException:
    """The exception for a status other than DH_OK, with the message of the calling thread."""
    message = library().dh_last_message().decode("utf-8", "replace")
    if status in (2, 3):  # DH_ERROR_SIZE, DH_ERROR_INPUT
        return InputError(message)
    if status == 6:  # DH_ERROR_MEMORY
        return MemoryError(message)
    return {4: DomainError, 5: PrecisionError}.get(status, Error)(message)


def call(name: str, *arguments: Any) -> None:
    """Calls a function of the library and raises the exception of its status."""
    status = getattr(library(), name)(*arguments)
    if status != 0:
        raise fault(status)


def pointer(array: Any, kind: Any = c_double) -> Any:
    """The address of a numpy array's numbers, for the length of a call; null for None."""
    return None if array is None else array.ctypes.data_as(POINTER(kind))
