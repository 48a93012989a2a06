"""The friction law inside Warp kernels, with gradients on a tape, in doubles and in floats.

    import warp as wp
    import asperity, asperity.warp

    law = asperity.warp.law(asperity.Model(params), dtype="float32", device="cpu")

    @wp.kernel
    def friction(law: asperity.warp.Law32, load: wp.array(dtype=wp.float32), force: wp.array(dtype=wp.float32)):
        i = wp.tid()
        force[i] = asperity.warp.friction_force(law, load[i])

Needs the extra `warp`. `friction_force` and `friction` take a `Law32` with a float32 or a `Law64` with a float64; loads
beside the table have the rules of asperity_eval.h. Their gradients by load are the slopes of the table. (Warp alone would
take those of bit operations for 0, in silence.) The law itself has no gradient.
"""

from .hosts.warp import Law32, Law64, friction, friction_force, law, load_at_gap, load_law

__all__ = ["Law32", "Law64", "friction", "friction_force", "law", "load_at_gap", "load_law"]
