"""What a system has in units of its own: newtons, metres and hertz, or any others that go together."""
from __future__ import annotations

import math
from typing import Any, Optional, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _batch, _scene
from ._errors import InputError

Real = Union[float, np.ndarray]


class Units:
    """The part of a System that is about units. Its members need a system given by `masses` and `stiffnesses`."""

    _scene: dict[str, Any]
    _r_n: np.ndarray

    @property
    def dimensional(self) -> bool:
        """Whether the system was given by `masses` and `stiffnesses` in units of its own."""
        return "masses" in self._scene

    @property
    def m_1(self) -> float:
        """The mass that masses are in units of. Of a dimensional system only."""
        return self._unit("masses")

    @property
    def k_1(self) -> float:
        """The stiffness that stiffnesses are in units of. Of a dimensional system only."""
        return self._unit("stiffnesses")

    def _unit(self, key: str) -> float:
        if not self.dimensional:
            raise InputError.of("the system", "must be given by masses and stiffnesses to have units", "given by ratios")
        return _scene.first(self._scene[key])

    @property
    def natural_frequencies(self) -> np.ndarray:
        """omega_i in radians per unit of time, ascending; shape (N,). Of a dimensional system only."""
        return self._r_n * math.sqrt(self.k_1 / self.m_1)

    def frequency_ratio(self, omega: Optional[ArrayLike] = None, *, hz: Optional[ArrayLike] = None) -> Real:
        """r = omega sqrt(m_1 / k_1), Eq. (10). Of a dimensional system only.

        Parameters
        ----------
        omega : array_like
            Circular frequency of the load in radians per unit of time; or
        hz : array_like
            its frequency in periods per unit of time.

        Returns
        -------
        float or ndarray
            Frequency ratios of the same shape.
        """
        return like(self._circular(omega, hz) * math.sqrt(self.m_1 / self.k_1))

    def _circular(self, omega: Optional[ArrayLike], hz: Optional[ArrayLike]) -> np.ndarray:
        if (omega is None) == (hz is None):
            raise InputError.of("omega", "must be given, or hz in its place", "nothing" if omega is None else "given with hz")
        return _batch.numbers("omega", omega) if hz is None else 2 * np.pi * _batch.numbers("hz", hz)

    def friction_ratio(self, friction: ArrayLike, force: ArrayLike) -> Real:
        """beta = F / P, Eq. (11), of the kinetic friction force and the amplitude of the load in the same unit."""
        return like(_batch.numbers("friction", friction) / _batch.numbers("force", force))

    def displacement_unit(self, force: ArrayLike) -> Real:
        """P / k_1, by which displacements have to be multiplied, for an amplitude P of the load. Of a dimensional system only."""
        return like(_batch.numbers("force", force) / self.k_1)

    def base_force(self, displacement: ArrayLike, omega: Optional[ArrayLike] = None, *, hz: Optional[ArrayLike] = None) -> Real:
        """The force P that a moving base stands for: m_1 omega^2 X where the wall moves with it, k_1 X where it moves alone.

        Parameters
        ----------
        displacement : array_like
            Amplitude X of the base.
        omega, hz : array_like
            Frequency as of `frequency_ratio`; not needed where the base moves alone.
        """
        X = _batch.numbers("displacement", displacement)
        base = self._scene.get("base_motion")
        if base is None:
            raise InputError.of("base_motion", "must be given for a base to have a force", "nothing")
        return like(self.k_1 * X if base == "alone" else self.m_1 * self._circular(omega, hz) ** 2 * X)

def like(array: ArrayLike) -> Real:
    """A number for an array without dimensions."""
    array = np.asarray(array)
    return float(array) if array.ndim == 0 else array
