"""Hypothesis profiles, chosen by the environment variable HYPOTHESIS_PROFILE.

dev       100 examples, random            while writing code (the default)
ci       1000 examples, always the same   before a change lands
nightly 10000 examples, random            to find what the others missed
"""

from __future__ import annotations

import os

from hypothesis import HealthCheck, settings

# Nothing here depends on the clock: a slow machine must not turn a true law into a failure. What is
# not set here comes from hypothesis, which has other defaults where the variable CI is set.
COMMON = {
    "deadline": None,
    "suppress_health_check": [HealthCheck.too_slow],
    "print_blob": True,
}

settings.register_profile("dev", max_examples=100, derandomize=False, **COMMON)
settings.register_profile("ci", max_examples=1_000, derandomize=True, database=None, **COMMON)
settings.register_profile("nightly", max_examples=10_000, derandomize=False, **COMMON)
settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "dev"))
