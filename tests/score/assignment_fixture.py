"""Writes assignment_fixture.txt: random weights and the total of scipy's best assignment.

    python3 tests/score/assignment_fixture.py > tests/score/assignment_fixture.txt

Each case: a line "rows columns total", then the weights row by row. Total of
scipy.optimize.linear_sum_assignment(weights, maximize=True).
"""

import numpy as np
from scipy.optimize import linear_sum_assignment

random = np.random.default_rng(7)
for rows, columns, density in [(1, 1, 1), (1, 7, 1), (7, 1, 1), (5, 5, 1), (12, 12, 0.3), (40, 25, 0.1),
                               (25, 40, 0.1), (30, 30, 1), (17, 60, 0.05), (8, 8, 0)]:
    weights = np.round(random.random((rows, columns)), 3) * (random.random((rows, columns)) < density)
    given = linear_sum_assignment(weights, maximize=True)
    print(rows, columns, repr(float(weights[given].sum())))
    for row in weights:
        print(*(f"{w:.3g}" for w in row))
