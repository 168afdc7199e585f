# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""ulog.py SITL LOG: prints what ulog.mjs prints, as port/sitl/flight_log.py reads it."""
import sys

sys.path.insert(0, sys.argv[1])
from flight_log import read_log  # noqa: E402

FIELDS = {"trajectory_setpoint": [f"{field}[{k}]" for field in ("position", "velocity") for k in range(3)],
          "vehicle_status": ["nav_state"], "vehicle_local_position": ["x", "y", "z"],
          "vehicle_local_position_groundtruth": ["x", "y", "z"]}
log = read_log(sys.argv[2], list(FIELDS))
for name, fields in FIELDS.items():
    for record in log[name]:
        print(name, record["timestamp"], *(f"{record[field] + 0.0:.6f}" for field in fields))  # JavaScript has no -0
