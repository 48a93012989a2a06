"""A box on an incline in DART: its acceleration with the law at the load that the steps before let expect (asperity.loads) against
the right one.
"""

import sys
from pathlib import Path

import dartpy

from asperity.loads import PairLoads

sys.path.insert(0, str(Path(__file__).parents[1]))
import incline  # noqa: E402

STEP, STICKY = 1e-3, 1e3


def body(world, name, half_lengths, free, height):
    """A box, and the aspect of its shape that has the friction coefficient."""
    skeleton = dartpy.dynamics.Skeleton(name)
    joint, node = (skeleton.createFreeJointAndBodyNodePair if free else skeleton.createWeldJointAndBodyNodePair)()
    place = dartpy.math.Isometry3()
    place.set_translation([0, 0, height])
    joint.setTransformFromParentBodyNode(place)
    shape = dartpy.dynamics.BoxShape([2 * length for length in half_lengths])
    frame = node.createShapeNode(shape)
    frame.createCollisionAspect()
    frame.createDynamicsAspect()
    inertia = dartpy.dynamics.Inertia()
    inertia.setMass(incline.MASS)
    inertia.setMoment(shape.computeInertia(incline.MASS))
    node.setInertia(inertia)
    world.addSkeleton(skeleton)
    return skeleton, frame.getDynamicsAspect()


def slide(law):
    world = dartpy.simulation.World()
    world.setGravity([incline.DOWNHILL, 0, -incline.NORMAL])
    world.setTimeStep(incline.SHARE * STEP)
    _, floor = body(world, "floor", (50, 5, 1), False, -1)
    box, friction = body(world, "box", incline.HALF_LENGTHS, True, incline.HALF_LENGTHS[2])
    floor.setFrictionCoeff(STICKY)  # of the coefficients of two shapes DART takes the smaller one
    loads, times, speeds = PairLoads(0), [], []
    while world.getTime() < 1:
        load = loads.expected("floor", "box", world.getTime())
        friction.setFrictionCoeff(law.friction_at_load(load) if load > 0 else incline.FIRST_GUESS)
        world.step()
        for contact in world.getLastCollisionResult().getContacts():
            loads.add("floor", "box", abs(contact.force @ contact.normal))
        loads.end_step(world.getTime())
        times.append(world.getTime())
        speeds.append(box.getVelocities()[3])
    return incline.acceleration(times, speeds)


if __name__ == "__main__":
    incline.run("dart", slide, limit=1e-3)
