// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The same request again: in slices, on a fresh planner, and from states along its plan.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "attack/attack_case.hpp"

namespace tern_attack {

using tern::Status;

namespace {

void expect_same(Context& context, const char* kind, Status one, Status other) {
  ++context.tally.compared;
  if (one != other) {
    return report(context.findings, kind, "%s, then %s", tern::status_name(one), tern::status_name(other));
  }
  const Bench& b = context.bench;
  if (one == Status::kOk && !same_bits(b.trajectory, b.second)) {
    return report(context.findings, kind, "both ok, with other bits");
  }
  if (one != Status::kOk && !spoiled(b.second)) report(context.findings, "touched", "%s", kind);
}

std::uint32_t slice_of(Rng& rng) {
  constexpr std::uint32_t kSizes[] = {1, 1, 2, 7, 150, 0};
  const std::uint32_t size = rng.pick(kSizes);
  return size;
}

}  // namespace

void compare_slices(Context& context, const World& world, const Ask& ask, Status status) {
  tern::Planner planner(&context.bench.fresh_memory, sizeof(tern::Workspace));
  tern::Report answer;
  spoil(context.bench.second);
  const std::uint32_t size = slice_of(context.rng);
  Status sliced = planner.begin(world.grid, ask.request);
  for (int k = 0; k < 10000000 && sliced == Status::kRunning; ++k) {
    sliced = planner.step(size != 0 ? size : static_cast<std::uint32_t>(context.rng.integer(1, 300)));
  }
  const Status finished = planner.finish(context.bench.second, answer);
  if (finished != sliced) report(context.findings, "slices", "finish says %s", tern::status_name(finished));
  expect_same(context, "slices", status, finished);
}

void compare_fresh(Context& context, const World& world, const Ask& ask, Status status) {
  tern::Planner planner(&context.bench.fresh_memory, sizeof(tern::Workspace));
  tern::Report answer;
  spoil(context.bench.second);
  expect_same(context, "fresh", status, planner.plan(world.grid, ask.request, context.bench.second, answer));
}

void compare_kept(Context& context, tern::Planner& planner, const World& world, const Map& map, const Ask& ask,
                  Status status) {
  tern::Request other = ask.request;
  other.goal = {make_point(context.rng, world, map), {0, 0, 0}, {0, 0, 0}};
  other.budget = tern::Budget{};
  tern::Report answer;
  (void)planner.plan(world.grid, other, context.bench.second, answer);
  spoil(context.bench.second);
  expect_same(context, "kept", status, planner.plan(world.grid, ask.request, context.bench.second, answer));
}

namespace {

constexpr double kNoLater = 2e-6;  // seconds: as promised, and rounding

bool is_zero(const tern::Vec3& v) {
  return v.x == 0.0 && v.y == 0.0 && v.z == 0.0;
}

double moment(Rng& rng, const tern::Trajectory& trajectory) {
  const double end = tern::duration(trajectory);
  const double u = rng.unit();
  if (u < 0.05) return 0.0;
  if (u < 0.1) return trajectory.segments[0].duration;
  if (u < 0.2) return end * (1.0 - std::pow(10.0, -rng.real(1.0, 9.0)));
  return end * rng.unit();
}

/// Less than a millisecond before a joint of two segments; the beginning where the plan has no joint.
double just_before_joint(Rng& rng, const tern::Trajectory& trajectory) {
  const int joint = rng.integer(0, trajectory.count - 1);
  double time = 0.0;
  for (int i = 0; i < joint; ++i) time += trajectory.segments[i].duration;
  return std::max(0.0, time - std::pow(10.0, -rng.real(3.0, 9.0)));
}

/// From the state at t to the same goal or a new one.
void make_replan(Context& context, const World& world, const Map& map, const Ask& ask, const tern::Trajectory& plan,
                 double t, bool new_goal, Ask& next) {
  const tern::Sample s = tern::evaluate(plan, t);
  next.fences = ask.fences;
  next.request = ask.request;
  next.request.fences = next.fences.empty() ? nullptr : next.fences.data();
  next.request.start = {s.position, s.velocity, s.acceleration, {0.0, 0.0, 0.0}};
  if (side_stream(context.rng).chance(0.5)) next.request.start.jerk = s.jerk;
  next.request.budget = tern::Budget{};
  if (new_goal) next.request.goal = {make_point(context.rng, world, map), {0, 0, 0}, {0, 0, 0}};
}

bool goal_moves(const Ask& ask) {
  const tern::State& goal = ask.request.goal;
  return !is_zero(goal.velocity) || !is_zero(goal.acceleration) || !is_zero(goal.jerk);
}

/// True less than a millisecond before the end of a segment.
bool ends_soon(const tern::Trajectory& plan, double t) {
  double end = 0.0;
  for (int i = 0; i < plan.count && end <= t; ++i) end += plan.segments[i].duration;
  return end - t < 1e-3;
}

/// True where no control point is more than a kilometre from the plan's origin.
bool is_local(const tern::Trajectory& plan) {
  double most = 0.0;
  for (int i = 0; i < plan.count; ++i) {
    for (const tern::Vec3& p : plan.segments[i].points) {
      most = std::max({most, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    }
  }
  return most <= 1000.0;
}

/// True where the planner promises a plan.
bool proves(const tern::Trajectory& plan, double t, bool new_goal) {
  const double left = tern::duration(plan) - t;
  return new_goal ? left >= 1e-3 && (is_local(plan) || !ends_soon(plan, t)) : left > 0.0;
}

/// The rest of the previous plan is that plan, bit for bit.
void expect_same_curve(Context& context, const tern::Trajectory& plan, const char* kind) {
  tern::Trajectory same = plan;
  for (int i = 0; i < same.count; ++i) same.segments[i].polyhedron = tern::kNoPolyhedron;
  if (same_bits(same, context.bench.trajectory)) return;
  report(context.findings, (std::string(kind) + "rounded").c_str(), "the rest has other bits than the previous plan");
}

/// Whether the grid promises a plan to the new goal by way of the first one. From rest it promises no more than to any
/// request, which is judged already.
bool is_promised(const World& world, const Map& map, const Ask& ask, const Ask& next) {
  const tern::State& start = next.request.start;
  return ask.fences.empty() && !(is_zero(start.velocity) && is_zero(start.acceleration)) &&
         share_one(reachable(world, map.component, world.local(ask.request.goal.position)),
                   reachable(world, map.component, world.local(next.request.goal.position)));
}

/// A plan to the same goal arrives no later than the rest of the previous one (docs/moving_ends.md).
void expect_no_later(Context& context, const tern::Trajectory& plan, double t, const char* kind) {
  const double rest = tern::duration(plan) - t;
  const double now = tern::duration(context.bench.trajectory) - context.bench.entered;
  if (now <= rest + kNoLater) return;
  report(context.findings, (std::string(kind) + "later").c_str(), "%.17g s instead of %.17g from t %.17g", now, rest,
         t);
}

void ask_with_previous(Context& context, tern::Planner& planner, const World& world, const Map& map, Ask& next,
                       const tern::Trajectory& plan, double t, bool new_goal, const char* kind) {
  next.request.previous = &plan;
  next.request.previous_time = t;
  const Status status = ask_once(context, planner, world, map, next, "replan with the previous plan");
  if (status == Status::kOk && context.bench.entered > 0.0) expect_same_curve(context, plan, kind);
  if (is_capacity(status) || !proves(plan, t, new_goal)) return;
  if (status == Status::kOk) {
    if (!new_goal) expect_no_later(context, plan, t, kind);
    return;
  }
  const std::string name = std::string(kind) + tern::status_name(status);
  report(context.findings, name.c_str(), "from t %.17g of %.17g", t, tern::duration(plan));
}

void replan_once(Context& context, tern::Planner& planner, const World& world, const Map& map, const Ask& ask,
                 const tern::Trajectory& plan, double t) {
  // Behind a goal in motion nothing is promised: from there no other goal may be in reach.
  const bool new_goal = context.rng.chance(0.25) && !goal_moves(ask);
  Ask next;
  make_replan(context, world, map, ask, plan, t, new_goal, next);
  ++context.tally.replans;
  const std::size_t before = context.findings.size();
  const Status status = ask_once(context, planner, world, map, next, new_goal ? "replan to a new goal" : "replan");
  if (context.verbose) std::printf("  at t %.17g of %.17g\n", t, tern::duration(plan));
  if (status == Status::kOk || is_capacity(status) || context.findings.size() != before) return;
  if (new_goal && !is_promised(world, map, ask, next)) return;
  ++context.tally.needed;
  ask_with_previous(context, planner, world, map, next, plan, t, new_goal, new_goal ? "replan_new_goal_" : "replan_");
}

/// With the previous plan from the beginning, in slices, too.
void replan_along(Context& context, tern::Planner& planner, const World& world, const Map& map, const Ask& ask,
                  const tern::Trajectory& plan, double t) {
  Ask next;
  make_replan(context, world, map, ask, plan, t, false, next);
  if (context.rng.chance(0.5)) next.request.budget.search = 0;
  const std::size_t before = context.findings.size();
  ask_with_previous(context, planner, world, map, next, plan, t, false, "replan_along_");
  if (context.findings.size() == before && !spoiled(context.bench.trajectory)) {
    compare_slices(context, world, next, Status::kOk);
  }
}

}  // namespace

void replan(Context& context, tern::Planner& planner, const World& world, const Map& map, const Ask& ask) {
  context.bench.untouched = context.bench.trajectory;
  const int count = context.rng.integer(1, 2);
  const tern::Trajectory& plan = context.bench.untouched;
  for (int k = 0; k < count; ++k) {
    replan_once(context, planner, world, map, ask, plan, moment(context.rng, plan));
  }
  Rng own = side_stream(context.rng);
  if (context.rng.chance(0.1)) replan_along(context, planner, world, map, ask, plan, moment(context.rng, plan));
  if (own.chance(0.1)) replan_along(context, planner, world, map, ask, plan, just_before_joint(own, plan));
}

}  // namespace tern_attack
