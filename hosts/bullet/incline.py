"""A box on an incline in Bullet. As contact points are replaced, the load that it tells jitters from step to step. Its
acceleration with the mean of the loads (asperity.loads) against the right one, and with the load of the step before.
"""

import sys
from pathlib import Path

import pybullet

from asperity.loads import PairLoads

sys.path.insert(0, str(Path(__file__).parents[1]))
import incline  # noqa: E402

STEP = 1 / 240  # [s], PyBullet's default
MEAN = 10  # steps over which the mean of the loads is taken


def bodies():
    pybullet.resetSimulation()
    pybullet.setTimeStep(incline.SHARE * STEP)
    pybullet.setGravity(incline.DOWNHILL, 0, -incline.NORMAL)
    floor = pybullet.createCollisionShape(pybullet.GEOM_BOX, halfExtents=[50, 10, 1])
    shape = pybullet.createCollisionShape(pybullet.GEOM_BOX, halfExtents=incline.HALF_LENGTHS)
    plane = pybullet.createMultiBody(0, floor, basePosition=[0, 0, -1])
    box = pybullet.createMultiBody(incline.MASS, shape, basePosition=[0, 0, incline.HALF_LENGTHS[2]])
    # Bullet multiplies the coefficients of two bodies: 1 for one leaves that of the other.
    pybullet.changeDynamics(plane, -1, lateralFriction=1, restitution=0)
    pybullet.changeDynamics(box, -1, lateralFriction=incline.FIRST_GUESS, restitution=0)
    pybullet.changeDynamics(box, -1, linearDamping=0, angularDamping=0)
    return plane, box


def slide(law, time_constant):
    """The acceleration; without a time constant at the load of the step before."""
    plane, box = bodies()
    loads = PairLoads(time_constant or 0)
    last, now, times, speeds = 0.0, 0.0, [], []
    while now < 3:
        load = last if time_constant is None else loads.expected(plane, box, now)
        if load > 0:
            pybullet.changeDynamics(box, -1, lateralFriction=law.friction_at_load(load))
        pybullet.stepSimulation()
        for point in pybullet.getContactPoints(plane, box):
            loads.add(plane, box, point[9])
        last = sum(point[9] for point in pybullet.getContactPoints(plane, box))
        loads.end_step(now)
        now += incline.SHARE * STEP
        times.append(now)
        speeds.append(pybullet.getBaseVelocity(box)[0][0])
    return incline.acceleration(times, speeds)


if __name__ == "__main__":
    pybullet.connect(pybullet.DIRECT)
    incline.run("bullet", lambda law: slide(law, MEAN * incline.SHARE * STEP), lagged=lambda law: slide(law, None), limit=0.01, share=4)
