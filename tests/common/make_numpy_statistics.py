"""Prints the table of statistics_test.cpp: samples, and what NumPy says of them.

python3 tests/common/make_numpy_statistics.py
"""

import numpy as np

random = np.random.default_rng(7)
for count in (1, 2, 5, 20):
    values = np.round(random.normal(1.0, 3.0, count), 3)
    quantiles = [np.quantile(values, share) for share in (0.05, 0.25, 0.5, 0.95)]
    error = values.std(ddof=1) / np.sqrt(count) if count > 1 else 0.0
    numbers = [values.mean(), values.std(), error, *quantiles]
    print(f"    {{{{{', '.join(f'{x:g}' for x in values)}}},")
    print(f"     {{{', '.join(f'{x:.12g}' for x in numbers)}}}}},")
