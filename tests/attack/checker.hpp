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
constexpr Real kContactSlack = 1e-9L;  ///< metres, or voxels where those are larger: a half-space, a control point
constexpr Real kLimitSlack = 3e-8L;    ///< of the limit
constexpr Real kLimitUlps = 16;        ///< the same for limits: the check forgives 8, and its arithmetic is good to 8
constexpr Real kPointUlps = 32;  ///< units in the last place of a control point, for derivatives at joints and ends

/// kContactSlack in this world, and what its coordinates cannot tell apart, world and local ones.
Real contact_slack(const World& world);

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
/// Thrust, tilt and body rates.
void check_vehicle(const tern::Request& request, const tern::Trajectory& trajectory, Findings& findings);
/// True if the acceleration keeps the limits of thrust and tilt, and if the jerk there keeps that of body rates.
bool keeps_vehicle(const tern::Limits& limits, const Point& acceleration, Real excess, Real rounding);
bool turns_slowly(const tern::Limits& limits, const Point& acceleration, const Point& jerk);
void check_joints(const tern::Trajectory& trajectory, Findings& findings);
/// `entered`: when the plan enters the trajectory, seconds since its beginning.
void check_ends(const World& world, const tern::Request& request, const tern::Trajectory& trajectory, double entered,
                Findings& findings);
/// The plan passes the vias when the report says, in order, as near as asked, and at rest or with the velocity asked
/// for.
void check_vias(const World& world, const tern::Request& request, const tern::Trajectory& trajectory,
                const tern::Report& answer, Findings& findings);
/// The plan keeps clear of the request's tracks until `until`, seconds since its beginning. If it may leave those that
/// it begins too near to, it must come no nearer to them for that long, or until kLeaveTime.
void check_tracks(const World& world, const tern::Request& request, const tern::Trajectory& plan, double until,
                  bool may_leave, const char* what, Findings& findings);
/// evaluate() and duration() against the control points, at `samples` times from `rng`.
void check_evaluate(Rng& rng, const World& world, const tern::Trajectory& trajectory, int samples, Findings& findings);

/// All of the above; nothing but the first where the trajectory is malformed. The world, the fences and the limits are
/// those that the trajectory was made for, so they hold for all of it, wherever the plan enters it.
void check_plan(Rng& rng, const World& world, const tern::Request& request, const tern::Trajectory& trajectory,
                double entered, Findings& findings);

}  // namespace tern_attack

#endif
