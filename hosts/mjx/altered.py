"""The ball of hosts/ball.py in three worlds of MuJoCo XLA, and what is said of a plugin that a back end drops."""

import subprocess
import sys
from pathlib import Path

import jax
import jax.numpy as jnp
import mujoco
import numpy as np
from mujoco import mjx

import asperity.mjx

sys.path.insert(0, str(Path(__file__).parents[1]))
import ball  # noqa: E402
from surface import SURFACE  # noqa: E402


class Worlds:
    def __init__(self, model, laws, time_constant, passes):
        self.count = len(ball.FALL)
        self.m = mjx.put_model(model)
        self.start = mjx.put_data(model, mujoco.MjData(model))
        self.friction = asperity.mjx.attach(model, self.m, self.start, laws, time_constant, passes)
        self.one_step = jax.jit(jax.vmap(self.friction.step, (None, 0, 0)))
        self.loads = self.friction.loads(self.count)

    def throw(self, *velocity):
        """The loads of the run before are kept: time begins again."""
        self.d = jax.tree.map(lambda x: jnp.broadcast_to(x, (self.count, *x.shape)) if isinstance(x, jax.Array) else x, self.start)
        self.d = self.d.replace(qvel=jnp.asarray(np.column_stack(velocity), self.start.qvel.dtype))

    def press(self, force):
        """Upwards, from now on."""
        self.pressed = force

    def step(self):
        """The normal force in each world."""
        self.d = self.d.replace(qfrc_applied=self.d.qfrc_applied.at[:, 1].set(self.pressed))
        self.d, self.loads = self.one_step(self.m, self.d, self.loads)
        impl = self.d._impl
        return np.asarray(impl.efc_force)[:, np.asarray(impl.contact.efc_address)].sum(axis=1).astype(float)

    def velocities(self):
        return np.asarray(self.d.qvel, float)

    def time(self):
        return float(self.d.time[0])


DROPPED = """
import warnings
{imports}
import mujoco
model = mujoco.MjModel.from_xml_string('<mujoco><extension><plugin plugin="asperity.friction"><instance name="film">'
    '<config key="surface" value="{surface}"/><config key="pairs" value="{pairs}"/></instance></plugin></extension>'
    '<option cone="elliptic"/><worldbody><geom name="floor" type="plane" size="9 9 1"/><body>{plugin}<freejoint/>'
    '<geom name="box" type="box" size=".1 .1 .1"/></body></worldbody></mujoco>')
with warnings.catch_warnings(record=True) as caught:
    warnings.simplefilter("always")
    mjx.put_model(model)
print([str(warning.message) for warning in caught])
"""


def check_dropped():
    """A model with the plugin is told where it is made for MJX, whichever is imported first and however the geoms are named."""
    orders = ["from mujoco import mjx\nimport asperity.mujoco", "import asperity.mujoco\nfrom mujoco import mjx"]
    for imports, named in zip(orders, (dict(pairs="", plugin='<plugin instance="film"/>'), dict(pairs="box floor", plugin=""))):
        program = DROPPED.format(imports=imports, surface=SURFACE, **named)
        done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=False)
        if "drops the plugin asperity.friction, instance 'film'" not in done.stdout or "asperity.mjx.attach" not in done.stdout:
            raise RuntimeError(f"{imports}: a plugin that MJX drops is not told: {done.stdout} {done.stderr[-500:]}")


def main():
    check_dropped()
    ball.HABITS["no friction"]["refused"] = "need a friction above 0"
    return ball.main(Worlds)


if __name__ == "__main__":
    ball.verdict.run("mjx", main)
