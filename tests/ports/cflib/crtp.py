# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
from cflib import calls


def init_drivers():
    calls.append(("init_drivers",))
