# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""A stand-in for cflib: what port/crazyflie/upload.py calls, recorded in `calls`. A flight goes where it is told, but for
`strays` along x; `estimate` has the log variables of its position."""

calls = []
estimate = {}
strays = [0.0]
