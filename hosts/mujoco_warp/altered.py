"""The ball of hosts/ball.py in three worlds of MuJoCo Warp."""

import sys
from pathlib import Path

import mujoco
import mujoco_warp
import numpy as np
import warp

import asperity.mujoco_warp

sys.path.insert(0, str(Path(__file__).parents[1]))
import ball  # noqa: E402


class Worlds:
    def __init__(self, model, laws, time_constant, passes):
        self.count = len(ball.FALL)
        self.m = mujoco_warp.put_model(model)
        self.d = mujoco_warp.put_data(model, mujoco.MjData(model), nworld=self.count, nconmax=8, njmax=8)
        asperity.mujoco_warp.attach(model, self.m, self.d, laws, time_constant, passes)

    def throw(self, *velocity):
        mujoco_warp.reset_data(self.m, self.d)
        self.d.qvel.assign(np.column_stack(velocity).astype(np.float32))

    def steps(self, forces):
        """The normal force in each world after each step, and the velocities, under forces upwards."""
        d, loads, velocities = self.d, np.zeros((len(forces), self.count)), []
        for step, force in enumerate(forces):
            d.qfrc_applied.assign(np.tile(np.float32([0, force]), (self.count, 1)))
            mujoco_warp.step(self.m, d)
            normal, contacts = d.efc.force.numpy(), int(d.nacon.numpy()[0])
            for world, address in zip(d.contact.worldid.numpy()[:contacts], d.contact.efc_address.numpy()[:contacts, 0]):
                loads[step, world] += normal[world, address] if address >= 0 else 0
            velocities.append(d.qvel.numpy().astype(float))
        return loads, np.array(velocities)


if __name__ == "__main__":
    warp.config.quiet = True
    ball.verdict.run("mujoco_warp", ball.main, Worlds)
