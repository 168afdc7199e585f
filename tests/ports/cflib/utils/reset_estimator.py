# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
from cflib import calls


def reset_estimator(crazyflie):
    calls.append(("reset_estimator",))
