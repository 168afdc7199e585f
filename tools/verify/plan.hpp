// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a plan file claims, in exact numbers.
#ifndef TERN_VERIFY_PLAN_HPP
#define TERN_VERIFY_PLAN_HPP

#include <optional>
#include <string>
#include <vector>

#include "verify/bezier.hpp"
#include "verify/problem.hpp"

namespace tern_verify {

struct Segment {
  Polygon<3> points;  ///< relative to the plan's origin
  Rational duration;
};

/// When a plan begins, on the scenario's clock.
struct Begin {
  Rational seconds;  ///< whole nanoseconds
  std::string text;  ///< the same in digits, for messages
};

struct Plan {
  std::string name;
  Point origin;  ///< world frame
  std::vector<Segment> segments;
  std::optional<Point> reachable;  ///< where the plan ends if not at the goal
  std::optional<Begin> begin;      ///< none in files of earlier versions where nothing depends on time
  std::optional<Problem> asked;    ///< what the file says that it was made for: asked_of()
};

/// Reads a plan file ("tern-plan/1", docs/formats.md) with a trajectory. Throws InputError, also where the file's two
/// sets of control points are not the same curve.
Plan parse_plan(const std::string& text, const std::string& name);

/// Throws InputError where the file says that the plan was made for anything else than the scenario.
void require_same_request(const Problem& scenario, const Plan& plan);

}  // namespace tern_verify

#endif
