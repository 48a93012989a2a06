"""As estimate.c."""

import sys

from asperity.estimate import estimate

found = estimate(sys.stdin.read(), [0.0, 1.0, 100.0])
for mu, low, high in list(zip(found.value, found.low, found.high))[1:]:
    print(f"{mu:.12E} {low:.12E} {high:.12E}")
print(found.text)
