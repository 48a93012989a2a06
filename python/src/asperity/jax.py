"""The friction law inside JAX: compiled by XLA, batched by `vmap`, differentiated by `grad` to any order.

    import jax
    import asperity, asperity.jax

    jax.config.update("jax_enable_x64", True)
    friction_force = asperity.jax.friction_force(asperity.Model(params))
    slope = jax.vmap(jax.grad(friction_force))(loads)

Needs the extra `jax`. Nothing here calls the library: the compiled law becomes constants of the program, and loads beside
its table have the rules of asperity_eval.h. Derivatives come from the polynomials of the table. (JAX would take those of
bit operations for 0.)
"""

from .hosts.jax import friction, friction_force, load_at_gap

__all__ = ["friction", "friction_force", "load_at_gap"]
