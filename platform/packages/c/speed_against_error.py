#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Speed against error: a box that swings on a hinge, stepped at more and more steps a second, beside the exact motion. Python is all that is needed.

    python3 speed_against_error.py <library ingot_c>

The exact motion is that of theta'' = -k sin theta, k = m g d / I, with I about the hinge: here by Runge-Kutta of order 4 in Python, a thousand times
finer than the eye. Prints, for each rate, the error of the angle after two seconds, by which power of the step it fell, and what a step takes.
"""
import math
import pathlib
import sys
import time

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import ingot  # noqa: E402

g, half, density, arm, begin, seconds = 9.81, 0.25, 500.0, 1.0, 1.0, 2.0  # m s^-2, m, kg/m^3, m from the hinge to the middle, rad, s
mass = density * (2 * half) ** 3
inertia = mass * (2 * half) ** 2 / 6 + mass * arm ** 2  # of a cube, about the hinge
k = mass * g * arm / inertia


def exact(steps=20000):
    h, angle, rate = seconds / steps, begin, 0.0
    for _ in range(steps):
        a1, r1 = rate, -k * math.sin(angle)
        a2, r2 = rate + h / 2 * r1, -k * math.sin(angle + h / 2 * a1)
        a3, r3 = rate + h / 2 * r2, -k * math.sin(angle + h / 2 * a2)
        a4, r4 = rate + h * r3, -k * math.sin(angle + h * a3)
        angle, rate = angle + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4), rate + h / 6 * (r1 + 2 * r2 + 2 * r3 + r4)
    return angle


def swung(lib, rate):
    """Returns: the angle after two seconds, and what a step took, in microseconds."""
    world = ingot.World(lib, ingot.SMALL, gravity=(0, 0, -g))
    cos, sin = math.cos(begin), math.sin(begin)  # the box hangs at an angle about y, and is turned by it
    box = world.add(shape=ingot.BOX, size=(half,) * 3, density=density, r=(-arm * sin, 0, -arm * cos), A=(cos, 0, -sin, 0, 1, 0, sin, 0, cos))
    world.add_joint(kind=ingot.HINGE, B=box, axis=(0, 1, 0))
    before = time.perf_counter()
    for _ in range(round(seconds * rate)):
        world.step(1 / rate)
    spent = time.perf_counter() - before
    r = world.state(box).r
    return math.atan2(-r[0], -r[2]), spent / (seconds * rate) * 1e6


def main():
    lib, truth, last = ingot.load(sys.argv[1]), exact(), None
    print("steps/s  error, rad  order  us/step")
    for rate in (30, 60, 120, 240, 480, 960):
        angle, spent = swung(lib, rate)
        error = abs(angle - truth)
        order = "" if last is None else "%5.1f" % math.log2(last / error)
        print("%7d  %10.1e  %5s  %7.1f" % (rate, error, order, spent))
        last = error


if __name__ == "__main__":
    main()
