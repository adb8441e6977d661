#!/usr/bin/env python3
"""An inextensible cable at rest between two points in sheared water, as a boundary value problem (scipy.solve_bvp).

The continuous equations, no chain: with s from the top, t = T/|T| the tangent towards the vehicle, T the tension vector
that the lower part exerts on the upper,

    dx/ds = t,    dT/ds = -f,    f = rho d/2 (C_n |u_n| u_n + C_t |u_t| u_t) + (m g - rho g pi d^2/4) z_down.

Prints the forces that tests/twin/tether/tether_dynamics_test.cc compares with.
"""
import numpy as np
from scipy.integrate import solve_bvp

RHO, G = 1025.0, 9.80665


def load(z, t, d, m, cn, ct, water):
    u = water(z)
    ut = np.sum(u * t, axis=0) * t
    un = u - ut
    f = 0.5 * RHO * d * (cn * np.linalg.norm(un, axis=0) * un + ct * np.linalg.norm(ut, axis=0) * ut)
    f[2] += m * G - RHO * G * np.pi / 4 * d * d
    return f


def cable(top, vehicle, length, d, m, cn, ct, water, guess):
    top, vehicle = np.array(top, float), np.array(vehicle, float)

    def slope(s, y):
        t = y[3:] / np.linalg.norm(y[3:], axis=0)
        return np.vstack([t, -load(y[2], t, d, m, cn, ct, water)])

    def ends(a, b):
        return np.concatenate([a[:3] - top, b[:3] - vehicle])

    s = np.linspace(0, length, 200)
    middle = 0.5 * (top + vehicle) + np.array(guess)
    share = s / length
    # A quadratic curve by way of `middle`, with the tension along it.
    x = np.outer(top, (1 - share) ** 2) + np.outer(2 * middle - 0.5 * (top + vehicle), 2 * share * (1 - share)) + np.outer(vehicle, share**2)
    t = np.gradient(x, s, axis=1)
    found = solve_bvp(slope, ends, s, np.vstack([x, 20 * t]), tol=1e-9, max_nodes=200000)
    assert found.success, found.message
    y = found.sol(np.array([0.0, length / 2, length]))
    print("  on vehicle N ", -y[3:, 2], " on top N ", y[3:, 0])
    print("  tension at top %.6f at vehicle %.6f" % (np.linalg.norm(y[3:, 0]), np.linalg.norm(y[3:, 2])))
    print("  middle of the cable at", y[:3, 1])


print("sheared, turning current; heavy line with tangential drag")
cable([0, 0, 0.5], [15, 10, 40], 55, 0.0076, 0.2, 1.2, 0.01,
      lambda z: np.array([0.8 - 0.01 * z, 0.1 + 0.004 * z, 0 * z]), [15, 3, 5])
print("the Fathom tether, 10 % slack, 0.5 m/s at the surface and 0.2 m/s at 50 m")
cable([0, 0, 0.2], [0, 0, 50.2], 55, 0.0076, 0.043, 1.2, 0.01,
      lambda z: np.array([0.5 - 0.006 * z, 0 * z, 0 * z]), [12, 0, 0])
