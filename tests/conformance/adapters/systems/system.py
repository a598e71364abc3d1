"""The steady motion of any linear system with one Coulomb contact, from its matrices: M x'' + C x' + K x = p cos + friction on w.

Between two stops the system is linear and friction is constant, whatever the damping. Numbers in brackets are the equations of
Marino & Cicirello, JSV 535 (2022) 117085, that hold with w^T x in the place of x_j and p in the place of the loaded mass.
"""
import math
from functools import cached_property
import numpy as np


def chain(strengths):
    """The stiffness matrix of a chain, spring i between mass i and the one before it, the first to the ground, (73)."""
    k = np.array(strengths, float)
    return np.diag(k + np.append(k[1:], 0)) - np.diag(k[1:], 1) - np.diag(k[1:], -1)


def modal_damping(M, K, zeta):
    """The damping matrix that has these damping ratios, modes by ascending natural frequency, (19)."""
    L = np.linalg.cholesky(M)
    inverse = np.linalg.inv(L)
    squares, shapes = np.linalg.eigh(inverse @ K @ inverse.T)
    momenta = L @ shapes
    return momenta @ np.diag(2 * np.array(zeta, float) * np.sqrt(squares)) @ momenta.T


def largest(f, tau):
    """Largest value and its place: f gives a value and a number with the sign of its slope, bisected where that turns."""
    rising = f(tau)[1] > 0
    a, b = tau[:-1][rising[:-1] & ~rising[1:]], tau[1:][rising[:-1] & ~rising[1:]]
    for _ in range(60 if a.size else 0):
        up = f((a + b) / 2)[1] > 0
        a, b = np.where(up, (a + b) / 2, a), np.where(up, b, (a + b) / 2)
    tau = np.append(tau, (a + b) / 2)
    value = f(tau)[0]
    return value.max(), tau[value.argmax()]


class System:
    def __init__(self, scene):
        self.mu, self.r, self.beta = float(scene["mu"]), float(scene["r"]), float(scene["beta"])
        mass = np.array(scene["mass_matrix"], float) if "mass_matrix" in scene else np.diag(scene["mass_ratios"]).astype(float)
        self.K = np.array(scene["stiffness_matrix"], float) if "stiffness_matrix" in scene else chain(scene["stiffness_ratios"])
        if "damping_matrix" in scene:
            damping = np.array(scene["damping_matrix"], float)
        else:
            damping = modal_damping(mass, self.K, scene["damping_ratios"])
        self.M, self.C, self.N = self.r**2 * mass, self.r * damping, len(mass)  # (7), (8): time in tau
        self.w = np.zeros(self.N)  # the contact slides by w^T x
        contact = scene["contact"] if isinstance(scene["contact"], list) else [scene["contact"]]
        for mass_in_contact, sign in zip(contact, (1, -1)):
            self.w[mass_in_contact - 1] += sign
        self.base = self.frame = 0.0  # how far base or wall moves, and with it the frame of the displacements, in units of P / k_1
        if "base_motion" in scene:
            inertia, held = self.M.sum(axis=1), (self.K + 1j * self.C).sum(axis=1)  # springs and dampers to the base
            self.base, alone = 1.0, scene["base_motion"] == "alone"
            self.p = held if alone else inertia - held
            if scene["base_motion"] == "with_wall":
                self.base, self.p = self.r**-2, mass.sum(axis=1)
            self.frame = 0.0 if alone else self.base
        elif isinstance(scene["load"], list):
            leads = np.array(scene.get("load_phases", np.zeros(self.N)), float)
            self.p = np.array(scene["load"], float) * np.exp(1j * leads)
        else:
            self.p = np.eye(self.N)[scene["load"] - 1]
        self.X = np.linalg.solve(self.K - self.M + 1j * self.C, self.p)  # x = Re{X exp(i tau)} under Re{p exp(i tau)} alone
        self.V_j = self.w @ self.X  # (33)
        inverse = np.linalg.inv(self.M)
        self.A = np.block([[np.zeros((self.N, self.N)), np.eye(self.N)], [-inverse @ self.K, -inverse @ self.C]])
        self.rates, self.shapes = np.linalg.eig(self.A)
        # Under a unit force on the contact that changes its sign every half-period: rest less a free motion that mirrors itself.
        self.rest = np.append(np.linalg.solve(self.K, self.w), np.zeros(self.N))
        self.free = np.linalg.solve(self.shapes, 2 * self.rest) / (1 + np.exp(math.pi * self.rates))
        self.at_once = self.w @ inverse @ self.w  # (65): acceleration of the contact under that force
        self.U_j = self.U(self.w)
        self.samples = 64 * min(512, math.ceil(2 + np.abs(self.rates).max()))

    def under_friction(self, d, tau, order=0):
        """The displacement d^T x under the unit force over the half-period, or a derivative of it."""
        powers = np.exp(np.multiply.outer(np.atleast_1d(tau), self.rates)) * self.rates**order
        return (d @ self.rest[: self.N] if order == 0 else 0) - ((d @ self.shapes[: self.N]) * self.free @ powers.T).real

    def U(self, d):  # (34): the velocity at the maximum of the contact, with the sign turned
        return -self.under_friction(d, 0, 1)[0]

    def G(self, d):  # (35): the displacement there, with the sign turned
        return -self.under_friction(d, 0)[0]

    @cached_property
    def S(self):
        """Largest part of the velocity's amplitude that friction takes, (56), its limits at both ends included."""
        def at(tau):
            velocity, change = self.under_friction(self.w, tau, 1), self.under_friction(self.w, tau, 2)
            N, N_prime = self.U_j * np.cos(tau) + velocity, change - self.U_j * np.sin(tau)
            return N / np.sin(tau), N_prime * np.sin(tau) - N * np.cos(tau)
        inside = math.pi * np.arange(1, self.samples) / self.samples
        inside = np.append(np.geomspace(1e-6, inside[0], 100, endpoint=False), inside)
        ends = self.under_friction(self.w, [0, math.pi], 2)
        return max(ends[0], -ends[1], largest(at, inside)[0])

    @cached_property
    def H_j(self):
        return self.under_friction(self.w, 0, 2)[0] - self.at_once

    @cached_property
    def beta_lim(self):  # (67), (69)
        return abs(self.V_j) / math.hypot(self.U_j, max(self.S, self.H_j + self.mu * self.at_once))

    @cached_property
    def held(self):
        """Contact held: X_k in x_k = Re{X_k exp(i tau)}; the least beta that does it; how far from zero it may rest."""
        Z = np.block([[self.K - self.M + 1j * self.C, -self.w[:, None]], [self.w[None, :], np.zeros((1, 1))]])
        X = np.linalg.solve(Z, np.append(self.p, 0))
        limit = abs(X[-1]) / self.mu
        return X[:-1], limit, self.mu * (self.beta - limit) * self.w @ self.rest[: self.N]

    @cached_property
    def regime(self):
        if self.beta < self.beta_lim:
            return "continuous"
        return "permanent_sticking" if self.beta >= self.held[1] else "stick_slip"

    @cached_property
    def sliding(self):
        """phi_j, (39), and exp(i phi_j) with (36), (37), which X is turned by: tau = 0 at the maximum of the contact."""
        if self.regime != "continuous":
            raise ArithmeticError("the contact does not slide throughout")
        bU = self.beta * self.U_j
        at_contact = complex(math.sqrt((abs(self.V_j) - bU) * (abs(self.V_j) + bU)), -bU)
        return math.atan2(at_contact.imag, at_contact.real) - np.angle(self.V_j), at_contact / self.V_j

    def motion(self, d, tau, frame=0.0):
        """The displacement d^T x and its derivative, (46) as corrected; mirrored after half a period.

        In a frame that moves by frame cos(tau), with tau from the maximum of the force."""
        half, tau = np.divmod(np.atleast_1d(tau), math.pi)
        W = (d @ self.X + frame) * self.sliding[1] * np.exp(1j * tau)
        x = W.real + self.beta * self.under_friction(d, tau), -W.imag + self.beta * self.under_friction(d, tau, 1)
        return (1 - 2 * (half % 2)) * np.array(x)

    def amplitude_and_phase(self, d, frame=0.0):
        if self.regime == "permanent_sticking":
            x = frame + (0j if (d == self.w).all() else d @ self.held[0])  # the contact rests
            return abs(x), 0 - np.angle(x)
        if (d == self.w).all() and frame == 0:
            return self.motion(d, 0)[0, 0], self.sliding[0]
        def size(tau):
            x, x_prime = self.motion(d, tau, frame)
            return abs(x), x * x_prime
        amplitude, tau = largest(size, np.linspace(0, math.pi, self.samples + 1))
        return amplitude, self.sliding[0] + tau + (math.pi if self.motion(d, tau, frame)[0, 0] < 0 else 0)  # (47)

    @cached_property
    def beta_lim_high_frequency(self):  # (86), times what inertia leaves of the load for the contact, over a unit force on it
        pull = np.linalg.solve(self.M, self.w)
        return abs(pull @ self.p) / (pull @ self.w) * 2 / math.hypot(2 * self.mu, math.pi)

    def motion_under_force(self, d, tau):  # tau = 0 at the maximum of the force
        held = self.regime == "permanent_sticking"
        return (d @ self.held[0] * np.exp(1j * tau)).real if held else self.motion(d, tau - self.sliding[0])[0]


def is_matrix(A, N):
    return np.shape(A) == (N, N) and (np.array(A) == np.array(A).T).all()


def broken_rule(scene):
    """What a scene breaks; None where it keeps the rules."""
    N = len(scene.get("mass_matrix") or scene["mass_ratios"])
    contact = scene["contact"] if isinstance(scene["contact"], list) else [scene["contact"]]
    if any(k not in range(1, N + 1) for k in contact) or len(set(contact)) != len(contact):
        return "a contact of one mass or of two that differ, from 1 to N"
    load = scene.get("load", 1)
    if isinstance(load, list) and (len(load) != N or not any(load)):
        return "a force for each mass, one of them not zero"
    if not isinstance(load, list) and load not in range(1, N + 1):
        return "a loaded mass from 1 to N"
    if "load_phases" in scene and (not isinstance(scene.get("load"), list) or len(scene["load_phases"]) != N):
        return "a phase for each force, where load is a list"
    matrices = [scene[name] for name in ("mass_matrix", "stiffness_matrix", "damping_matrix") if name in scene]
    if not all(is_matrix(A, N) for A in matrices):
        return "matrices symmetric, with a row for each mass"
    for name, least in (("mass_matrix", 0), ("stiffness_matrix", 0), ("damping_matrix", -1e-12)):
        if name in scene and np.linalg.eigvalsh(np.array(scene[name], float)).min() <= least:
            return f"{name} positive definite, of damping semidefinite"
    if scene.get("base_motion", "alone") not in ("with_wall", "alone", "wall"):
        return "base_motion with_wall, alone or wall"
    if scene.get("base_motion") == "wall" and len(contact) > 1:
        return "a contact with the wall that moves"
    if scene["mu"] < 1 or scene["r"] <= 0 or scene["beta"] < 0:
        return "mu at least 1, r positive, beta not negative"
    return None
