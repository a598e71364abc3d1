"""Steady forced vibration of damped mass-spring systems with one Coulomb contact.

The exact steady state of L. Marino and A. Cicirello, Journal of Sound and Vibration 535 (2022) 117085, in every regime.

>>> import denhartog
>>> system = denhartog.System(mass_ratios=[1, 1], stiffness_ratios=[1, 1], damping_ratios=0.05, contact=2, load=1)
>>> system.solve(r=0.8, beta=0.2).regime
'continuous'

Masses and modes count from 1. Displacements are in units of P / k_1, angles in radians, r = omega sqrt(m_1 / k_1),
beta = F / P, and mu is static over kinetic friction.
"""
from typing import Any

from ._errors import Cancelled, DomainError, Error, InputError, PrecisionError
from ._find import Found, Place, find
from ._results import Boundary, Energies, FreeDecay, FromGround, Functions, History, Map, Motion, Solution, Solutions
from ._system import System, solve_many

__all__ = ["Boundary", "Cancelled", "DomainError", "Energies", "Error", "Found", "FreeDecay", "FromGround", "Functions",
           "History", "InputError", "Map", "Motion",
           "Place", "PrecisionError", "Solution", "Solutions", "System", "find", "solve_many"]


def __getattr__(name: str) -> Any:
    if name == "__version__":  # that of the library, which is loaded when it is first needed
        from ._library import library
        return library().dh_version().decode()
    raise AttributeError(f"module 'denhartog' has no attribute {name!r}")
