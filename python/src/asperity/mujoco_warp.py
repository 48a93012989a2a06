"""The friction law at the contacts of MuJoCo Warp, in all worlds of a `mujoco_warp.Data`.

    import mujoco, mujoco_warp
    import asperity, asperity.mujoco_warp

    model = mujoco.MjModel.from_xml_path("sled.xml")                  with <option cone="elliptic"/>
    m, d = mujoco_warp.put_model(model), mujoco_warp.put_data(model, mujoco.MjData(model), nworld=4096)
    asperity.mujoco_warp.attach(model, m, d, {("sled", "floor"): asperity.Model(params)})
    mujoco_warp.step(m, d)                                            as ever, or in a graph

Two geoms name a pair, one all pairs in which it is. Loads are sums over the points of two geoms. Each step is solved for its loads
first, `passes` times. A pair that has touched for longer than `time_constant` has the law at their mean; a younger pair, as in an
impact, at the load of the step itself. Newton's `SolverMuJoCo` has both objects as
`mjw_model` and `mjw_data`. Needs MuJoCo Warp (`pip install mujoco-warp`).
"""

from .hosts.mujoco_warp import Friction, attach

__all__ = ["Friction", "attach"]
