# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
set(TERN_STAGE_SOURCES
  active_set.cpp
  factor.cpp
  hessian.cpp
  kkt.cpp
  pricing.cpp
  qp.cpp
  rows.cpp
)
