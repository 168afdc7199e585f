# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""All kinds of campaigns, by name."""
import faults
import kinds
import swarms

KINDS = {kind.name: kind for kind in (kinds.Plan, kinds.Fly, faults.Faults, kinds.Attack, swarms.Swarm)}
