"""Finds and loads the shared library, declares its functions, and turns its statuses into exceptions."""
from __future__ import annotations

import ctypes
import functools
import os
import pathlib
import weakref
from ctypes import byref, c_char_p, c_double, c_int, c_size_t, c_ssize_t, c_uint, c_void_p
from typing import Any

from ._errors import DomainError, Error, InputError, PrecisionError

NAME = "libdenhartog.so.0"
ABI_VERSION = 0  # DH_ABI_VERSION of the header that structs and arguments are taken from

Progress = ctypes.CFUNCTYPE(c_int, c_size_t, c_size_t, c_void_p)
_KINDS = {"double": c_double, "int": c_int, "unsigned": c_uint, "size_t": c_size_t, "ptrdiff_t": c_ssize_t, "void*": c_void_p,
          "dh_progress": Progress}


class _Sized(ctypes.Structure):
    """A struct whose first member is its size."""

    def __init__(self, **members: Any) -> None:
        super().__init__(size=ctypes.sizeof(type(self)), **members)


def _struct(name: str, members: str) -> Any:
    """A struct of the header, of which every pointer is a void*."""
    kinds = [each.split(" ", 1) for each in f"size_t size; {members}".split("; ")]
    return type(name, (_Sized,), {"_fields_": [(name, _KINDS[kind]) for kind, names in kinds for name in names.split(", ")]})


Boundary = _struct("dh_boundary", "double exact, paper, approximate, sticking; int sticking_exists")
Summary = _struct("dh_summary", "int regime, on_boundary, unique, symmetric, periods, rest_interval_exists; size_t stops; "
                                "double rest_from, rest_to, rest_error, relative_error")
Mass = _struct("dh_mass", "double amplitude, error, phase, phase_error; int moves")
Energies = _struct("dh_energies", "double contact, dampers, friction, on_base, equivalent_damping, equivalent_damping_ratio, "
                                  "textbook_contact, textbook_contact_off, textbook_amplitude, textbook_amplitude_off; "
                                  "int contact_moves, textbook_amplitude_exists")
DecayRequest = _struct("dh_decay_request", "double r, beta, mu; void* x, x_prime; double until")
Decay = _struct("dh_decay", "size_t room; void* turn, turn_error, turn_x, turn_x_error, start, start_error, end, end_error, "
                            "stop_x, stop_x_error, masses, masses_error, rest, rest_error; size_t turns, stops; "
                            "int at_rest, others, on_limit")
HistoryRequest = _struct("dh_history_request", "double r, beta, mu; void* x, x_prime; int cycles, last, samples, without_load")
HistoryResult = _struct("dh_history", "size_t stop_room, sample_room; void* start, end, stop_x, tau, x, x_prime, direction; "
                                      "size_t stops, samples; double from_")
MapRequest = _struct("dh_map_request", "size_t r_count; void* r; size_t beta_count; void* beta; double mu; int from_sliding; "
                                       "size_t mass_count; void* masses; unsigned threads; dh_progress progress; void* context; "
                                       "int from_ground")
MapResult = _struct("dh_map_result", "ptrdiff_t r_step, beta_step; void* status, regime, stops, periods; "
                                     "ptrdiff_t amplitude_r_step, amplitude_beta_step, mass_step; void* amplitude, phase")
PointsRequest = _struct("dh_points_request", "size_t count; void* r; ptrdiff_t r_step; void* beta; ptrdiff_t beta_step; "
                                             "double mu; int digits; size_t mass_count; void* masses; unsigned threads; "
                                             "dh_progress progress; void* context; int from_ground")
SystemsRequest = _struct("dh_systems_request", "size_t count; void* systems; ptrdiff_t systems_step; void* r; ptrdiff_t r_step; "
                                               "void* beta; ptrdiff_t beta_step; void* mu; ptrdiff_t mu_step; int digits; "
                                               "size_t mass_count; void* masses; unsigned threads; dh_progress progress; "
                                               "void* context; int from_ground")
Points = _struct("dh_points", "ptrdiff_t step; void* status, regime, stops, periods; ptrdiff_t masses_step, mass_step; "
                              "void* amplitude, amplitude_error, phase, phase_error")

FindRequest = _struct("dh_find_request", "void* scene; size_t scene_length; void* vary; double from_, to; void* so_that; "
                                         "int samples")
Places = _struct("dh_places", "size_t room; void* at, from_, to, amplitude, error, is_; size_t count, unanswered")

_LETTERS = {"p": c_void_p, "n": c_size_t, "i": c_int, "d": c_double}
_FUNCTIONS = {  # by their arguments
    "p": "dh_system_destroy dh_solution_destroy",
    "pp": "dh_solution_is_proved dh_solution_is_from_rest dh_solution_summary dh_solution_contact dh_solve_systems dh_find",
    "ppp": "dh_map dh_solve_points dh_free_decay dh_follow",
    "pppp": "dh_system_masses",
    "pnp": "dh_system_from_json dh_solution_mass dh_solution_warning",
    "pnppp": "dh_solution_from_ground",
    "pipp": "dh_solution_energies",
    "pnpp": "dh_place_of_rest dh_natural_frequency_ratios dh_natural_frequency_ratio_errors dh_solution_stops dh_solution_stop_errors",
    "pnnpp": "dh_solution_motion",
    "pddp": "dh_boundaries dh_boundary_errors",
    "pddpp": "dh_boundaries_proved",
    "pdnppppp": "dh_sums dh_sum_errors",
    "pdddip": "dh_solve dh_solve_proved",
    "ppdddndnpp": "dh_quantity dh_quantity_errors",
    "dpp": "dh_set_effort",
}


@functools.lru_cache(maxsize=None)
def library() -> ctypes.CDLL:
    """The library with its functions declared: of the package, else what DENHARTOG_LIBRARY names, else what the system finds."""
    beside = pathlib.Path(__file__).with_name(NAME)
    try:
        found = ctypes.CDLL(str(beside) if beside.exists() else os.environ.get("DENHARTOG_LIBRARY") or NAME)
    except OSError as reason:
        raise ImportError(
            f"denhartog cannot load its shared library: {reason}. It needs {NAME} in the package's folder, at the path that the "
            "environment variable DENHARTOG_LIBRARY names, or where the system's loader looks, and the system's MPFR, GMP, FLINT "
            "and Arb (on Debian 12 the packages libmpfr6, libgmp10, libflint17 and libflint-arb2)") from reason
    version = found.dh_abi_version()
    if version != ABI_VERSION:
        raise ImportError(f"the shared library of denhartog must have ABI version {ABI_VERSION}, but {found._name} has {version}")
    found.dh_version.restype = found.dh_last_message.restype = c_char_p
    for letters, names in _FUNCTIONS.items():
        for name in names.split():
            try:
                getattr(found, name).argtypes = [_LETTERS[letter] for letter in letters]
            except AttributeError as reason:
                raise ImportError(f"the shared library of denhartog must have {name}, but {found._name}, version "
                                  f"{found.dh_version().decode()}, does not: it is too old for this package") from reason
    return found


def call(name: str, *arguments: Any) -> None:
    """Calls a function of the library and raises the exception of its status, with the message of the calling thread."""
    status = getattr(library(), name)(*arguments)
    if status != 0:  # the numbers are those of enum dh_status
        kind = {2: InputError, 3: InputError, 4: DomainError, 5: PrecisionError, 6: MemoryError}.get(status, Error)
        raise kind(library().dh_last_message().decode("utf-8", "replace"))


def handle(name: str, destroy: str, *arguments: Any) -> c_void_p:
    """What a function of the library makes, destroyed with this object."""
    made = c_void_p()
    call(name, *arguments, byref(made))
    weakref.finalize(made, getattr(library(), destroy), made.value)
    return made
