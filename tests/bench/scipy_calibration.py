"""The unsteady calibration of one column-day with scipy, for comparison.

scipy_calibration.py PROBLEM.json: reads observations, stress, priors, bounds and start, fits with
scipy.optimize.least_squares (trust region reflective), once with 2-point differences and once with the
analytic Jacobian, and prints {"two_point": {...}, "analytic": {...}} with cost, seconds of processor
time (median of the repeats; the interpreter's start and the imports are not in them) and evaluations, and
beside them the largest relative difference of the two Jacobians at the start.

The model is written anew from its equations (finite depth, linear bottom stress, whole-hour means), not from
the C++: closed forms in cosh and sinh, and the modes' memory of the stress stepped from hour to hour, all
modes at once.
"""
import json
import sys
import time

import numpy as np
from scipy.optimize import least_squares

RHO = 1025.0
FASTEST_1_S = 12.0 / 3600.0


class Steady:
    """Interior and stress response of the finite column, turning at rate g, by ln nu and ln r."""

    def __init__(self, nu, r, g, depth, d):
        lam = np.sqrt(1j * g / nu)
        lam = np.where(lam.real < 0, -lam, lam)
        sig = nu * lam / r
        e = depth - d
        cosh_h, sinh_h = np.cosh(lam * depth), np.sinh(lam * depth)
        q = cosh_h + sig * sinh_h
        cosh_d, sinh_d = np.cosh(lam * d), np.sinh(lam * d)
        self.A = 1 - cosh_d / q
        self.mean = 1 - sinh_h / (lam * depth * q)
        self._state = (nu, lam, sig, e, d, depth, cosh_h, sinh_h, q, cosh_d, sinh_d)

    def stress(self):
        nu, lam, sig, e, d, depth, cosh_h, sinh_h, q, cosh_d, sinh_d = self._state
        self.cosh_e, self.sinh_e = np.cosh(lam * e), np.sinh(lam * e)
        self.B = (self.sinh_e + sig * self.cosh_e) / (RHO * nu * lam * q)
        return self.B

    def derivatives(self):
        """[dA, dmean] by ln nu and by ln r."""
        nu, lam, sig, e, d, depth, cosh_h, sinh_h, q, cosh_d, sinh_d = self._state
        out = []
        for dlam, dsig in ((-0.5 * lam, 0.5 * sig), (0.0, -sig)):
            dq = depth * (sinh_h + sig * cosh_h) * dlam + sinh_h * dsig
            d_a = -d * sinh_d * dlam / q + cosh_d * dq / q**2
            inverse = 1 / (lam * depth * q)
            d_mean = -depth * cosh_h * dlam * inverse + sinh_h * inverse * (dlam / lam + dq / q)
            out.append((d_a, d_mean))
        return out

    def stress_derivatives(self):
        nu, lam, sig, e, d, depth, cosh_h, sinh_h, q, cosh_d, sinh_d = self._state
        out = []
        for dlam, dsig, dnu in ((-0.5 * lam, 0.5 * sig, 1.0), (0.0, -sig, 0.0)):
            dq = depth * (sinh_h + sig * cosh_h) * dlam + sinh_h * dsig
            dn = e * (self.cosh_e + sig * self.sinh_e) * dlam + self.cosh_e * dsig
            out.append(dn / (RHO * nu * lam * q) - self.B * (dnu + dlam / lam + dq / q))
        return out


class Day:
    """Parameters: interior 2, ln nu, ln r, ln factor, trend 2, inertial 2."""

    def __init__(self, p):
        self.f = p["coriolis_rad_s"]
        self.depth = p["water_depth_m"]
        self.d = np.array(p["depth_m"])
        self.start_h = np.array(p["cell_start_h"])
        self.end_h = np.array(p["cell_end_h"])
        self.stress = np.array(p["stress_east_pa"]) + 1j * np.array(p["stress_north_pa"])
        hourly = np.array(p["hourly_east_pa"]) + 1j * np.array(p["hourly_north_pa"])
        self.slope = np.diff(hourly)
        self.first = np.rint(self.start_h - p["hourly_first_h"]).astype(int)
        self.last = np.rint(self.end_h - p["hourly_first_h"]).astype(int)
        self.change = hourly[self.last] - hourly[self.first]
        self.width_h = self.end_h - self.start_h
        centre_h = 0.5 * (self.start_h + self.end_h)
        self.day_part = (centre_h - 12.0) / 24.0
        self.obs = np.array(p["east_m_s"]) + 1j * np.array(p["north_m_s"])
        self.sigma = p["sigma_m_s"]
        self.prior = np.array(p["prior"])
        self.prior_sigma = np.array(p["prior_sigma"])

    def modes(self, nu, r):
        """Roots of x tan x = r H/nu up to the fastest mode that is followed; Newton on all at once."""
        b = r * self.depth / nu
        most = int(self.depth / np.pi * np.sqrt(FASTEST_1_S / nu)) + 2
        low = np.pi * np.arange(most)
        x = low + np.arctan(b / (low + 0.8))
        x[0] = 0.5 * np.pi * np.sqrt(b / (b + 0.25 * np.pi**2))
        for _ in range(20):
            s, c = np.sin(x), np.cos(x)
            step = (x * s - b * c) / (s + x * c + b * s)
            x = x - step
            if np.max(np.abs(step)) < 1e-14 * x[-1]:
                break
        keep = nu * (x / self.depth) ** 2 <= FASTEST_1_S
        keep[0] = True
        return x[keep], b

    def memory(self, lam_h, derivative):
        """m and dm/dlambda averaged over each cell; lambda per hour. Shapes times x modes."""
        decay = np.exp(-lam_h)
        settled = (1 - decay) / lam_h
        knots = np.zeros((len(self.slope) + 1, len(lam_h)), complex)
        for i, g in enumerate(self.slope):
            knots[i + 1] = decay * knots[i] + g * settled
        m = (knots[self.first] - knots[self.last] + self.change[:, None]) / lam_h
        if not derivative:
            return m / self.width_h[:, None], None
        by = np.zeros_like(knots)
        settled_by = (decay - settled) / lam_h
        for i, g in enumerate(self.slope):
            by[i + 1] = decay * (by[i] - knots[i]) + g * settled_by
        m_by = (by[self.first] - by[self.last] - m) / lam_h
        return m / self.width_h[:, None], m_by / self.width_h[:, None]

    def evaluate(self, p, derivative):
        nu, r, factor = np.exp(p[2]), np.exp(p[3]), np.exp(p[4])
        steady = Steady(nu, r, self.f, self.depth, self.d)
        b_steady = steady.stress()
        x, b = self.modes(nu, r)
        k = x / self.depth
        lam = nu * k**2 + 1j * self.f
        norm = 0.5 * self.depth * (1 + np.sin(2 * x) / (2 * x))
        scale = 1 / (RHO * norm * lam)
        phi = np.cos(k[:, None] * self.d)
        m, m_by = self.memory(3600 * lam, derivative)
        wind = factor * (np.outer(self.stress, b_steady) - (m * scale) @ phi)
        t0, t1 = 3600 * self.start_h, 3600 * self.end_h
        fade0, fade1 = np.exp(-lam[0] * t0), np.exp(-lam[0] * t1)
        width = lam[0] * (t1 - t0)
        fade = (fade0 - fade1) / width
        flow = complex(p[0], p[1]) + self.day_part * complex(p[5], p[6])
        inertial = complex(p[7], p[8])
        model = wind + np.outer(flow, steady.A) + inertial * np.outer(fade, phi[0])
        if not derivative:
            return model, None
        jac = np.empty((len(p),) + model.shape, complex)
        jac[0] = steady.A
        jac[4] = wind
        jac[5] = np.outer(self.day_part, steady.A)
        jac[7] = np.outer(fade, phi[0])
        for i in (0, 5, 7):
            jac[i + 1] = 1j * jac[i]
        fade_by = (-t0 * fade0 + t1 * fade1) / width - fade / lam[0]
        s, c = np.sin(x), np.cos(x)
        x_by_b = c / (s + x * c + b * s)
        norm_by_x = 0.5 * self.depth * (np.cos(2 * x) / x - np.sin(2 * x) / (2 * x**2))
        by_a, by_b = steady.derivatives(), steady.stress_derivatives()
        for j, (db, own) in enumerate(((-b, 1.0), (b, 0.0))):
            dx = x_by_b * db
            dk = dx / self.depth
            dlam = nu * k**2 * own + 2 * nu * k * dk
            dscale = -scale * (norm_by_x * dx / norm + dlam / lam)
            dphi = -np.sin(k[:, None] * self.d) * self.d * dk[:, None]
            dtime = m * dscale + m_by * (3600 * dlam * scale)
            jac[2 + j] = (factor * (np.outer(self.stress, by_b[j]) - dtime @ phi - (m * scale) @ dphi)
                          + np.outer(flow, by_a[j][0])
                          + inertial * (np.outer(fade_by * dlam[0], phi[0]) + np.outer(fade, dphi[0])))
        return model, jac

    def residuals(self, p):
        miss = (self.evaluate(p, False)[0].ravel() - self.obs) / self.sigma
        return np.concatenate([miss.real, miss.imag, (p - self.prior) / self.prior_sigma])

    def jacobian(self, p):
        jac = self.evaluate(p, True)[1].reshape(len(p), -1).T / self.sigma
        return np.vstack([jac.real, jac.imag, np.diag(1 / self.prior_sigma)])


def timed(day, jac, problem, repeats):
    bounds = (np.array(problem["lower"]), np.array(problem["upper"]))
    start = np.array(problem["start"])
    seconds = []
    for _ in range(repeats):
        begin = time.process_time()
        fit = least_squares(day.residuals, start, jac=jac, bounds=bounds, method="trf", x_scale="jac",
                            ftol=1e-9, xtol=1e-8, gtol=1e-9)
        seconds.append(time.process_time() - begin)
    return {"cost": float(fit.cost), "seconds": float(np.median(seconds)), "nfev": int(fit.nfev),
            "success": bool(fit.success), "estimate": fit.x.tolist()}


def main():
    with open(sys.argv[1]) as f:
        problem = json.load(f)
    day = Day(problem)
    start = np.array(problem["start"])
    step = 1e-6
    exact = day.jacobian(start)
    central = np.array([(day.residuals(start + step * e) - day.residuals(start - step * e)) / (2 * step)
                        for e in np.eye(len(start))]).T
    error = np.max(np.abs(exact - central).max(axis=0) / np.abs(exact).max(axis=0))
    day.residuals(start)  # warm
    print(json.dumps({"start_cost": 0.5 * float(np.sum(day.residuals(start) ** 2)),
                      "jacobian_error": float(error),
                      "analytic": timed(day, day.jacobian, problem, problem["repeats"]),
                      "two_point": timed(day, "2-point", problem, problem["repeats"])}))


if __name__ == "__main__":
    main()
