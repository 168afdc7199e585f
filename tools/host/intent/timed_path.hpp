// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where a plan is at which time: what an operational intent is made of.
#ifndef TERN_HOST_INTENT_TIMED_PATH_HPP
#define TERN_HOST_INTENT_TIMED_PATH_HPP

#include <array>
#include <string>
#include <vector>

#include "host/session.hpp"

namespace tern_host {

/// A Bezier curve of degree 7. World frame, metres; seconds of the scenario's clock.
struct PathPiece {
  double begin;
  double end;
  std::array<tern::Vec3, tern::kControlPoints> points;
};

/// A plan's whole way, without gaps.
struct TimedPath {
  std::string name;  ///< of the file or the scenario
  std::vector<PathPiece> pieces;
  double radius;       ///< of the tube about the way that the vehicle stays in: radius and tracking margin, m
  EarthFrame earth{};  ///< where the world frame is, if the plan says so
  double rest = 0.0;   ///< for how long the vehicle stays at the end, as the plan says, s; not in the pieces
};

/// Of a plan file ("tern-plan/1", docs/formats.md). Throws RecordError.
TimedPath read_timed_path(const std::string& path);

/// The same of its text; `name` is for messages.
TimedPath parse_timed_path(const std::string& text, const std::string& name);

/// Of a plan that is ok().
TimedPath timed_path_of(const PlanResult& result);

/// The way with a rest of `seconds` > 0 at its end.
TimedPath with_rest(TimedPath path, double seconds);

}  // namespace tern_host

#endif
