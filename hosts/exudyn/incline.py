"""A mass on an incline in Exudyn, on a contact spring whose load gives the friction inside Newton's iterations, by a user function
with its slope: its acceleration against the right one.
"""

import math
import sys
from pathlib import Path

import exudyn
import numpy as np
from exudyn.itemInterface import Force, MarkerBodyPosition, MassPoint, NodePoint, ObjectGenericODE2, SensorNode

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
import incline  # noqa: E402

STIFFNESS, DAMPING, SLIP_SCALE, STEP, END = 1e5, 60.0, 0.002, 1e-3, 0.5


def contact(law):
    """What Exudyn calls for the force, and for factor d(-force)/dq + factor_rate d(-force)/dq_rate."""

    def load_and_sign(q, q_rate):
        return max(0.0, -STIFFNESS * q[1] - DAMPING * q_rate[1]), math.tanh(q_rate[0] / SLIP_SCALE)

    def force(mbs, t, item, q, q_rate):
        load, sign = load_and_sign(q, q_rate)
        # Adhesion would give friction at zero load, but a gap has none.
        return [-law.friction_force_at_load(load) * sign if load > 0 else 0.0, load, 0.0]

    def jacobian(mbs, t, item, q, q_rate, factor, factor_rate):
        load, sign = load_and_sign(q, q_rate)
        matrix = np.zeros((3, 3))
        if load > 0:
            friction, slope = law.friction_force_at_load(load, slope=True)
            load_by_y = -(factor * STIFFNESS + factor_rate * DAMPING)
            matrix[0, 0] = factor_rate * friction * (1 - sign * sign) / SLIP_SCALE
            matrix[0, 1] = slope * sign * load_by_y
            matrix[1, 1] = -load_by_y
        return matrix

    return {"forceUserFunction": force, "jacobianUserFunction": jacobian}


def slide(law):
    mbs, zero = exudyn.SystemContainer().AddSystem(), np.zeros((3, 3))
    node = mbs.AddNode(NodePoint(initialCoordinates=[0.0, -incline.MASS * incline.NORMAL / STIFFNESS, 0.0]))
    mass = mbs.AddObject(MassPoint(mass=incline.MASS, nodeNumber=node))
    matrices = {name: zero for name in ("massMatrix", "stiffnessMatrix", "dampingMatrix")}
    mbs.AddObject(ObjectGenericODE2(nodeNumbers=[node], **matrices, forceVector=[0.0] * 3, **contact(law)))
    weight = [incline.MASS * incline.DOWNHILL, -incline.MASS * incline.NORMAL, 0.0]
    mbs.AddLoad(Force(markerNumber=mbs.AddMarker(MarkerBodyPosition(bodyNumber=mass)), loadVector=weight))
    sensor = mbs.AddSensor(SensorNode(nodeNumber=node, storeInternal=True, outputVariableType=exudyn.OutputVariableType.Velocity))
    mbs.Assemble()
    settings = exudyn.SimulationSettings()
    settings.solution.file.write = False
    settings.solution.sensors.writePeriod = step = incline.SHARE * STEP
    settings.timeIntegration.endTime, settings.timeIntegration.numberOfSteps = END, round(END / step)
    settings.timeIntegration.verboseMode = 0
    if not mbs.SolveDynamic(settings):
        raise RuntimeError("Exudyn has not solved the motion")
    motion = mbs.GetSensorStoredData(sensor)
    return incline.acceleration(motion[:, 0], motion[:, 1])


if __name__ == "__main__":
    incline.run("exudyn", slide, limit=1e-6)
