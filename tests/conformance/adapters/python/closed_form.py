"""The steady motion of a chain with one Coulomb contact, in closed form: Marino & Cicirello, JSV 535 (2022) 117085.

Numbers in brackets are its equations, with the corrections that the ledger of denhartog lists. Forms other than the paper's
equal them and keep their digits. Modes with zeta >= 1, which the paper leaves out, obey them with w = i w_1: all stays real.
"""
import math
from functools import cached_property
import numpy as np

def natural_modes(gamma, kappa):
    """r_i = omega_i sqrt(m_1/k_1), ascending, and phi with phi^T diag(gamma) phi = 1, (15), (17): psi = phi / r."""
    N = len(gamma)  # K = B^T B with the stretched springs as rows of B: r_i are its singular values, no root of a square
    B = np.sqrt(kappa)[:, None] * (np.eye(N) - np.eye(N, k=-1)) / np.sqrt(gamma)
    _, r_n, rows = np.linalg.svd(B)
    return r_n[::-1], rows[::-1].T / np.sqrt(gamma)[:, None]

def decay(x, zeta):
    """zeta >= 1: rates a = zeta - w_1 and b = zeta + w_1 = 1 / a with w_1 = sqrt(zeta^2 - 1), and q_i at tau = R x."""
    w_1 = math.sqrt(zeta - 1) * math.sqrt(zeta + 1)
    a = 1 / (zeta + w_1)
    return a, zeta + w_1, np.exp(-a * x) * (-np.expm1(-2 * w_1 * x) / (2 * w_1) if w_1 > 0 else x)

def sinhc_less_sinc(x, zeta):
    """sinh(zeta x)/(zeta x) - sin(w x)/(w x) = sum of D_k x^2k/(2k+1)!, D_{k+1} = zeta^2 D_k + (-w^2)^k: nothing cancels."""
    X, Y = (zeta * x) ** 2, (zeta - 1) * x * ((zeta + 1) * x)  # Y = -(w x)^2
    term, power, total = x * x / 6, x * x / 6, 0.0
    for k in range(1, 40):
        total += term
        power *= Y / ((2 * k + 2) * (2 * k + 3))
        term = X * term / ((2 * k + 2) * (2 * k + 3)) + power
    return total

def mode_functions(R, zeta):
    """v_di (23), u_di (28), g_i (29): 1 - R^2 as a product, D = 2 E (cosh delta + cos theta) as a sum of squares."""
    v = 1 / complex((1 - R) * (1 + R), 2 * zeta * R) if zeta > 0 or R != 1 else math.inf
    x, delta, E = math.pi / R, math.pi * zeta / R, math.exp(-math.pi * zeta / R)
    if zeta < 1:
        w = math.sqrt((1 - zeta) * (1 + zeta))
        if zeta < 0.5:  # theta = pi (n + y), n the odd number next to 1 / R; 1 - n R is exact with R in two parts
            n, R_high = 2 * math.floor(1 / R / 2) + 1, float(np.float32(R))
            y = ((1 - n * R_high) - n * (R - R_high) - zeta**2 / (1 + w)) / R
            sin_theta, cos_half_theta = -math.sin(math.pi * y), math.sin(math.pi * y / 2)  # the latter but for its sign
        else:
            sin_theta, cos_half_theta = math.sin(math.pi * w / R), math.cos(math.pi * w / R / 2)
        D = math.expm1(-delta) ** 2 + 4 * E * cos_half_theta**2
        if D == 0:
            return v, math.inf, math.nan  # a mode without damping at R = 1/n
        u = 2 * E * sin_theta / (R * w * D)
    else:
        a, b, q = decay(x, zeta)
        D = (1 + math.exp(-a * x)) * (1 + math.exp(-b * x))
        u = 2 * q / (R * D)
    if max(1, zeta) * x <= 4:
        g = 2 * E * delta * sinhc_less_sinc(x, zeta) / D
    elif zeta < 1:
        g = (-math.expm1(-delta) * (1 + E) - 2 * zeta * E * sin_theta / w) / D
    else:  # sinh delta - zeta S = (sinh delta - sinh w_1 x) - a S with S = sinh(w_1 x)/w_1
        g = math.tanh(a * x / 2) - a * R * u
    return v, u, g

def free_motion(tau, R, zeta, with_d=True):
    """1 - d_i, q_i, R_i q_i' and R_i q_i' - cos tau from (A.8), (A.9), without cancellation for tau -> 0 and R -> infinity."""
    x = tau / R
    if zeta < 1:
        w = math.sqrt((1 - zeta) * (1 + zeta))
        E, C = np.exp(-zeta * x), np.cos(w * x)
        q = E * np.sin(w * x) / w
        Rq_prime, less_d = E * C - zeta * q, 1 - (E * C + zeta * q)
        cosines = -2 * np.sin((w * x + tau) / 2) * np.sin(((1 - R) - zeta**2 / (1 + w)) * x / 2)  # cos(w x) - cos(tau)
        difference = np.expm1(-zeta * x) * C + cosines - zeta * q
    else:
        a, b, q = decay(x, zeta)
        Rq_prime, less_d = np.exp(-b * x) - a * q, -np.expm1(-a * x) - a * q
        difference = np.expm1(-b * x) - a * q + 2 * np.sin(tau / 2) ** 2
    small = max(1, 2 * zeta) * x < 1  # there 1 - d, where it is asked for, by its power series: m'' + 2 zeta m' + m = 1
    before, term, total, damped, square = 0.0, x[small] ** 2 / 2, 0.0, 2 * zeta * x[small], x[small] ** 2
    for k in range(2, 22 if with_d and term.size else 2):
        total, before, term = total + term, term, -(damped * k * term + square * before) / (k * (k + 1))
    less_d[small] = total
    return less_d, q, Rq_prime, difference

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

class ClosedForm:
    def __init__(self, scene):
        self.gamma, self.kappa = np.array(scene["mass_ratios"], float), np.array(scene["stiffness_ratios"], float)  # (9), (73)
        self.j, self.l, self.zeta = scene["contact"] - 1, scene["load"] - 1, np.array(scene["damping_ratios"], float)
        self.mu, self.r, self.beta = float(scene["mu"]), float(scene["r"]), float(scene["beta"])
        self.r_n, self.phi = natural_modes(self.gamma, self.kappa)
        self.R = self.r / self.r_n  # (22)
        self.to_contact = self.phi * self.phi[self.j] / self.r_n**2  # psi_ki psi_ji R_i^2, mass by mode
        self.psi_j_squared = (self.phi[self.j] / self.r) ** 2
        v, self.u, self.g = (np.array(f) for f in zip(*map(mode_functions, self.R.tolist(), self.zeta.tolist())))
        self.V = self.phi * self.phi[self.l] / self.r_n**2 @ v  # (33)
        self.U, self.G = self.to_contact @ self.u, self.to_contact @ self.g  # (34), (35)
        self.H_j = self.psi_j_squared @ (self.g + 2 * self.zeta * self.R * self.u)  # (64)
        self.samples = 64 * min(4096, math.ceil(2 + 1 / self.R.min()))  # the fastest mode turns w / (2 R) times in [0, pi]

    def demand(self, weights):
        """Largest sum of weights times (57) as corrected, 0 < tau < pi, or its limit (71) for tau -> 0; that at pi is less."""
        def at(tau):
            N, N_prime = 0 * tau, 0 * tau  # the sum times sin tau, and its derivative
            for weight, R, zeta, u, g in zip(weights, self.R, self.zeta, self.u, self.g):
                _, q, Rq_prime, difference = free_motion(tau, R, zeta, False)
                N += weight * ((1 + g) * R * q - u * R**2 * difference)
                N_prime += weight * ((1 + g) * Rq_prime + u * R * (2 * zeta * Rq_prime + q) - u * R**2 * np.sin(tau))
            return N / np.sin(tau), N_prime * np.sin(tau) - N * np.cos(tau)
        tau = math.pi * np.arange(1, self.samples) / self.samples
        tau = np.append(np.geomspace(1e-9, tau[0], 200, endpoint=False), tau)  # heavily damped modes are quick at first
        return max(weights @ (1 + self.g + 2 * self.zeta * self.R * self.u), largest(at, tau)[0])

    def S_dj(self):  # (56): the modes' own maxima
        return sum(square * self.demand(unit) for square, unit in zip(self.psi_j_squared, np.eye(len(self.R))))

    def beta_lim(self, S):  # (67), (69)
        return abs(self.V[self.j]) / math.hypot(self.U[self.j], max(S, self.H_j + self.mu / (self.gamma[self.j] * self.r**2)))

    @cached_property
    def held(self):
        """Contact held, (88): X_k in x_k = Re{X_k exp(i tau)}; the least beta that does it; how far from zero it may rest."""
        C_half = self.gamma[:, None] * self.phi * np.sqrt(2 * self.zeta * self.r_n * self.r)  # (19): C = C_half C_half^T
        K = np.diag(self.kappa + np.append(self.kappa[1:], 0)) - np.diag(self.kappa[1:], 1) - np.diag(self.kappa[1:], -1)
        Z = K - self.r**2 * np.diag(self.gamma) + 1j * (C_half @ C_half.T)
        load, others = np.eye(len(K))[self.l], np.arange(len(K)) != self.j
        X = np.zeros(len(K), complex)
        X[others] = np.linalg.solve(Z[np.ix_(others, others)], load[others])
        limit = abs(Z[self.j] @ X - load[self.j]) / self.mu  # more friction bears the springs from the ground to the contact
        return X, limit, self.mu * (self.beta - limit) * np.sum(1 / self.kappa[: self.j + 1])

    @cached_property
    def regime(self):
        limit = self.beta_lim(self.demand(self.psi_j_squared))
        if math.isnan(limit):
            raise ArithmeticError("a mode without damping at its resonance")
        if self.beta < limit:
            return "continuous"
        return "permanent_sticking" if self.beta >= self.held[1] else "stick_slip"

    @cached_property
    def sliding(self):
        """phi_j, (39), and V_dk exp(i phi_j) with (36), (37): V_dj exp(i phi_j) = root - i beta U_dj."""
        if self.regime != "continuous":
            raise ArithmeticError("the contact does not slide throughout")
        V_j, bU = self.V[self.j], self.beta * self.U[self.j]
        root = math.sqrt((abs(V_j) - bU) * (abs(V_j) + bU))
        W = self.V * (complex(root, -bU) / V_j)
        W[self.j] = complex(root, -bU)
        return math.atan2(-bU, root) - np.angle(V_j), W

    def motion(self, k, tau):
        """x_k by (46) as corrected, and its derivative; tau = 0 at the maximum of x_j, x_k(tau + pi) = -x_k(tau)."""
        half, tau = np.divmod(np.atleast_1d(tau), math.pi)
        W = self.sliding[1][k] * np.exp(1j * tau)
        x, x_prime = W.real, -W.imag
        for weight, R, zeta, u, g in zip(self.beta * self.to_contact[k], self.R, self.zeta, self.u, self.g):
            less_d, q, Rq_prime, _ = free_motion(tau, R, zeta)
            x = x + weight * (less_d - g * (1 - less_d) - u * R * q)
            x_prime = x_prime + weight * ((1 + g) * q / R - u * Rq_prime)
        return (1 - 2 * (half % 2)) * np.array([x, x_prime])

    def initial(self, k):  # x_k and x_k' at tau = 0, (44), (45) as corrected; X_j, (38)
        W = self.sliding[1][k]
        return W.real - self.beta * self.G[k], -W.imag - self.beta * self.U[k]

    def amplitude_and_phase(self, k):
        if self.regime == "permanent_sticking":
            return abs(self.held[0][k]), -np.angle(self.held[0][k])
        if k == self.j:
            return self.initial(k)[0], self.sliding[0]
        def size(tau):
            x, x_prime = self.motion(k, tau)
            return abs(x), x * x_prime
        amplitude, tau = largest(size, np.linspace(0, math.pi, self.samples + 1))
        return amplitude, self.sliding[0] + tau + (math.pi if self.motion(k, tau)[0, 0] < 0 else 0)  # (47)

    def motion_under_force(self, k, tau):  # tau = 0 at the maximum of the force
        held = self.regime == "permanent_sticking"
        return (self.held[0][k] * np.exp(1j * tau)).real if held else self.motion(k, tau - self.sliding[0])[0]

def broken_rule(scene, mass, tau, samples):
    """What a question breaks; None where it keeps the rules."""
    ratios = [scene["mass_ratios"], scene["stiffness_ratios"], scene["damping_ratios"]]
    N, point = len(ratios[0]), [scene["mu"], scene["r"], scene["beta"], tau, samples]
    if N == 0 or any(len(values) != N for values in ratios) or not np.isfinite(sum(ratios, point)).all():
        return "finite numbers, as many springs and damping ratios as masses"
    if min(ratios[0] + ratios[1]) <= 0 or min(ratios[2]) < 0 or ratios[0][0] != 1 or ratios[1][0] != 1:
        return "positive ratios, the first of masses and of stiffnesses 1; damping ratios not negative"
    if any(k not in range(1, N + 1) for k in (scene["contact"], scene["load"], mass)):
        return "masses from 1 to N"
    if scene["mu"] < 1 or scene["r"] <= 0 or scene["beta"] < 0 or not 0 <= tau < 2 * math.pi or samples < 1:
        return "mu at least 1, r positive, beta not negative, 0 <= tau < 2 pi, one sample or more"
