"""The pushed block of hosts/pushed.py in deal.II. usage: block.py PROGRAM"""

import subprocess
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
import pushed  # of hosts/
import verdict

PROGRAM = Path(sys.argv[1])


def steps(model, area, young, poisson, size, elements, penalty, onset, moves):
    file = PROGRAM.with_name("law.toml")
    model.params.to_toml(file)
    corner = size * pushed.LENGTH, size * pushed.HEIGHT
    numbers = area, young, poisson, *corner, *elements, penalty * young / corner[1], onset, *np.ravel(moves)
    run = subprocess.run([PROGRAM, file, *(format(number, ".17g") for number in numbers)], capture_output=True, text=True)
    if run.returncode:
        raise RuntimeError(run.stderr.strip())
    for line in run.stdout.splitlines():
        numbers = np.array(line.split(), float)
        yield numbers[:2], *numbers[2:].reshape(-1, 3).T


if __name__ == "__main__":
    verdict.run("dealii", pushed.main, steps)
