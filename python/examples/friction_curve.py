"""Friction coefficient of a polysilicon MEMS contact against normal load, with its band: the summary of c_examples/friction_curve.c,
which says where the numbers come from, in Python."""

from asperity import Model, Params
from asperity.estimate import estimate

SURFACE = """
measured = [1e-2, 0.3, 0.05]    # load [N], friction coefficient, relative error: ASSUMED
work_of_adhesion = 0.063        # [J/m^2]
adhesion_range = 0.384e-9       # [m]
burgers_vector = 0.384e-9       # [m]
hardness = 12e9                 # [Pa], for warnings
nominal_area = 1e-8             # [m^2]
[materials]
E1 = 160e9                      # [Pa]
nu1 = 0.22
E2 = 160e9
nu2 = 0.22
[roughness]
Sq = 5e-9                       # [m]
Sdq = 0.08
"""
LOADS = [1e-4, 1e-3, 1e-2, 1e-1, 1.0]  # [N]

model = Model(Params.from_text(SURFACE))
found = estimate(SURFACE, LOADS)
print("  load [N]      mu     low    high   contacts")
for load, mu, low, high in zip(LOADS, found.value, found.low, found.high):
    print(f"{load:10.3g}  {mu:6.3f}  {low:6.3f}  {high:6.3f}  {model.state_at_load(load).contacting:9.0f}")
