// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "attack/attack_case.hpp"

#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>

#include "attack/emptiness.hpp"

namespace tern_attack {

using tern::Status;

void spoil(tern::Trajectory& trajectory) {
  std::memset(static_cast<void*>(&trajectory), 0x5A, sizeof trajectory);
}

bool spoiled(const tern::Trajectory& trajectory) {
  static const tern::Trajectory kPattern = [] {
    tern::Trajectory pattern;
    spoil(pattern);
    return pattern;
  }();
  return std::memcmp(&trajectory, &kPattern, sizeof kPattern) == 0;
}

bool same_bits(const tern::Trajectory& a, const tern::Trajectory& b) {
  if (a.count != b.count || std::memcmp(&a.origin, &b.origin, sizeof a.origin) != 0) return false;
  for (int s = 0; s < a.count; ++s) {
    const tern::Segment& p = a.segments[s];
    const tern::Segment& q = b.segments[s];
    if (p.polyhedron != q.polyhedron || std::memcmp(p.points, q.points, sizeof p.points) != 0) return false;
    if (std::memcmp(&p.duration, &q.duration, sizeof p.duration) != 0) return false;
  }
  return true;
}

void print_ask(const World& world, const Ask& ask) {
  const tern::GridSpec& s = world.spec;
  const tern::Request& r = ask.request;
  const auto line = [](const char* name, const tern::Vec3& v) {
    std::printf("  %s %.17g %.17g %.17g\n", name, v.x, v.y, v.z);
  };
  std::printf("  cell %.17g dims %d %d %d radius %.17g solid %d\n", s.cell, s.dims.x, s.dims.y, s.dims.z, s.radius,
              static_cast<int>(std::count(world.solid.begin(), world.solid.end(), 1)));
  line("origin", s.origin);
  line("boundary lower", s.boundary.lower);
  line("boundary upper", s.boundary.upper);
  line("start", r.start.position);
  line("start velocity", r.start.velocity);
  line("start acceleration", r.start.acceleration);
  line("start jerk", r.start.jerk);
  line("goal", r.goal.position);
  line("goal velocity", r.goal.velocity);
  line("goal acceleration", r.goal.acceleration);
  line("goal jerk", r.goal.jerk);
  line("v_max", r.limits.v_max);
  line("a_max", r.limits.a_max);
  line("v_min", r.limits.v_min);
  line("a_min", r.limits.a_min);
  line("j_max", r.limits.j_max);
  std::printf("  v_horizontal %.17g a_horizontal %.17g j_horizontal %.17g weight %.17g budget %u %u %u %u\n",
              r.limits.v_horizontal, r.limits.a_horizontal, r.limits.j_horizontal, r.time_weight, r.budget.search,
              r.budget.shortcut, r.budget.corridor, r.budget.trajectory);
  std::printf("  thrust_max %.17g thrust_min %.17g tilt_tangent %.17g rate_max %.17g\n", r.limits.thrust_max,
              r.limits.thrust_min, r.limits.tilt_tangent, r.limits.rate_max);
  for (const tern::Via& via : ask.vias) {
    line("via", via.position);
    std::printf("    tolerance %.17g%s dwell %.17g\n", via.tolerance, via.stop ? " stop" : "", via.dwell);
    if (via.has_velocity) line("  velocity", via.velocity);
  }
  for (const tern::Fence& fence : ask.fences) {
    std::printf("  %s\n", fence.kind == tern::FenceKind::kKeepIn ? "keep-in" : "keep-out");
    for (int k = 0; k < fence.count; ++k) {
      const tern::Halfspace& h = fence.planes[k];
      std::printf("    %.17g %.17g %.17g %.17g\n", h.normal.x, h.normal.y, h.normal.z, h.offset);
    }
  }
}

/// What the check refused, of the plan's last attempt.
void print_check(const tern::ProofReport& check) {
  if (check.finding == tern::Finding::kNone) return;
  std::printf("  check: %s at %.17g s, segment %d, fence %d, derivative %d, axis %d, voxel %d %d %d, excess %.17g\n",
              tern::finding_name(check.finding), check.until, check.segment, check.fence, check.derivative, check.axis,
              check.voxel.x, check.voxel.y, check.voxel.z, check.excess);
}

Status ask_once(Context& context, tern::Planner& planner, const World& world, const Map& map, const Ask& ask,
                const char* what) {
  tern::Report answer;
  tern::Trajectory& out = context.bench.trajectory;
  spoil(out);
  const Status status = planner.plan(world.grid, ask.request, out, answer);
  if (context.verbose) {
    std::printf("%s: %s (stage %s, quality %d, optimiser %s, detours %d, polyhedra %d)\n", what,
                tern::status_name(status), tern::stage_name(answer.stage), static_cast<int>(answer.quality),
                tern::status_name(answer.optimiser), answer.diagnostics.detours,
                planner.corridor() != nullptr ? planner.corridor()->count : 0);
    print_check(answer.check);
    print_ask(world, ask);
  }
  if (status == Status::kOk) {
    check_plan(context.rng, world, ask.request, out, answer.entered, context.findings);
    check_vias(world, ask.request, out, answer, context.findings);
  } else if (!spoiled(out)) {
    report(context.findings, "touched", "%s: the output changed with %s", what, tern::status_name(status));
  }
  context.bench.entered = answer.entered;
  judge(context, world, map, ask, answer, status, what);
  return status;
}

void thin_out(const Bench& bench, World& world) {
  if (bench.only != nullptr) keep_only(*bench.only, world);
  if (bench.write != nullptr) *bench.write = runs_of(world);
}

void check_layers(const World& world, const Map& map, Findings& findings) {
  for (int i = 0; i < world.count(); ++i) {
    const tern::Voxel v = world.voxel(i);
    const auto at = static_cast<std::size_t>(i);
    if (world.grid.obstacle(v) != (world.solid[at] != 0)) {
      return report(findings, "obstacle_layer", "voxel (%d, %d, %d) is %d", v.x, v.y, v.z, world.solid[at]);
    }
    if (map.layer[at] != Space::kEither && world.grid.free(v) != (map.layer[at] == Space::kFree)) {
      return report(findings, "c5", "voxel (%d, %d, %d) should be %s", v.x, v.y, v.z,
                    map.layer[at] == Space::kFree ? "free" : "blocked");
    }
  }
}

namespace {

double distance(const tern::Vec3& a, const tern::Vec3& b) {
  return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z));
}

/// No voxel that is connected to the start's is nearer to the goal than the point that is given out. Voxels at the same
/// distance but for the rounding of world coordinates are a tie.
void check_reachable(const World& world, const Map& map, const Ask& ask, const tern::Report& answer,
                     Findings& findings) {
  const tern::Grid& grid = world.grid;
  const tern::Vec3 goal = grid.to_local(ask.request.goal.position);
  const tern::Voxel home = grid.voxel_of(grid.to_local(ask.request.start.position));
  const tern::Voxel there = free_voxel_at(world, answer.reachable);
  if (there.x < 0) return report(findings, "near", "its voxel is not free");
  if (!ask.fences.empty() || !grid.free(home)) return;
  const int own = map.component[static_cast<std::size_t>(world.index(home.x, home.y, home.z))];
  const Real places = 4 * kUlp * (largest(point(world.spec.origin)) + largest(point(ask.request.goal.position)));
  const double tie = 1e-9 * world.spec.cell + static_cast<double>(places);
  const double found = distance(grid.center(there), goal);
  for (const int i : map.free) {
    if (own < 0 || map.component[static_cast<std::size_t>(i)] != own) continue;
    if (distance(grid.center(world.voxel(i)), goal) >= found - tie) continue;
    const tern::Voxel v = world.voxel(i);
    return report(findings, "near", "(%d, %d, %d) is nearer than (%d, %d, %d)", v.x, v.y, v.z, there.x, there.y,
                  there.z);
  }
}

}  // namespace

void go_near(Context& context, tern::Planner& planner, const World& world, const Map& map, Ask& ask) {
  ask.request.goal_mode = tern::GoalMode::kNearest;
  tern::Report answer;
  tern::Trajectory& out = context.bench.trajectory;
  spoil(out);
  const Status status = planner.plan(world.grid, ask.request, out, answer);
  if (answer.has_reachable) check_reachable(world, map, ask, answer, context.findings);
  tern::Request near = ask.request;
  if (answer.goal_missed != Status::kOk) near.goal = {answer.reachable, {}, {}, {}};
  if (status == Status::kOk) return check_plan(context.rng, world, near, out, 0.0, context.findings);
  const bool lost = status == Status::kNoPath || status == Status::kCorridorBlocked || status == Status::kCheckFailed ||
                    status == Status::kNoTrajectory;
  const tern::Voxel home = world.grid.voxel_of(world.grid.to_local(ask.request.start.position));
  if (ask.rest_to_rest() && ask.unlimited_search() && lost && world.grid.free(home)) {
    report(context.findings, "near", "%s at %s", tern::status_name(status), tern::stage_name(answer.stage));
  }
}

namespace {

/// Part of the cases whose request is asked again with vias.
constexpr double kMissions = 0.3;
/// Part of the cases whose request is asked again among things that move.
constexpr double kAmongThings = 0.2;
/// Part of the cases that make one more world, with a boundary or a keep-in thinner than a voxel.
constexpr double kFlat = 0.25;
constexpr int kDrawsOfThings = 4;

/// The same request through vias. `own`: what is left of the case draws nothing from it.
void run_mission(Context& context, Rng& own, tern::Planner& planner, const World& world, const Map& map,
                 const Ask& ask) {
  Ask mission;
  make_mission(own, world, map, ask, mission);
  const Status status = ask_once(context, planner, world, map, mission, "mission");
  if (own.chance(0.1)) compare_slices(context, world, mission, status);
}

/// Nothing but the same request, again and again among other things that move. `status`: of the plan that is there.
void run_among_things(Context& context, tern::Planner& planner, const World& world, const Ask& ask, Status status) {
  Rng own = side_stream(context.rng);
  const auto alone = std::make_unique<tern::Trajectory>(context.bench.trajectory);
  for (int k = 0; k < kDrawsOfThings; ++k) {
    context.bench.trajectory = *alone;
    attack_tracks(context, own, planner, world, ask, status);
  }
}

void run_plans(Context& context) {
  World world;
  make_world(context.rng, context.family, world);
  thin_out(context.bench, world);
  const Status bound = bind_and_mark(context.rng, world);
  if (bound != Status::kOk) return report(context.findings, "bind", "%s", tern::status_name(bound));
  const Map map = map_of(world);
  check_layers(world, map, context.findings);
  Ask ask;
  make_request(context.rng, context.family, world, map, ask);
  tern::Planner planner(&context.bench.kept_memory, sizeof(tern::Workspace));
  const Status status = ask_once(context, planner, world, map, ask, "plan");
  if (context.bench.things) return run_among_things(context, planner, world, ask, status);
  const bool slices = context.rng.chance(0.12);
  const bool kept = context.rng.chance(0.08);
  const bool again = context.rng.chance(0.4);
  if (slices) compare_slices(context, world, ask, status);
  if (kept) compare_kept(context, planner, world, map, ask, status);
  if (again && status == Status::kOk) replan(context, planner, world, map, ask);
  Rng own = side_stream(context.rng);
  if (own.chance(kMissions)) run_mission(context, own, planner, world, map, ask);
  const bool missed = status == Status::kNoPath || status == Status::kGoalOccupied ||
                      status == Status::kGoalTooNarrow || status == Status::kGoalFenced;
  if (missed) go_near(context, planner, world, map, ask);
  if (own.chance(context.family == Family::kFences ? 0.5 : 0.05)) attack_fences(context, own, planner, world, ask);
  if (own.chance(kFlat)) attack_flat(context, own);
  if (!missed && own.chance(kAmongThings)) {
    const Status alone = ask_once(context, planner, world, map, ask, "again");
    attack_tracks(context, own, planner, world, ask, alone);
  }
}

}  // namespace

void run_case(Bench& bench, std::uint64_t seed, std::uint64_t number, bool verbose, Tally* tallies,
              Findings& findings) {
  Rng rng = rng_of(seed, number);
  const Family family = family_of(number);
  Context context{bench, rng, family, tallies[static_cast<int>(family)], findings, verbose};
  ++context.tally.cases;
  if (family == Family::kChanges && !bench.things) {
    run_changes(context);
  } else {
    run_plans(context);
  }
}

}  // namespace tern_attack
