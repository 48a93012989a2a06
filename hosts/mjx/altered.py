"""The ball of hosts/ball.py in three worlds of MuJoCo XLA, and what is said of a plugin that a back end drops."""

import functools
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


COMPILED = {}  # the steps of a law, of which models are arguments: compiling takes most of a run


class Worlds:
    def __init__(self, model, laws, time_constant, passes):
        self.m = jax.device_put(mjx.put_model(model), jax.devices()[0])
        self.start = mjx.put_data(model, mujoco.MjData(model))
        friction = asperity.mjx.attach(model, self.m, self.start, laws, time_constant, passes)
        made_of = str({geoms: law.params._as_text() for geoms, law in laws.items()}), time_constant, passes
        self.some_steps = COMPILED.setdefault(made_of, jax.jit(functools.partial(some_steps, friction)))
        self.loads = jax.device_put(friction.loads(len(ball.FALL)), jax.devices()[0])

    def throw(self, *velocity):
        """The loads of the run before are kept: time begins again."""
        self.d = jax.tree.map(lambda x: jnp.broadcast_to(x, (len(ball.FALL), *jnp.shape(x))), self.start)
        self.d = self.d.replace(qvel=jnp.asarray(np.column_stack(velocity), self.start.qvel.dtype))
        self.d = jax.device_put(self.d, jax.devices()[0])

    def steps(self, forces):
        """The normal force in each world after each step, and the velocities, under forces upwards."""
        found = []
        for some in np.float32(forces).reshape(-1, ball.AT_ONCE):
            (self.d, self.loads), each = self.some_steps(self.m, self.d, self.loads, some)
            found.append(each)
        return [np.concatenate([np.asarray(each, float) for each in one]) for one in zip(*found)]


def some_steps(friction, m, d, loads, forces):
    def step(worlds, force):
        d, loads = worlds
        d = d.replace(qfrc_applied=d.qfrc_applied.at[:, 1].set(force))
        d, loads = jax.vmap(friction.step, (None, 0, 0))(m, d, loads)
        return (d, loads), (d._impl.efc_force[:, np.asarray(d._impl.contact.efc_address)].sum(axis=1), d.qvel)

    return jax.lax.scan(step, (d, loads), forces)


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
