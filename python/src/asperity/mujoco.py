"""The engine plugin asperity.friction of MuJoCo. Importing this module loads it; then models can name it.

    import asperity.mujoco, mujoco
    model = mujoco.MjModel.from_xml_path("slider.xml")
    data = mujoco.MjData(model)
    mujoco.mj_step(model, data)

    mujoco.mj_step1(model, data)                 the same at the normal forces of the step itself:
    asperity.mujoco.solve(model, data)           the friction of each pair of geoms is the law at its own
    mujoco.mj_step2(model, data)

    params = asperity.Params.from_toml("surface.toml")
    print(asperity.mujoco.instance("carbon", params))                        for the <extension> of a model

The plugin is compiled on the first import, for the MuJoCo that is installed, and kept in the user's cache
(XDG_CACHE_HOME, or ~/.cache).
"""

from .hosts.mujoco import PLUGIN, instance, solve

__all__ = ["PLUGIN", "instance", "solve"]
