"""A sled in Drake that is pulled over a floor under a load that swings, on two surfaces. Friction and normal force are those of its
momentum; their ratio is the law at the load that the steps before let expect (asperity.loads). SI units.
"""

import math
import sys
from pathlib import Path

import numpy as np
from pydrake.all import (
    AddMultibodyPlantSceneGraph, Box, ContactModel, CoulombFriction, DiagramBuilder, ExternallyAppliedSpatialForce,
    ProximityProperties, RigidTransform, RoleAssign, Simulator, SpatialForce, SpatialInertia, Sphere,
)  # fmt: skip

import asperity
from asperity.loads import PairLoads

sys.path.insert(0, str(Path(__file__).parents[1]))
import surface  # noqa: E402
import verdict  # noqa: E402

MASS, GRAVITY, STEP, LIMIT = 10.0, 9.81, 1e-3, 0.01
FLOOR = 1.0  # the floor's coefficient: Drake takes 2 mu1 mu2/(mu1 + mu2) of two geometries


def coefficient(mu):
    """The coefficient of a foot that has mu on the floor."""
    other = mu * FLOOR / (2 * FLOOR - mu)
    return CoulombFriction(other, other)


def slide(law, mean_load, swing, end=1.5, first_guess=0.3):
    """The largest error of friction over normal force against the law, after 0.2 s, and the loads met."""
    builder = DiagramBuilder()
    plant, scene = AddMultibodyPlantSceneGraph(builder, STEP)
    plant.set_contact_model(ContactModel.kPoint)
    sled = plant.AddRigidBody("sled", SpatialInertia.SolidBoxWithMass(MASS, 0.4, 0.2, 0.1))
    feet = [
        plant.RegisterCollisionGeometry(sled, RigidTransform([x, y, -0.04]), Sphere(0.01), f"foot {x} {y}", coefficient(first_guess))
        for x in (-0.2, 0.2) for y in (-0.1, 0.1)
    ]  # fmt: skip
    plant.RegisterCollisionGeometry(
        plant.world_body(), RigidTransform([0, 0, -1]), Box(100, 10, 2), "floor", CoulombFriction(FLOOR, FLOOR)
    )
    plant.Finalize()
    diagram = builder.Build()
    simulator = Simulator(diagram)
    context = plant.GetMyMutableContextFromRoot(simulator.get_mutable_context())
    geometry = scene.GetMyMutableContextFromRoot(simulator.get_mutable_context())
    plant.SetFreeBodyPose(context, sled, RigidTransform([0, 0, 0.05]))
    loads, error, met = PairLoads(0), 0.0, []
    for count in range(round(end / STEP)):
        now = count * STEP
        expected = loads.expected("sled", "floor", now)
        if expected > 0:  # per foot the same mu: the law is that of the sled's load
            for foot in feet:
                properties = ProximityProperties(scene.model_inspector().GetProximityProperties(foot))
                properties.UpdateProperty("material", "coulomb_friction", coefficient(law.friction_at_load(expected)))
                scene.AssignRole(geometry, plant.get_source_id(), foot, properties, RoleAssign.kReplace)
        on_top, pull = mean_load - swing * math.cos(2 * math.pi * now) - MASS * GRAVITY, 0.7 * mean_load
        force = ExternallyAppliedSpatialForce()
        force.body_index, force.p_BoBq_B = sled.index(), [0, 0, -0.05]
        force.F_Bq_W = SpatialForce([0, 0, 0], [pull, 0, -on_top])
        plant.get_applied_spatial_force_input_port().FixValue(context, [force])
        before = sled.EvalSpatialVelocityInWorld(context).translational()
        simulator.AdvanceTo(now + STEP / 2)  # one step: Drake makes it at its beginning
        x, _, z = MASS * (sled.EvalSpatialVelocityInWorld(context).translational() - before) / STEP
        results = plant.get_contact_results_output_port().Eval(context)
        points = range(results.num_point_pair_contacts())
        loads.add("sled", "floor", sum(abs(results.point_pair_contact_info(i).contact_force()[2]) for i in points))
        loads.end_step(now)
        if now > 0.2:
            load = z + MASS * GRAVITY + on_top
            met.append(load)
            error = np.maximum(error, abs((pull - x) / load / law.state_at_load(load).friction_coefficient - 1))
    return error, min(met), max(met)


def main():
    carbon = surface.surface(1e-4)
    worst = 0.0
    for params, mean_load, swing in ((carbon, 490, 400), (carbon, 200, 50), (carbon.replace(work_of_adhesion=0.02), 490, 400)):
        law = asperity.Model(params)
        error, lightest, heaviest = slide(law, mean_load, swing)
        surface.demand(law, lightest, heaviest)
        print(f"  {lightest:.0f} to {heaviest:.0f} N, {params.work_of_adhesion} J/m2: F/N is off by {error:.1e} at most")
        worst = np.maximum(worst, error)
    return worst <= LIMIT, f"max |F/N - mu(N)|/mu = {worst:.1e} (limit {LIMIT:g})"


if __name__ == "__main__":
    verdict.run("drake", main)
