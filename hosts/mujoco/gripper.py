"""Steel fingers, 1 cm2 each, hold the heaviest steel part that a constant friction coefficient MU, measured at 50 N, holds. SI units."""
import mujoco

import asperity.mujoco
from asperity.estimate import estimate

MU = 0.2
SURFACE = f'pair = "steel/steel"\nnominal_area = 1e-4\nmeasured = [50, {MU}]\n[roughness]\nprocess = "ground"\nRa = 0.8e-6\n'
FINGER = '<body pos="{0}0.03 0 0"> <joint name="{0}" type="slide" axis="{0}1 0 0"/> <geom type="box" size="0.01 0.005 0.005" mass="0.2"/> </body>'
SCENE = f"""<mujoco>
  <extension> <plugin plugin="asperity.friction"> <instance name="steel">
    <config key="text" value='{SURFACE}'/> <config key="microslip" value="true"/>
  </instance> </plugin> </extension>
  <option cone="elliptic"/>
  <worldbody>
    <body> <plugin instance="steel"/> <joint type="slide" axis="0 0 1"/> <geom type="box" size="0.02 0.02 0.02" mass="MASS"/> </body>
    {FINGER.format("+")} {FINGER.format("-")}
  </worldbody>
  <actuator> <motor joint="+" gear="-1"/> <motor joint="-" gear="-1"/> </actuator>
</mujoco>"""
for grip in (5, 50, 500):
    mass = 0.99 * 2 * MU * grip / 9.81
    model = mujoco.MjModel.from_xml_string(SCENE.replace("MASS", str(mass)))
    data = mujoco.MjData(model)
    data.ctrl[:] = grip
    mujoco.mj_step(model, data, 500)
    found = estimate(SURFACE, grip)
    print(f"{grip:3} N holds {mass:5.2f} kg: {data.qvel[0] > -0.01}; mu {found.value:.3f} ({found.low:.3f} to {found.high:.3f})")
