"""What anyone does first with the Python package, with answers that other parts of the project check."""

import sys

import asperity
import numpy as np

expected = sys.argv[1]
assert asperity.__version__ == expected, f"version {asperity.__version__}, not {expected}"
model = asperity.Model(asperity.Params())
loads = np.array([1e-3, 1e-2])
forces = model.friction_force(loads)
assert [float(force) for force in forces] == [model.friction_force(load) for load in loads], "arrays and numbers differ"
print(f"friction {forces[1]:.6e} N at {loads[1]} N")
