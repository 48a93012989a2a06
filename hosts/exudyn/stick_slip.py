"""Stick-slip in Exudyn: a mass on a belt, pressed by a load that varies, with the friction of the law inside Newton's
iterations. The normal force is that of a contact spring, so it belongs to the state that Newton asks for. SciPy solves
the same equations, with friction from the exact integrals, for comparison. In a second run the mass is pushed too weakly to
slide, on a bristle with the stick stiffness of the law. SI units.
"""

import math
import sys
import time
from pathlib import Path

import asperity
import exudyn
import numpy as np
from exudyn.itemInterface import (
    CartesianSpringDamper, Force, MarkerBodyPosition, MassPoint, NodePoint, ObjectGenericODE2, ObjectGround, SensorNode,
)
from scipy.integrate import solve_ivp

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
import surface  # of hosts/
import verdict

LIMIT = 1e-4
END = 0.4
STEP, COARSE_STEP = 5e-5, 2e-4  # to compare with SciPy; as one would take it, to count iterations with
MASS, SPRING = 0.1, 2000.0
CONTACT_STIFFNESS, CONTACT_DAMPING = 1e5, 60.0
BELT_SPEED, SLIP_SCALE = 0.02, 0.002  # the sign of the slip rate v is tanh(v/SLIP_SCALE)
MEAN_LOAD, SWING, FREQUENCY = 10.0, 0.6, 8.0
AT_REST = [0.0, -MEAN_LOAD / CONTACT_STIFFNESS]


def coated_pads():
    """Hard carbon on hard carbon, 1 mm2."""
    return asperity.Model(surface.surface(nominal_area=1e-6))


def pressing_load(t):
    return MEAN_LOAD * (1 + SWING * math.sin(2 * math.pi * FREQUENCY * t))


def normal_force(y, y_rate):
    """Of the belt on the mass; 0 where they are apart: this contact does not pull."""
    return max(0.0, -CONTACT_STIFFNESS * y - CONTACT_DAMPING * y_rate)


class BeltContact:
    """What Exudyn calls, within Newton's iterations, for the forces between mass and belt; counts the calls."""

    def __init__(self, friction, friction_and_slope):
        self.friction, self.friction_and_slope = friction, friction_and_slope
        self.calls = 0

    def spring_force(self, mbs, t, item, displacement, velocity, stiffness, damping, offset):
        """springForceUserFunction: the force that resists displacement and velocity."""
        self.calls += 1
        load = normal_force(displacement[1], velocity[1])
        if load == 0:  # adhesion would give friction at zero load, but a gap has none
            return [0.0, 0.0, 0.0]
        friction = self.friction(load) * math.tanh((velocity[0] - BELT_SPEED) / SLIP_SCALE)
        return [friction, -load, 0.0]

    def force(self, mbs, t, item, q, q_rate):
        """forceUserFunction: the same on the right-hand side."""
        return [-f for f in self.spring_force(mbs, t, item, q, q_rate, None, None, None)]

    def jacobian(self, mbs, t, item, q, q_rate, factor, factor_rate):
        """jacobianUserFunction: factor d(spring force)/dq + factor_rate d(spring force)/dq_rate."""
        self.calls += 1
        load = normal_force(q[1], q_rate[1])
        matrix = np.zeros((3, 3))
        if load == 0:
            return matrix
        friction, slope = self.friction_and_slope(load)
        sign = math.tanh((q_rate[0] - BELT_SPEED) / SLIP_SCALE)
        load_by_y = -(factor * CONTACT_STIFFNESS + factor_rate * CONTACT_DAMPING)
        matrix[0, 0] = factor_rate * friction * (1 - sign * sign) / SLIP_SCALE
        matrix[0, 1] = slope * sign * load_by_y
        matrix[1, 1] = -load_by_y
        return matrix


class Bristle:
    """What Exudyn calls for a contact that sticks: a tangential spring with the stick stiffness at the load. It has to come
    with its Jacobian: differences would be taken over more than the nanometre that it can move. The load must not change
    much, since the force is that of all the displacement."""

    def __init__(self, model):
        self.model = model

    def force(self, mbs, t, item, q, q_rate):
        load = normal_force(q[1], q_rate[1])
        tangential = self.model.tangential_stiffness_at_load(load) * q[0]
        if abs(tangential) > self.model.friction_force_at_load(load):
            raise RuntimeError("a contact that should stick slips")
        return [-tangential, load, 0.0]

    def jacobian(self, mbs, t, item, q, q_rate, factor, factor_rate):
        load = normal_force(q[1], q_rate[1])
        return np.diag([
            factor * self.model.tangential_stiffness_at_load(load),
            factor * CONTACT_STIFFNESS + factor_rate * CONTACT_DAMPING,
            0.0,
        ])


def hold(model):
    """Largest error, relative to the mean, of the displacement of a mass that is pushed with a third of its friction:
    x = push/K (1 - cos(t (K/m)^(1/2))), with the stick stiffness K of the exact state."""
    state = model.state_at_load(MEAN_LOAD)
    push, stiffness = state.friction_force / 3, state.tangential_stiffness
    angular = math.sqrt(stiffness / MASS)
    end = 4 * math.pi / angular  # two periods, in steps of which the error of the phase is far below the limit
    mbs = exudyn.SystemContainer().AddSystem()
    node = mbs.AddNode(NodePoint(initialCoordinates=[*AT_REST, 0.0]))
    mass = mbs.AddObject(MassPoint(mass=MASS, nodeNumber=node))
    bristle, zero = Bristle(model), np.zeros((3, 3))
    mbs.AddObject(
        ObjectGenericODE2(
            nodeNumbers=[node], massMatrix=zero, stiffnessMatrix=zero, dampingMatrix=zero, forceVector=[0.0] * 3,
            forceUserFunction=bristle.force, jacobianUserFunction=bristle.jacobian,
        )
    )
    marker = mbs.AddMarker(MarkerBodyPosition(bodyNumber=mass))
    mbs.AddLoad(Force(markerNumber=marker, loadVector=[push, -MEAN_LOAD, 0.0]))
    sensor = mbs.AddSensor(
        SensorNode(nodeNumber=node, storeInternal=True, outputVariableType=exudyn.OutputVariableType.Displacement)
    )
    mbs.Assemble()
    chosen = settings(end / 2000, end)
    chosen.timeIntegration.generalizedAlpha.spectralRadius = 1.0
    if not mbs.SolveDynamic(chosen):
        raise RuntimeError("Exudyn has not solved the motion of the mass that is held")
    motion = mbs.GetSensorStoredData(sensor)
    expected = push / stiffness * (1 - np.cos(angular * motion[:, 0]))
    error = np.max(np.abs(motion[:, 1] - expected)) / (push / stiffness)
    print(f"  pushed with {push:.3f} N the mass swings by {2e9 * push / stiffness:.3f} nm and does not creep ({error:.1e})")
    return error


def oscillator(contact, own_jacobian):
    """The multibody system and its sensor. With its own Jacobian the contact is an ObjectGenericODE2 on the node of the
    mass; otherwise it is a connector, which Exudyn differentiates by differences."""
    mbs = exudyn.SystemContainer().AddSystem()
    node = mbs.AddNode(NodePoint(initialCoordinates=[*AT_REST, 0.0]))
    mass = mbs.AddObject(MassPoint(mass=MASS, nodeNumber=node))
    markers = [mbs.AddMarker(MarkerBodyPosition(bodyNumber=n)) for n in (mbs.AddObject(ObjectGround()), mass)]
    mbs.AddObject(CartesianSpringDamper(markerNumbers=markers, stiffness=[SPRING, 0.0, SPRING]))
    mbs.AddLoad(Force(markerNumber=markers[1], loadVectorUserFunction=lambda mbs, t, load: [0, -pressing_load(t), 0]))
    if own_jacobian:
        zero = np.zeros((3, 3))
        mbs.AddObject(
            ObjectGenericODE2(
                nodeNumbers=[node], massMatrix=zero, stiffnessMatrix=zero, dampingMatrix=zero, forceVector=[0.0] * 3,
                forceUserFunction=contact.force, jacobianUserFunction=contact.jacobian,
            )
        )
    else:
        mbs.AddObject(CartesianSpringDamper(markerNumbers=markers, springForceUserFunction=contact.spring_force))
    sensor = mbs.AddSensor(
        SensorNode(nodeNumber=node, storeInternal=True, outputVariableType=exudyn.OutputVariableType.Displacement)
    )
    mbs.Assemble()
    return mbs, sensor


def settings(step, end=END):
    result = exudyn.SimulationSettings()
    result.solution.file.write = False
    result.solution.sensors.writePeriod = step
    integration = result.timeIntegration
    integration.endTime, integration.numberOfSteps = end, round(end / step)
    integration.verboseMode = 0
    integration.generalizedAlpha.spectralRadius = 0.9
    integration.newton.useModifiedNewton = False
    integration.newton.relativeTolerance, integration.newton.absoluteTolerance = 1e-9, 1e-10
    return result


def run(contact, own_jacobian=False, step=STEP):
    """Times, positions, Newton iterations per step, processor time."""
    mbs, sensor = oscillator(contact, own_jacobian)
    start = time.process_time()
    if not mbs.SolveDynamic(settings(step), storeSolver=True):
        raise RuntimeError("Exudyn has not solved the motion")
    seconds = time.process_time() - start
    motion = mbs.GetSensorStoredData(sensor)
    return motion[:, 0], motion[:, 1], mbs.sys["dynamicSolver"].it.newtonStepsCount * step / END, seconds


def reference(model, times):
    """Position and speed by SciPy, with the friction force from the integrals: no table, nothing of Exudyn. Also the
    least and the greatest load."""

    def rates(t, state):
        x, y, x_rate, y_rate = state
        load = normal_force(y, y_rate)
        exact = model.state_at_load(load).friction_force if load > 0 else 0.0
        friction = exact * math.tanh((x_rate - BELT_SPEED) / SLIP_SCALE)
        return [x_rate, y_rate, (-SPRING * x - friction) / MASS, (load - pressing_load(t)) / MASS]

    solution = solve_ivp(
        rates, (0.0, END), [*AT_REST, 0.0, 0.0], method="Radau", rtol=1e-8, atol=1e-12, t_eval=times
    )
    if solution.status != 0:
        raise RuntimeError(f"SciPy: {solution.message}")
    loads = [normal_force(y, y_rate) for y, y_rate in zip(solution.y[1], solution.y[3])]
    return solution.y[0], solution.y[2], min(loads), max(loads)


def sticking_part(x_rate):
    """Part of the time in which the mass moves with the belt; demands that it does both."""
    sticking = np.mean(np.abs(x_rate - BELT_SPEED) < SLIP_SCALE)
    if not 0.2 < sticking < 0.8:
        raise RuntimeError(f"the mass sticks {sticking:.0%} of the time: no stick-slip")
    return sticking


def report_newton(model):
    """Newton's iterations with the slope of the law, with friction/load in its place, and without one."""

    def slope(load):
        return model.friction_force_at_load(load, slope=True)

    def secant(load):
        friction = model.friction_force_at_load(load)
        return friction, friction / load

    def none(load):
        return model.friction_force_at_load(load), 0.0

    contact = BeltContact(model.friction_force_at_load, None)
    _, x, iterations, _ = run(contact, step=COARSE_STEP)
    print(f"  Newton iterations in each step of {1e6 * COARSE_STEP:.0f} us, and calls of the law in all:")
    print(f"    Jacobian by differences: {iterations:.2f}, {contact.calls} calls")
    for name, derivative in (("the slope of the law", slope), ("mu as the slope", secant), ("no slope", none)):
        contact = BeltContact(model.friction_force_at_load, derivative)
        _, again, iterations, _ = run(contact, own_jacobian=True, step=COARSE_STEP)
        if not np.max(np.abs(again - x)) < 1e-6 * np.ptp(x):
            raise RuntimeError(f"Newton's method with {name} gives another motion")
        print(f"    own Jacobian with {name}: {iterations:.2f}, {contact.calls} calls")


def main():
    model = coated_pads()
    times, x, _, law_time = run(BeltContact(model.friction_force_at_load, None))
    expected, x_rate, *loads = reference(model, times)
    surface.demand(model, *loads)
    amplitude = np.ptp(expected) / 2
    error = np.max([np.max(np.abs(x - expected)) / amplitude, hold(model)])  # max would leave out what is no number
    mu = model.state_at_load(MEAN_LOAD).friction_coefficient
    _, x_constant, _, constant_time = run(BeltContact(lambda load: mu * load, None))
    print(
        f"  amplitude {1e3 * amplitude:.4f} mm, sticks {sticking_part(x_rate):.0%} of the time; with constant mu the "
        f"mass is up to {np.max(np.abs(x_constant - x)) / amplitude:.1%} of the amplitude elsewhere"
    )
    report_newton(model)
    print(f"exudyn  cost  constant mu {constant_time:.2f} s; the law x {law_time / constant_time:.2f}")
    return error <= LIMIT, f"max error of x / amplitude, of the swing = {error:.1e} (limit {LIMIT:.0e})"


if __name__ == "__main__":
    verdict.run("exudyn", main)
