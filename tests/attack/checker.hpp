// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The independent checker: what an ok plan must be, from the request, the record of obstacles and the trajectory alone.
#ifndef TERN_TESTS_ATTACK_CHECKER_HPP
#define TERN_TESTS_ATTACK_CHECKER_HPP

#include <string>
#include <vector>

#include "attack/curve.hpp"
#include "attack/world.hpp"

namespace tern_attack {

/// One broken promise: a short name to count by, and the figures.
struct Finding {
  std::string kind;
  std::string detail;
};
using Findings = std::vector<Finding>;

/// A finding with its figures in the form of printf.
__attribute__((format(printf, 3, 4))) void report(Findings& findings, const char* kind, const char* format, ...);

// Tolerances; docs/attack.md says where each comes from. What a double that is stored in the trajectory can hold comes
// on top: `rounding` below.
constexpr Real kClearanceSlack = 2e-7L;  ///< metres: a polyhedron's 1e-7 and a control point's 1e-7 (docs/check.md)
constexpr Real kBoundarySlack = 1e-7L;   ///< metres, boundary and keep-ins
constexpr Real kLimitSlack = 1e-7L;      ///< of the limit
constexpr Real kJointSlack = 1e-7L;      ///< of 1 + value, derivatives at joints and ends
constexpr Real kPositionSlack = 1e-9L;   ///< metres, start, goal and joints
constexpr Real kEndJerkSlack = 1e-5L;    ///< m/s^3, jerk at both ends

/// What rounding the control points to doubles does to the derivative of this order: the spacing of the largest
/// coordinate, as often as control points enter, over the duration's power.
Real rounding(const tern::Segment& segment, int order);

/// Where the trajectory's points lie in the grid's local frame.
Point shift_of(const World& world, const tern::Trajectory& trajectory);

void check_obstacles(const World& world, const tern::Trajectory& trajectory, Findings& findings);
void check_boundary(const World& world, const tern::Trajectory& trajectory, Findings& findings);
void check_fences(const World& world, const tern::Request& request, const tern::Trajectory& trajectory,
                  Findings& findings);
void check_limits(const tern::Request& request, const tern::Trajectory& trajectory, Findings& findings);
void check_joints(const tern::Trajectory& trajectory, Findings& findings);
void check_ends(const World& world, const tern::Request& request, const tern::Trajectory& trajectory,
                Findings& findings);
/// evaluate() and duration() against the control points, at `samples` times from `rng`.
void check_evaluate(Rng& rng, const World& world, const tern::Trajectory& trajectory, int samples, Findings& findings);

/// All of the above; nothing but the first where the trajectory is malformed.
void check_plan(Rng& rng, const World& world, const tern::Request& request, const tern::Trajectory& trajectory,
                Findings& findings);

}  // namespace tern_attack

#endif
