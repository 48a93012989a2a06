"""What anyone does first with the Python package: python_check.py VERSION. The answer is that of docs/python.md."""

import sys

import asperity
import numpy as np

assert asperity.__version__ == sys.argv[1], f"version {asperity.__version__}, not {sys.argv[1]}"
model = asperity.Model(asperity.Params.dimensionless(alpha=0.01, beta=1000, gamma=0.001))
assert f"{model.friction_at_load(100.0):.4f}" == "1.9827", f"friction {model.friction_at_load(100.0)}"
loads = np.geomspace(1, 1e4, 50)
assert list(model.friction_at_load(loads)) == [model.friction_at_load(load) for load in loads], "arrays have other answers"
print(f"asperity {asperity.__version__} of {asperity.__path__[0]} answers")
