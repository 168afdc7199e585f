// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Boundaries and keep-ins that are thinner than a voxel: without height, on a voxel's face, in its middle or anywhere.
// A keep-in in a boundary of any size is planned in like a boundary of the keep-in's size.
#include <cmath>

#include "attack/attack_case.hpp"

namespace tern_attack {
namespace {

using tern::Status;

/// Faces are on the lattice, or so many cells off it.
constexpr double kOff = 0.01;

/// Where the thin side begins, in cells.
double place_of_face(Rng& rng, int count) {
  const double u = rng.unit();
  if (u < 0.4) return rng.integer(0, count);
  const double off = u < 0.6 ? 0.5 : rng.real(kOff, 1.0 - kOff);
  return rng.integer(0, count - 1) + off;
}

/// So high that no whole voxel fits, in cells; its upper face is on the lattice or well off it, too.
double height_at(Rng& rng, double from) {
  if (rng.chance(0.4)) return 0.0;
  const double off = from - std::floor(from);
  const double most = off > 0.0 ? 2.0 - off : 1.0;
  const double height = rng.chance(0.2) && off > 0.0 ? 1.0 - off : rng.real(kOff, most - kOff);
  const double over = from + height - std::round(from + height);
  return std::fabs(over) < kOff ? std::round(from + height) - from : height;
}

bool is_thin(const World& world, int a) {
  return axis(world.spec.boundary.upper, a) - axis(world.spec.boundary.lower, a) < 2.0 * world.spec.cell;
}

/// Makes the boundary thin on an axis, seldom on two.
void flatten(Rng& rng, World& world) {
  tern::GridSpec& spec = world.spec;
  const int thin = rng.integer(0, 2);
  for (int a = 0; a < 3; ++a) {
    if (a != thin && !rng.chance(0.08)) continue;
    const int count = axis(spec.dims, a);
    const double from = place_of_face(rng, count);
    const double to = std::min(static_cast<double>(count), from + height_at(rng, from));
    axis(spec.boundary.lower, a) = axis(spec.origin, a) + from * spec.cell;
    axis(spec.boundary.upper, a) = axis(spec.origin, a) + to * spec.cell;
  }
}

/// The same obstacles in the whole grid as boundary, or in one that cuts voxels around the thin one.
void widen(Rng& rng, const World& thin, World& whole) {
  whole.spec = thin.spec;
  whole.solid = thin.solid;
  for (int a = 0; a < 3; ++a) {
    const double floor = axis(thin.spec.origin, a);
    const double ceiling = floor + axis(thin.spec.dims, a) * thin.spec.cell;
    double& lower = axis(whole.spec.boundary.lower, a);
    double& upper = axis(whole.spec.boundary.upper, a);
    if (rng.chance(0.8)) lower = rng.chance(0.6) ? floor : std::min(lower, rng.real(floor, lower));
    if (rng.chance(0.8)) upper = rng.chance(0.6) ? std::max(upper, ceiling) : std::max(upper, rng.real(upper, ceiling));
  }
}

/// The thin boundary as a keep-in of the request; tilted about the start where `tilt` is not 0.
void keep_in(Rng& rng, const World& thin, double tilt, Ask& ask) {
  tern::Halfspace faces[tern::kBoxPlanes];
  tern::box_planes(thin.spec.boundary, faces);
  std::vector<tern::Halfspace> planes(faces, faces + tern::kBoxPlanes);
  const tern::Vec3& p = ask.request.start.position;
  for (tern::Halfspace& plane : planes) {
    const double size = std::ldexp(1.0, rng.integer(-10, 10));  // exact: rounded offsets may leave no point
    tern::Vec3 n = plane.normal;
    const double depth = plane.offset - (n.x * p.x + n.y * p.y + n.z * p.z);
    if (tilt > 0.0) n = {n.x + tilt * n.y, n.y + tilt * n.z, n.z + tilt * n.x};
    plane.normal = {size * n.x, size * n.y, size * n.z};
    plane.offset *= size;
    if (tilt > 0.0) plane.offset = size * (n.x * p.x + n.y * p.y + n.z * p.z + depth);
  }
  ask.planes.push_back(std::move(planes));
  const std::vector<tern::Halfspace>& kept = ask.planes.back();
  ask.fences.push_back({kept.data(), static_cast<std::int32_t>(kept.size()), tern::FenceKind::kKeepIn});
  ask.request.fences = ask.fences.data();
  ask.request.fence_count = static_cast<std::int32_t>(ask.fences.size());
}

/// The request with the keep-in in the wide boundary. From rest to rest it has a plan just where it has one in the thin
/// boundary, where the answer was `status`.
void ask_fenced(Context& context, tern::Planner& planner, const World& thin, const Map& map, const World& whole,
                const Ask& ask, Status status) {
  Ask fenced;
  fenced.request = ask.request;
  fenced.vias = ask.vias;
  fenced.request.vias = fenced.vias.empty() ? nullptr : fenced.vias.data();
  fenced.fences = ask.fences;
  const double tilt = context.rng.chance(0.8) ? 0.0 : std::pow(10.0, -context.rng.real(0.5, 17.0));
  keep_in(context.rng, thin, tilt, fenced);
  tern::Report answer;
  tern::Trajectory& out = context.bench.trajectory;
  spoil(out);
  const Status found = planner.plan(whole.grid, fenced.request, out, answer);
  if (context.verbose) {
    std::printf("in a keep-in: %s (stage %s)\n", tern::status_name(found), tern::stage_name(answer.stage));
    print_ask(whole, fenced);
  }
  if (found == Status::kOk) {
    check_plan(context.rng, whole, fenced.request, out, 0.0, context.findings);
    check_vias(whole, fenced.request, out, answer, context.findings);
  } else if (!spoiled(out)) {
    report(context.findings, "touched", "keep-in: the output changed with %s", tern::status_name(found));
  }
  if (!(tilt > 0.0)) judge(context, thin, map, fenced, answer, found, "keep-in");
  if (context.rng.chance(0.1)) compare_slices(context, whole, fenced, found);
  const bool comparable = ask.rest_to_rest() && !ask.hurries() && ask.unlimited_search() && !(tilt > 0.0) &&
                          !is_capacity(status) && !is_capacity(found);
  const bool in_boundary = status == Status::kOk;
  const bool in_keep_in = found == Status::kOk;
  if (!comparable || in_boundary == in_keep_in) return;
  report(context.findings, "flat_keep_in", "%s in a keep-in, %s in a boundary of its size", tern::status_name(found),
         tern::status_name(status));
}

/// Motion along a thin boundary, mostly.
void level(Rng& rng, const World& thin, tern::State& state) {
  if (rng.chance(0.2)) return;
  for (int a = 0; a < 3; ++a) {
    if (is_thin(thin, a)) axis(state.velocity, a) = axis(state.acceleration, a) = axis(state.jerk, a) = 0.0;
  }
}

}  // namespace

void attack_flat(Context& context, Rng& own) {
  Context flat{context.bench, own, context.family, context.tally, context.findings, context.verbose};
  World thin;
  make_world(own, context.family, thin);
  flatten(own, thin);
  World whole;
  widen(own, thin, whole);
  for (World* world : {&thin, &whole}) {
    const Status bound = bind_and_mark(own, *world);
    if (bound != Status::kOk) return report(context.findings, "bind", "flat: %s", tern::status_name(bound));
  }
  const Map map = map_of(thin);
  check_layers(thin, map, context.findings);
  Ask ask;
  make_request(own, context.family, thin, map, ask);
  level(own, thin, ask.request.start);
  level(own, thin, ask.request.goal);
  calm_vehicle(ask.request);
  tern::Planner planner(&context.bench.kept_memory, sizeof(tern::Workspace));
  const Status status = ask_once(flat, planner, thin, map, ask, "flat");
  if (own.chance(0.1)) compare_slices(flat, thin, ask, status);
  if (status == Status::kOk && own.chance(0.3)) replan(flat, planner, thin, map, ask);
  ask_fenced(flat, planner, thin, map, whole, ask, status);
  if (own.chance(0.3)) {
    Ask mission;
    make_mission(own, thin, map, ask, mission);
    const Status flown = ask_once(flat, planner, thin, map, mission, "flat mission");
    ask_fenced(flat, planner, thin, map, whole, mission, flown);
  }
  if (status == Status::kNoPath || status == Status::kGoalOccupied || status == Status::kGoalFenced) {
    go_near(flat, planner, thin, map, ask);
  }
}

}  // namespace tern_attack
