# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""Exact bounds (Clopper and Pearson) of a probability from how often something happened in so many trials."""
import math

CONFIDENCE = 0.95


def at_most(count, trials, probability):
    """The probability of `count` or fewer in so many trials."""
    if probability <= 0.0 or count >= trials:
        return 1.0
    if probability >= 1.0:
        return 0.0
    log_p, log_q = math.log(probability), math.log1p(-probability)
    choices = lambda k: math.lgamma(trials + 1) - math.lgamma(k + 1) - math.lgamma(trials - k + 1)
    return min(1.0, math.fsum(math.exp(choices(k) + k * log_p + (trials - k) * log_q) for k in range(count + 1)))


def upper(count, trials):
    """The probability is below this, with 95 % confidence. 1 where nothing is known."""
    if count >= trials:
        return 1.0
    low, high = 0.0, 1.0
    for _ in range(200):
        middle = 0.5 * (low + high)
        if at_most(count, trials, middle) > 1.0 - CONFIDENCE:
            low = middle
        else:
            high = middle
    return high


def lower(count, trials):
    """The probability is above this, likewise. 0 where nothing is known."""
    return 1.0 - upper(trials - count, trials)
