"""A sled in DART that is pulled over a floor under a load that swings. Friction and normal force are those of its momentum;
their ratio must be the law at that force: taken at the force of the step before, at the one that the steps before let expect
(asperity.loads), and at that of the step itself.
"""

import math
import sys
import time
from pathlib import Path

import dartpy
import numpy as np

import asperity
from asperity.loads import PairLoads

sys.path.insert(0, str(Path(__file__).parents[1]))
import surface  # noqa: E402
import verdict  # noqa: E402

MASS, GRAVITY, AREA = 20.0, 9.81, 1e-4
HALF_LENGTHS = (0.2, 0.1, 0.05)
STEP, END, SETTLED = 1e-3, 2.0, 0.2  # [s]
MEAN_LOAD, SWING, PERIOD = 600.0, 400.0, 2.0  # on top of the sled
PULL = 300.0  # above the greatest friction
FIRST_GUESS, STICKY = 0.3, 1e3
LIMITS = {"lagged": 1e-3, "expected": 1e-5, "current": 1e-8}


def load_on_top(now):
    return MEAN_LOAD - SWING * math.cos(2 * math.pi * now / PERIOD)


def body(world, name, half_lengths, free, height):
    """A box and the aspect of its shape that has the friction coefficient."""
    skeleton = dartpy.dynamics.Skeleton(name)
    create = skeleton.createFreeJointAndBodyNodePair if free else skeleton.createWeldJointAndBodyNodePair
    joint, node = create()
    place = dartpy.math.Isometry3()
    place.set_translation([0, 0, height])
    joint.setTransformFromParentBodyNode(place)
    shape = dartpy.dynamics.BoxShape([2 * length for length in half_lengths])
    frame = node.createShapeNode(shape)
    frame.createCollisionAspect()
    frame.createDynamicsAspect()
    inertia = dartpy.dynamics.Inertia()
    inertia.setMass(MASS)
    inertia.setMoment(shape.computeInertia(MASS))
    node.setInertia(inertia)
    world.addSkeleton(skeleton)
    return skeleton, node, frame.getDynamicsAspect()


class Sled:
    def __init__(self):
        self.world = dartpy.simulation.World()
        self.world.setGravity([0, 0, -GRAVITY])
        self.world.setTimeStep(STEP)
        _, _, floor = body(self.world, "floor", (50, 5, 1), False, -1)
        self.skeleton, self.node, self.friction = body(self.world, "sled", HALF_LENGTHS, True, HALF_LENGTHS[2])
        # Of the coefficients of two shapes DART takes the smaller one.
        floor.setFrictionCoeff(STICKY)

    def step(self, now, coefficient):
        """Makes a step; returns the normal force that DART tells of the pair."""
        self.friction.setFrictionCoeff(coefficient)
        self.node.addExtForce([PULL, 0, -load_on_top(now)], [0, 0, 0], False, True)
        self.world.step()
        return sum(abs(contact.force @ contact.normal) for contact in self.world.getLastCollisionResult().getContacts())

    def forces(self, before, now):
        """Friction and normal force of a step, from the change of momentum."""
        x, _, z = MASS * (self.skeleton.getVelocities()[3:] - before) / STEP
        return PULL - x, z + MASS * GRAVITY + load_on_top(now)

    def settled_step(self, now, law, coefficient):
        """Makes a step again until the coefficient is the law at the force of the step; returns it."""
        positions, velocities = self.skeleton.getPositions(), self.skeleton.getVelocities()
        for _ in range(50):
            load = self.step(now, coefficient)
            found = law.friction_at_load(load) if load > 0 else coefficient
            if abs(found - coefficient) <= 1e-12 * coefficient:
                return coefficient
            coefficient = found
            self.skeleton.setPositions(positions)
            self.skeleton.setVelocities(velocities)
        raise RuntimeError(f"at {now:.3f} s friction and normal force do not settle: take shorter steps")


def slide(law, force):
    """Friction over normal force against the law, largest error once the sled slides; the loads met; seconds of the steps."""
    sled, loads = Sled(), PairLoads(0)
    coefficient, last, error, met = FIRST_GUESS, 0.0, 0.0, []
    start = time.process_time()
    for count in range(round(END / STEP)):
        now = count * STEP
        before = sled.skeleton.getVelocities()[3:]
        if force == "current":
            coefficient = sled.settled_step(now, law, coefficient)
        else:
            load = loads.expected("floor", "sled", now) if force == "expected" else last
            if law and load > 0:
                coefficient = law.friction_at_load(load)
            last = sled.step(now, coefficient)
            loads.add("floor", "sled", last)
            loads.end_step(now)
        friction, load = sled.forces(before, now)
        if now > SETTLED:
            met.append((friction, load))
    seconds = time.process_time() - start
    if law:
        error = np.max([abs(friction / load / law.state_at_load(load).friction_coefficient - 1) for friction, load in met])
    return error, [load for _, load in met], seconds


def main():
    law = asperity.Model(surface.surface(AREA))
    constant = min(slide(None, "lagged")[2] for _ in range(3))
    errors, costs = {}, {}
    for force in LIMITS:
        errors[force], loads, costs[force] = slide(law, force)
        surface.demand(law, min(loads), max(loads))
        print(f"  {force} force: F/N is off by {errors[force]:.1e} at most, under {min(loads):.0f} to {max(loads):.0f} N")
    told = ", ".join(f"at the {force} force x {costs[force] / constant:.2f}" for force in LIMITS)
    print(f"dart  cost  constant mu {1e6 * constant * STEP / END:.0f} us a step; the law {told}")
    good = all(errors[force] <= limit for force, limit in LIMITS.items())
    found = ", ".join(f"{errors[force]:.1e} {force} (limit {limit:.0e})" for force, limit in LIMITS.items())
    return good, f"max |F/N - mu(N)|/mu = {found}"


if __name__ == "__main__":
    verdict.run("dart", main)
