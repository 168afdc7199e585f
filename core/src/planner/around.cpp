// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planner/around.hpp"

#include "base/math.hpp"
#include "curve/bezier.hpp"
#include "curve/rest.hpp"

namespace tern {
namespace {

/// Gives the chain the segments of the seed.
void follow_seed(const Trajectory& seed, double slack, Chain& chain) {
  chain.count = seed.count;
  for (int i = 0; i < seed.count; ++i) {
    const Segment& segment = seed.segments[i];
    chain.polyhedron[i] = segment.polyhedron;
    chain.length[i] = distance(segment.points[0], segment.points[kDegree]);
    chain.duration[i] = larger(kMinDuration, slack * segment.duration);
  }
  place_via_joints(chain);
}

/// Seconds that the goal is to stay clear.
double rest_at_goal(const Problem& problem) {
  return at_rest(problem.asked.goal) ? problem.asked.rest_clear : 0.0;
}

/// Where the plan rests besides: while it stops first, and at its vias.
void set_pauses(const Problem& problem, const EndStop& start_stop, const Chain& chain, Scene& scene) {
  for (double& pause : scene.pause) pause = 0.0;
  for (int i = 0; i < start_stop.count; ++i) scene.pause[0] += start_stop.segments[i].duration;
  for (int v = 0; v < chain.via_joint_count; ++v) {
    scene.pause[chain.via_joints[v].segment] += problem.vias[v].dwell;
  }
}

}  // namespace

void keep(const Path& path, const ViaMarks& marks, const Corridor& corridor, Kept& kept) noexcept {
  kept.marks = marks;
  kept.corridor = corridor;
  kept.points = path.count;
  for (int i = 0; i < path.count; ++i) kept.path[i] = path.points[i];
  kept.length = path.length;
}

void bring_back(const Kept& kept, Path& path, ViaMarks& marks, Corridor& corridor) noexcept {
  marks = kept.marks;
  corridor = kept.corridor;
  path.count = kept.points;
  for (int i = 0; i < path.count; ++i) path.points[i] = kept.path[i];
  path.length = kept.length;
}

void halve_segments(const Trajectory& alone, int most, Trajectory& seed) noexcept {
  seed.count = 0;
  for (int i = 0; i < alone.count; ++i) {
    Segment& segment = seed.segments[seed.count++];
    segment = alone.segments[i];
    const int needed = seed.count + alone.count - 1 - i;
    if (!(segment.duration > kLongestWhole) || needed >= most) continue;
    Curve first = curve_of(segment);
    const Curve second = split(first);
    segment.duration *= 0.5;
    Segment& half = seed.segments[seed.count++];
    half = segment;
    for (int k = 0; k < kControlPoints; ++k) {
      segment.points[k] = first.c[k];
      half.points[k] = second.c[k];
    }
  }
}

Progress look_at_goal(const Problem& problem, const Ends& ends, Around& around, Work& work) noexcept {
  const Things things = things_of(problem, problem.asked.start.position);
  const double rest = rest_at_goal(problem);
  const double first = kSoonestArrival * around.alone;
  const double step = ((kLongestFlood - kSoonestArrival) * around.alone + rest) / kGoalInstants;
  if (around.instant == 0) around.soonest = first;
  for (; around.instant <= kGoalInstants; ++around.instant) {
    if (!work.left()) return Progress::kMore;
    const double time = first + around.instant * step;
    Operations spent = ops::kPiece;
    bool is_covered = false;
    for (std::int32_t j = 0; j < things.count && !is_covered; ++j) {
      const Track& track = things.tracks[j];
      spent += ops::kPiece + ops::kTurn * track.piece_count;
      is_covered = is_too_near(things, track, ends.goal.position, time);
    }
    work.spend(spent);
    around.latest = time - step - rest;
    if (is_covered && around.latest >= around.soonest) return Progress::kDone;
    if (is_covered) around.soonest = time + step;
    if (around.latest >= larger(around.soonest, kAroundSlack * around.alone)) return Progress::kDone;
  }
  return Progress::kDone;
}

double first_slack(const Around& around) noexcept {
  return smaller(kAroundSlack, around.latest / around.alone);
}

void around_begin(const Problem& problem, const Ends& ends, const EndStop& start_stop, const Trajectory& seed,
                  double slack, CurveMemory& memory) noexcept {
  follow_seed(seed, slack, memory.chain);
  Scene& scene = memory.scene;
  scene.things = things_of(problem, problem.asked.start.position);
  scene.reference = &seed;
  scene.rest = rest_at_goal(problem);
  set_pauses(problem, start_stop, memory.chain, scene);
  TrajectoryQuery query{ends.start, ends.goal, problem.limits, problem.asked.time_weight};
  query.scene = &scene;
  trajectory_begin(memory.stage, memory.corridor, query, memory.chain);
}

}  // namespace tern
