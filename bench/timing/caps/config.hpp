// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The companion profile with an eighth of its nodes, so that the costliest search runs out of them within seconds, and
// an open list that is smaller still: in the profile itself it has room for every node and never runs out.
#define TERN_MAX_NODES (64 * 1024)
#define TERN_MAX_OPEN (48 * 1024)
