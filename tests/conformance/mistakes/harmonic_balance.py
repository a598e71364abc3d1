"""Harmonic balance of the sliding motion with friction cut off after some harmonics. Usage: harmonic_balance.py HIGHEST.

Friction is a square wave that changes sign where the contact turns; its harmonics act on the dynamic stiffness matrix. The phase
of the square wave is found so that the contact turns where friction does.
"""
import cmath
import json
import math
import sys

import numpy as np


class Balance:
    def __init__(self, scene, highest):
        gamma, kappa = np.array(scene["mass_ratios"], float), np.array(scene["stiffness_ratios"], float)
        N, r, j = len(gamma), scene["r"], scene["contact"] - 1
        K = np.diag(kappa + np.append(kappa[1:], 0)) - np.diag(kappa[1:], 1) - np.diag(kappa[1:], -1)
        root = np.sqrt(gamma)
        squares, shapes = np.linalg.eigh(K / np.outer(root, root))
        C = (shapes * (2 * np.array(scene["damping_ratios"]) * np.sqrt(squares))) @ shapes.T * np.outer(root, root)
        load, contact = np.eye(N)[scene["load"] - 1], np.eye(N)[j]
        stiffness = lambda n: K - (n * r) ** 2 * np.diag(gamma) + 1j * n * r * C
        self.orders = np.arange(1, highest + 1, 2)
        self.linear = np.linalg.solve(stiffness(1), load)
        # tau = 0 where the contact turns down: friction is then beta (4 / pi) (sin tau + sin 3 tau / 3 + ...)
        self.friction = [4 * scene["beta"] / (math.pi * n) * -1j * np.linalg.solve(stiffness(n), contact) for n in self.orders]
        push = sum((1j * n * X[j]).real for n, X in zip(self.orders, self.friction))
        # velocity of the contact at tau = 0: Re{i V exp(i phi)} + push = 0
        V = self.linear[j]
        if abs(push) > abs(V):
            raise ArithmeticError("no turning point")
        self.phi = math.asin(push / abs(V)) - cmath.phase(V)

    def at(self, k, tau):
        x = (self.linear[k] * np.exp(1j * (tau + self.phi))).real
        return x + sum((X[k] * np.exp(1j * n * tau)).real for n, X in zip(self.orders, self.friction))


def answer(q, highest):
    balance, k = Balance(q["scene"], highest), q["mass"] - 1
    if q["quantity"] == "displacement":
        return balance.at(k, q["tau"])
    if q["quantity"] == "initial_displacement":
        return balance.at(k, 0.0)
    if q["quantity"] == "motion_under_force":
        return balance.at(k, 2 * math.pi * np.arange(q["samples"]) / q["samples"] - balance.phi).tolist()
    tau = math.pi * np.arange(20000) / 20000
    x = balance.at(k, tau)
    n = int(np.argmax(abs(x))) if k != q["scene"]["contact"] - 1 else 0
    return abs(x[n]) if q["quantity"] == "amplitude" else math.remainder(
        balance.phi + tau[n] + (math.pi if x[n] < 0 else 0), 2 * math.pi)


ANSWERED = ("amplitude", "phase", "displacement", "initial_displacement", "motion_under_force")
for line in sys.stdin:
    if line.startswith("denhartog-conform"):
        print("denhartog-conform 1 json harmonic balance up to harmonic", sys.argv[1], flush=True)
        continue
    question = json.loads(line)
    reply = {"skip": "no quantity of a sliding motion"}
    if question["quantity"] in ANSWERED:
        try:
            reply = {"value": answer(question, int(sys.argv[1]))}
        except ArithmeticError as reason:
            reply = {"skip": str(reason)}
    print(json.dumps({"id": question["id"], **reply}), flush=True)
