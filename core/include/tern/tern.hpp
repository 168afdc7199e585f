// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Everything a C++ user needs. C users include tern.h.
#ifndef TERN_TERN_HPP
#define TERN_TERN_HPP

#include "tern/flatness.hpp"
#include "tern/grid.hpp"
#include "tern/planner.hpp"
#include "tern/self_test.hpp"
#include "tern/status.hpp"
#include "tern/trajectory.hpp"

#endif
