/* What libasperity_mujoco.so has beside its plugin asperity.friction, for programs that call MuJoCo in C or C++. */
#ifndef ASPERITY_MUJOCO_H
#define ASPERITY_MUJOCO_H

#include <mujoco/mujoco.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Solves the step, between mj_step1 and mj_step2, until the friction of each pair of geometries is the law at its own
 * normal force, instead of that which the steps before let expect. Set controls and applied forces before.
 * Returns how often it solved; -1, with a warning of MuJoCo's, if friction and normal force do not settle. */
int asperity_mujoco_solve(const mjModel *m, mjData *d);

/* Whether a plugin instance of a model, of m->nplugin, is one of asperity.friction. */
int asperity_mujoco_has_plugin(const mjModel *m, int instance);

#ifdef __cplusplus
}
#endif

#endif
