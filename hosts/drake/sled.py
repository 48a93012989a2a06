"""Sleds in Drake that are pulled over a floor under a load that swings. Friction and normal force are those of their momentum; their
ratio is the law at the load that the steps before let expect (asperity.loads). Each input is changed once. SI units.
"""

import math
import sys
from pathlib import Path

import numpy as np
from pydrake.all import (
    AddMultibodyPlantSceneGraph, Box, ContactModel, CoulombFriction, DiagramBuilder, DiscreteContactApproximation,
    ExternallyAppliedSpatialForce, HalfSpace, ProximityProperties, RigidTransform, RoleAssign, Simulator, SpatialForce, SpatialInertia, Sphere,
)  # fmt: skip

import asperity
from asperity.loads import PairLoads

sys.path.insert(0, str(Path(__file__).parents[1]))
import habits  # noqa: E402
import surface  # noqa: E402
import verdict  # noqa: E402

GRAVITY, LIMIT, LAGGED_LIMIT = 9.81, 1e-3, 0.01
HABITS = {
    "another load": dict(mean_load=200, swing=50), "a heavy load": dict(mean_load=4900, swing=1000), "a constant load": dict(swing=0),
    "another surface": dict(change=dict(work_of_adhesion=0.02)), "calibrated": dict(measured=(490, 0.25)),
    "a step of 0.5 ms": dict(step=5e-4), "a step of 5 ms": dict(step=5e-3), "a sled of 1 kg": dict(mass=1.0), "a sled of 40 kg": dict(mass=40.0),
    "a floor of 0.4": dict(floor=0.4), "a half space": dict(half_space=True), "pulled the other way": dict(pull=-0.7),
    "another first guess": dict(first_guess=0.05), "two sleds": dict(sleds=2), "contact by pressure": dict(model=ContactModel.kHydroelasticWithFallback),
    "no step": dict(step=0.0, refused="is_discrete"),
}  # fmt: skip
# Drake's other approximations of contact: "lagged" rubs with the normal force of the step before, and with SAP what slides fast hops.
OTHERS = {
    "lagged": dict(approximation="kLagged"), "SAP": dict(approximation="kSap", swing=200, time_constant=0.05, pull=0.3),
    "similar": dict(approximation="kSimilar", swing=200, time_constant=0.05, pull=0.3),
}  # fmt: skip


def coefficient(mu, floor):
    """The coefficient of a foot that has mu on the floor: Drake takes 2 mu1 mu2/(mu1 + mu2) of two geometries."""
    other = mu * floor / (2 * floor - mu)
    return CoulombFriction(other, other)


def slide(mean_load=490, swing=400, pull=0.7, mass=10.0, step=1e-3, floor=1.0, half_space=False, approximation="kTamsi", sleds=1,
          model=ContactModel.kPoint, time_constant=0, first_guess=0.3, change=None, measured=None, end=1.2):  # fmt: skip
    """The largest error of friction over normal force against the law, after 0.2 s; where bodies hop, so that loads are taken as means
    over `time_constant`, that of the impulse of friction."""
    params = surface.surface(1e-4).replace(**change or {})
    law = asperity.Model(params.calibrated(*measured) if measured else params)
    builder = DiagramBuilder()
    plant, scene = AddMultibodyPlantSceneGraph(builder, step)
    plant.set_contact_model(model)
    plant.set_discrete_contact_approximation(getattr(DiscreteContactApproximation, approximation))
    bodies = [plant.AddRigidBody(f"sled {k}", SpatialInertia.SolidBoxWithMass(mass / (1 + k), 0.4, 0.2, 0.1)) for k in range(sleds)]
    feet = {
        body.index(): [
            plant.RegisterCollisionGeometry(body, RigidTransform([x, y, -0.04]), Sphere(0.01), f"foot {x} {y}", coefficient(first_guess, floor))
            for x in (-0.2, 0.2) for y in (-0.1, 0.1)
        ] for body in bodies
    }  # fmt: skip
    place, shape = (RigidTransform(), HalfSpace()) if half_space else (RigidTransform([0, 0, -1]), Box(1000, 10, 2))
    plant.RegisterCollisionGeometry(plant.world_body(), place, shape, "floor", CoulombFriction(floor, floor))
    plant.Finalize()
    diagram = builder.Build()
    simulator = Simulator(diagram)
    context = plant.GetMyMutableContextFromRoot(simulator.get_mutable_context())
    geometry = scene.GetMyMutableContextFromRoot(simulator.get_mutable_context())
    for number, body in enumerate(bodies):
        plant.SetFreeBodyPose(context, body, RigidTransform([0, number, 0.05]))
    loads, error, met, impulses = PairLoads(time_constant), 0.0, [], np.zeros(2)
    for count in range(round(end / step)):
        now = count * step
        for body in bodies:
            expected = loads.expected(body.index(), "floor", now)
            for foot in feet[body.index()] if expected > 0 else ():  # per foot the same mu: the law is that of the sled's load
                properties = ProximityProperties(scene.model_inspector().GetProximityProperties(foot))
                properties.UpdateProperty("material", "coulomb_friction", coefficient(law.friction_at_load(expected), floor))
                scene.AssignRole(geometry, plant.get_source_id(), foot, properties, RoleAssign.kReplace)
        on_floor, forces = mean_load - swing * math.cos(2 * math.pi * now), []
        for number, body in enumerate(bodies):  # the second is half the first
            force = ExternallyAppliedSpatialForce()
            force.body_index, force.p_BoBq_B = body.index(), [0, 0, -0.05]
            force.F_Bq_W = SpatialForce([0, 0, 0], np.array([pull * mean_load, 0, mass * GRAVITY - on_floor]) / (1 + number))
            forces.append(force)
        plant.get_applied_spatial_force_input_port().FixValue(context, forces)
        before = [body.EvalSpatialVelocityInWorld(context).translational() for body in bodies]
        simulator.AdvanceTo(now + step / 2)  # one step: Drake makes it at its beginning
        results = plant.get_contact_results_output_port().Eval(context)
        for point in map(results.point_pair_contact_info, range(results.num_point_pair_contacts())):
            loads.add(max(point.bodyA_index(), point.bodyB_index()), "floor", abs(point.contact_force()[2]))
        loads.end_step(now)
        for number, body in enumerate(bodies) if now > 0.2 else ():
            x, _, z = mass / (1 + number) * (body.EvalSpatialVelocityInWorld(context).translational() - before[number]) / step
            load, friction = z + on_floor / (1 + number), (pull * mean_load / (1 + number) - x) * math.copysign(1, pull)
            impulses += friction, law.friction_force_at_load(on_floor / (1 + number))
            met.append(on_floor / (1 + number) if time_constant else load)
            if not time_constant:
                error = np.maximum(error, abs(friction / load / law.state_at_load(load).friction_coefficient - 1))
    surface.demand(law, min(met), max(met))
    return error if not time_constant else impulses[0] / impulses[1] - 1


def main():
    (worst,), lagged = habits.worst(HABITS, slide), 0.0
    for name, change in OTHERS.items():
        lagged = np.maximum(lagged, abs(found := slide(**change)))
        print(f"  {name}: {found:.1e}")
    print(f"  SAP, pulled faster: {slide(**OTHERS['SAP'] | dict(pull=0.5)):.1e}; lagged, 5 ms: {slide(step=5e-3, **OTHERS['lagged']):.1e}")
    return worst <= LIMIT and lagged <= LAGGED_LIMIT, (
        f"max |F/N - mu(N)|/mu = {worst:.1e} (limit {LIMIT:g}), {len(HABITS)} habits; other approximations of contact {lagged:.1e} (limit {LAGGED_LIMIT:g})"
    )


if __name__ == "__main__":
    verdict.run("drake", main)
