"""For other programs: what `asperity.jax`, `warp`, `mujoco`, `mujoco_warp` and `kratos` name, exports and FMUs."""
