# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""A stand-in for cflib: what port/crazyflie/upload.py calls, recorded in `calls`."""

calls = []
