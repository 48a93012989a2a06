"""A box on an incline in MuJoCo. Sliding, it hops, so that its load jitters between nothing and several times its mean.
Its acceleration with the plugin's `time_constant` against the right one, and with the load of the step before.
"""

import sys
from pathlib import Path

import mujoco

import asperity.mujoco

sys.path.insert(0, str(Path(__file__).parents[1]))
import incline  # noqa: E402
import verdict  # noqa: E402


def model_of(surface, config):
    """Without a surface the friction is the program's."""
    extension = body = ""
    if surface:
        instance = asperity.mujoco.instance("carbon", surface).replace("</instance>", f"{config}</instance>")
        extension = f'<extension><plugin plugin="asperity.friction">{instance}</plugin></extension>'
        body = '<plugin instance="carbon"/>'
    return mujoco.MjModel.from_xml_string(f"""
    <mujoco>
      {extension}
      <option cone="elliptic" gravity="{incline.DOWNHILL} 0 {-incline.NORMAL}"/>
      <default><geom friction="{incline.FIRST_GUESS}"/></default>
      <worldbody>
        <geom type="plane" size="5 5 0.1"/>
        <body pos="0 0 {incline.HALF_LENGTHS[2]}">
          {body}
          <freejoint/>
          <geom type="box" size="{' '.join(map(str, incline.HALF_LENGTHS))}" mass="{incline.MASS}"/>
        </body>
      </worldbody>
    </mujoco>""")


def slide(model, step):
    data = mujoco.MjData(model)
    times, speeds = [], []
    while data.time < 1:
        step(model, data)
        times.append(data.time)
        speeds.append(data.qvel[0])
    return incline.acceleration(times, speeds)


def lagged_step(law):
    """The law at the load of the step before, set between the two halves of a step."""
    load = None

    def step(model, data):
        nonlocal load
        mujoco.mj_step1(model, data)
        if load is not None:
            for contact in data.contact:
                contact.friction[:2] = contact.mu = law.friction_at_load(load)
        mujoco.mj_step2(model, data)
        load = sum(data.efc_force[contact.efc_address] for contact in data.contact if contact.efc_address >= 0)

    return step


def main():
    law = incline.law()
    print(f"incline: {slide(model_of(law.params, ''), mujoco.mj_step):.3f} m/s2 with the line through the last two loads")
    config = f'<config key="time_constant" value="{incline.TIME_CONSTANT}"/>'
    mean = slide(model_of(law.params, config), mujoco.mj_step)
    lagged = slide(model_of(None, ""), lagged_step(law))
    return incline.judge(mean, incline.right_acceleration(law), lagged)


if __name__ == "__main__":
    verdict.run("mujoco", main)
