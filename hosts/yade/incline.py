"""A block of four spheres on an incline in YADE, let go above its rest: nothing damps its bounce, and the load swings
between nothing and twice its mean. Its acceleration with the mean of the loads (asperity.loads) against the right one.
"""

from yade import O, utils
from yade.wrapper import (
    Bo1_Sphere_Aabb, Bo1_Wall_Aabb, ForceResetter, FrictMat, Ig2_Sphere_Sphere_ScGeom, Ig2_Wall_Sphere_ScGeom,
    InsertionSortCollider, InteractionLoop, Ip2_FrictMat_FrictMat_FrictPhys, Law2_ScGeom_FrictPhys_CundallStrack,
    NewtonIntegrator, PyRunner,
)

import incline
from asperity.loads import PairLoads

RADIUS, STEP = 0.02, 1e-4
WALL, BLOCK = 0, "block"


def set_friction():
    """Before the interactions of a step."""
    load = loads.expected(WALL, BLOCK, O.time)
    for i in O.interactions:
        if i.isReal:
            i.phys.tangensOfFrictionAngle = law.friction_at_load(load) if load > 0 else incline.FIRST_GUESS


def take_loads():
    """After them."""
    for i in O.interactions:
        if i.isReal:
            loads.add(WALL, BLOCK, i.phys.normalForce.norm())
    loads.end_step(O.time)


def slide(of_surface):
    global law, loads
    law, loads = of_surface, PairLoads(incline.TIME_CONSTANT)
    O.reset()
    O.materials.append(FrictMat(young=1e6, poisson=0.3, frictionAngle=0.3, density=1))
    O.bodies.append(utils.wall(0, axis=2))
    places = [(x, y, RADIUS * (1 - 1e-3)) for x in (-0.1, 0.1) for y in (-0.05, 0.05)]
    clump, members = O.bodies.appendClumped([utils.sphere(place, RADIUS) for place in places])
    block = O.bodies[clump]
    block.state.mass = incline.MASS
    block.state.blockedDOFs = "yXYZ"
    O.engines = [
        ForceResetter(),
        InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Wall_Aabb()]),
        PyRunner(command="set_friction()", iterPeriod=1),
        InteractionLoop([Ig2_Sphere_Sphere_ScGeom(), Ig2_Wall_Sphere_ScGeom()], [Ip2_FrictMat_FrictMat_FrictPhys()],
                        [Law2_ScGeom_FrictPhys_CundallStrack()]),
        PyRunner(command="take_loads()", iterPeriod=1),
        NewtonIntegrator(damping=0, gravity=(incline.DOWNHILL, 0, -incline.NORMAL)),
    ]
    O.dt = incline.SHARE * STEP
    times, speeds = [], []
    while O.time < 1:
        O.step()
        times.append(O.time)
        speeds.append(block.state.vel[0])
    return incline.acceleration(times, speeds)


incline.run("yade", slide)
