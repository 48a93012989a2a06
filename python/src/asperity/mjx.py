"""The friction law at the contacts of MuJoCo XLA (MJX).

    import jax, mujoco
    from mujoco import mjx
    import asperity, asperity.mjx

    model = mujoco.MjModel.from_xml_path("sled.xml")                  with <option cone="elliptic"/>
    m, d = mjx.put_model(model), mjx.make_data(model)
    friction = asperity.mjx.attach(model, m, d, {("sled", "floor"): asperity.Model(params)})
    step, loads = jax.jit(friction.step), friction.loads()
    d, loads = step(m, d, loads)                                      in place of d = mjx.step(m, d)

The call and its rules are those of `asperity.mujoco_warp`. What MuJoCo Warp keeps from step to step is here an argument and a
result: `friction.loads(4096)` belongs to `jax.vmap(friction.step, (None, 0, 0))`. Needs MJX (`pip install mujoco-mjx`).
"""

from .hosts.mjx import Friction, Loads, attach

__all__ = ["Friction", "Loads", "attach"]
