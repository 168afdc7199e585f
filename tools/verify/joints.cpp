// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What holds at single instants: joints, both ends, vias.
#include <algorithm>

#include "verify/proofs.hpp"

namespace tern_verify {
namespace {

const Point kZero{};

/// On each axis, from the start to the centre of a voxel that it joins: up to two voxels on (docs/search.md).
const Rational kJoinedVoxels = Rational(5) / 2;

/// Position to jerk at a segment's beginning or end; positions relative to the plan's origin.
Motion motion_at(const Segment& segment, bool at_end) {
  Motion motion;
  Polygon<3> curve = segment.points;
  for (std::size_t k = 0; k < motion.size(); ++k) {
    motion[k] = at_end ? curve.back() : curve.front();
    curve = hodograph(curve, segment.duration);
  }
  return motion;
}

/// Only the scenario may allow it. A plan that is to end at the goal gains nothing by saying that it missed it.
bool ends_elsewhere(const Problem& problem, const Plan& plan) {
  return problem.may_end_near && plan.reachable.has_value();
}

/// A segment's beginning or end is in the state asked for, world frame. `name` is for the claims.
void prove_end(const Subject& subject, bool at_end, const std::string& name, Motion asked, Claims& claims) {
  const std::vector<Segment>& segments = subject.plan.segments;
  const Segment& segment = at_end ? segments.back() : segments.front();
  const Motion motion = motion_at(segment, at_end);
  asked[0] = asked[0] - subject.plan.origin;
  for (std::size_t k = 0; k < motion.size(); ++k) {
    const int derivative = static_cast<int>(k);
    const Rational tolerance = k == 0 ? subject.tolerance.place : joint_tolerance(segment, derivative);
    Tightest tightest(name + " " + kDerivativeNames[k], kUnits[k]);
    tightest.note(-largest_gap(motion[k], asked[k]), tolerance, [] { return ""; });
    claims.push_back(tightest.claim());
  }
}

/// The planner can end in any voxel that the start joins, so it never ends further from the goal than those are. How
/// near it could come depends on all paths, and is not proven.
void prove_no_further(const Subject& subject, Claims& claims) {
  const Problem& problem = subject.problem;
  const Point from_start = problem.goal[0] - problem.start[0];
  const Point from_end = problem.goal[0] - *subject.plan.reachable;
  const Rational gain = root_below(dot(from_start, from_start)) - root_above(dot(from_end, from_end));
  Tightest tightest("reachable distance", "m");
  tightest.note(gain, root_above(3) * kJoinedVoxels * problem.cell, [] { return ""; });
  claims.push_back(tightest.claim());
}

/// The state that a joint has, the end of the plan being one: that of the segment which begins there.
struct Passage {
  Motion motion;
  const Segment* segment;
};

Passage passage_at(const std::vector<Segment>& segments, std::size_t joint) {
  const bool at_end = joint == segments.size();
  const Segment& segment = at_end ? segments.back() : segments[joint];
  return {motion_at(segment, at_end), &segment};
}

/// Seconds at rest from a joint on: of segments whose control points are all the same.
Rational rested_from(const std::vector<Segment>& segments, std::size_t joint) {
  Rational rested = 0;
  for (std::size_t s = joint; s < segments.size(); ++s) {
    const auto& points = segments[s].points;
    const bool rests = std::all_of(points.begin(), points.end(), [&](const Point& p) { return p == points.front(); });
    if (!rests) break;
    rested += segments[s].duration;
  }
  return rested;
}

/// The tightest of what a via asks for, at one joint.
Claim via_claim(const Subject& subject, std::size_t index, std::size_t joint) {
  const Via& via = subject.problem.vias[index];
  const Passage passage = passage_at(subject.plan.segments, joint);
  Tightest tightest("via " + std::to_string(index + 1), "m");
  const Point gap = passage.motion[0] + subject.plan.origin - via.position;
  const auto place = [&] { return "joint " + std::to_string(joint); };
  tightest.note(via.tolerance - root_above(dot(gap, gap)), subject.tolerance.via, place);
  const auto holds = [&](std::size_t k, const Point& asked) {
    const auto what = [&] { return place() + ", " + kDerivativeNames[k] + " in " + kUnits[k]; };
    const Rational tolerance = joint_tolerance(*passage.segment, static_cast<int>(k));
    tightest.note(-largest_gap(passage.motion[k], asked), tolerance, what);
  };
  if (via.velocity) holds(1, *via.velocity);
  for (std::size_t k = 1; via.stop && k < passage.motion.size(); ++k) holds(k, kZero);
  if (via.dwell > 0) {
    const auto what = [&] { return place() + ", dwell in s"; };
    tightest.note(rested_from(subject.plan.segments, joint) - via.dwell, 0, what);
  }
  return tightest.claim();
}

}  // namespace

void prove_joints(const std::vector<Segment>& segments, Claims& claims) {
  for (std::size_t k = 0; k < std::tuple_size<Motion>::value; ++k) {
    Tightest tightest(std::string("joint ") + kDerivativeNames[k], kUnits[k]);
    for (std::size_t s = 1; s < segments.size(); ++s) {
      const int derivative = static_cast<int>(k);
      const Rational jump = largest_gap(motion_at(segments[s - 1], true)[k], motion_at(segments[s], false)[k]);
      const Rational tolerance =
          joint_tolerance(segments[s - 1], derivative) + joint_tolerance(segments[s], derivative);
      tightest.note(-jump, tolerance, [&] { return place_of(segments, s, 0); });
    }
    if (tightest.noted()) claims.push_back(tightest.claim());
  }
}

void prove_ends(const Subject& subject, Claims& claims) {
  prove_end(subject, false, "start", subject.problem.start, claims);
  if (!ends_elsewhere(subject.problem, subject.plan)) {
    prove_end(subject, true, "goal", subject.problem.goal, claims);
    return;
  }
  // Another name, so that nobody takes it for a proof that the goal was reached.
  prove_end(subject, true, "reachable", {*subject.plan.reachable, kZero, kZero, kZero}, claims);
  prove_no_further(subject, claims);
}

std::vector<std::string> assumed_of(const Problem& problem, const Plan& plan) {
  if (!ends_elsewhere(problem, plan)) return {};
  const Point gap = problem.goal[0] - *plan.reachable;
  return {"end at the plan's own 'reachable' point, " + text_above(root_above(dot(gap, gap))) +
          " m from the goal; not proven to be the nearest"};
}

/// The first joint that does is as good as any: later vias then have the most joints left.
void prove_vias(const Subject& subject, Claims& claims) {
  std::size_t joint = 0;
  const std::size_t last = subject.plan.segments.size();
  for (std::size_t v = 0; v < subject.problem.vias.size(); ++v) {
    Tightest best("via " + std::to_string(v + 1), "m");
    Claim found;
    for (std::size_t j = joint; j <= last; ++j) {
      Claim claim = via_claim(subject, v, j);
      const bool first = j == joint;
      const bool nearer = first || claim.least + claim.tolerance > found.least + found.tolerance;
      if (nearer) found = std::move(claim);
      if (found.verdict() != Verdict::kProven) continue;
      joint = j;
      break;
    }
    claims.push_back(found);
  }
}

}  // namespace tern_verify
