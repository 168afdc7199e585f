// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Everything that a C++ program needs to plan and fly. C programs include tern.h instead. Formats of flight stacks are
// in a library of their own, tern_stacks/stacks.hpp.
//
// In order: run self_test() once, bind a Grid to storage of yours, mark obstacles, inflate the grid, make a Planner
// over a Workspace, fill in a Request, call plan(), and fly the Trajectory with evaluate(). docs/integration.md has the
// programs.
#ifndef TERN_TERN_HPP
#define TERN_TERN_HPP

#include "tern/far_way.hpp"
#include "tern/flatness.hpp"
#include "tern/fleet.hpp"
#include "tern/flight.hpp"
#include "tern/flight_record.hpp"
#include "tern/grid.hpp"
#include "tern/map.hpp"
#include "tern/planner.hpp"
#include "tern/proof.hpp"
#include "tern/record.hpp"
#include "tern/self_test.hpp"
#include "tern/status.hpp"
#include "tern/track.hpp"
#include "tern/track_class.hpp"
#include "tern/track_proof.hpp"
#include "tern/trajectory.hpp"
#include "tern/yaw.hpp"

#endif
