"""For other programs: what `asperity.jax`, `warp`, `mujoco`, `mujoco_warp`, `mjx` and `kratos` name, exports and FMUs."""
