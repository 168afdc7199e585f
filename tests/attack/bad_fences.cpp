// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fences that users get wrong: reversed half-spaces, polygons the wrong way round, keep-ins apart, and lists that are
// malformed. Plans and flights have to give the same answer.
#include <cmath>
#include <limits>

#include "attack/emptiness.hpp"

namespace tern_attack {
namespace {

using tern::Fence;
using tern::FenceKind;
using tern::Status;
using Planes = std::vector<tern::Halfspace>;

/// What a list of fences must be answered with.
struct Wrong {
  std::vector<Planes> planes;
  std::vector<Fence> fences;
  const Fence* list;
  int count;
  Status status = Status::kOk;  ///< kOk: by its points alone
  int fence = tern::kNoFence;
};

/// A prism over a regular polygon; reversed where its corners come clockwise.
Planes prism(Rng& rng, const World& world, bool clockwise) {
  const tern::Box& b = world.spec.boundary;
  const tern::Vec3 middle{rng.real(b.lower.x, b.upper.x), rng.real(b.lower.y, b.upper.y),
                          rng.real(b.lower.z, b.upper.z)};
  const double size = rng.real(0.5, 4.0) * world.spec.cell;
  const double turn = rng.real(0.0, 6.0);
  const int sides = rng.integer(3, 8);
  Planes planes;
  for (int k = 0; k < sides; ++k) {
    const double angle = turn + 6.283185307179586 * k / sides;
    const double sign = clockwise ? -1.0 : 1.0;
    const tern::Vec3 n{sign * std::cos(angle), sign * std::sin(angle), 0.0};
    planes.push_back({n, n.x * middle.x + n.y * middle.y + sign * size});
  }
  planes.push_back({{0.0, 0.0, 1.0}, middle.z + size});
  planes.push_back({{0.0, 0.0, -1.0}, size - middle.z});
  return planes;
}

void reverse(tern::Halfspace& plane) {
  plane = {{-plane.normal.x, -plane.normal.y, -plane.normal.z}, -plane.offset};
}

/// One fence whose half-spaces may have no common point.
Planes reversed_fence(Rng& rng, const World& world) {
  Planes planes = prism(rng, world, rng.chance(0.5));
  if (rng.chance(0.5)) reverse(planes[static_cast<std::size_t>(rng.integer(0, static_cast<int>(planes.size()) - 1))]);
  if (rng.chance(0.2)) {
    for (tern::Halfspace& plane : planes) reverse(plane);
  }
  return planes;
}

double not_finite(Rng& rng) {
  return rng.chance(0.5) ? std::numeric_limits<double>::quiet_NaN() : std::numeric_limits<double>::infinity();
}

/// Spoils one fence, or the list.
void spoil_list(Rng& rng, Wrong& wrong) {
  const int at = rng.integer(0, wrong.count - 1);
  Fence& fence = wrong.fences[static_cast<std::size_t>(at)];
  tern::Halfspace& plane = wrong.planes[static_cast<std::size_t>(at)][0];
  wrong.status = Status::kInvalidArgument;
  wrong.fence = at;
  switch (rng.integer(0, 9)) {
    case 0:
      fence.planes = nullptr;
      break;
    case 1:
      fence.count = -rng.integer(0, 1000);
      break;
    case 2:
      fence.kind = static_cast<FenceKind>(rng.integer(2, 255));
      break;
    case 3:
      plane.normal = {0.0, 0.0, rng.chance(0.5) ? 0.0 : 1e-7};
      break;
    case 4:
      plane.normal.y = 2e6 * std::pow(10.0, rng.real(0.0, 300.0));
      break;
    case 5:
      plane.normal.x = not_finite(rng);
      wrong.status = Status::kNonFiniteInput;
      break;
    case 6:
      plane.offset = -not_finite(rng);
      wrong.status = Status::kNonFiniteInput;
      break;
    case 7:
      fence.count = tern::kMaxFencePlanes + rng.integer(1, 1000);
      wrong.status = Status::kFencePlanesFull;
      break;
    case 8:
      wrong.list = nullptr;
      wrong.fence = tern::kNoFence;
      break;
    default:
      wrong.count = rng.chance(0.5) ? -rng.integer(1, 1000) : tern::kMaxFences + rng.integer(1, 1000);
      wrong.status = wrong.count < 0 ? Status::kInvalidArgument : Status::kFencesFull;
      wrong.fence = tern::kNoFence;
  }
}

void make_wrong(Rng& rng, const World& world, Wrong& wrong) {
  const int count = rng.integer(1, 2);
  const bool malformed = rng.chance(0.5);
  for (int k = 0; k < count; ++k) {
    wrong.planes.push_back(malformed ? prism(rng, world, false) : reversed_fence(rng, world));
    if (wrong.planes.back().size() * static_cast<std::size_t>(count) > std::size_t{tern::kMaxFencePlanes}) {
      wrong.planes.back().resize(static_cast<std::size_t>(tern::kMaxFencePlanes / count));
    }
  }
  for (const Planes& planes : wrong.planes) {
    const FenceKind kind = rng.chance(0.4) ? FenceKind::kKeepIn : FenceKind::kKeepOut;
    wrong.fences.push_back({planes.data(), static_cast<std::int32_t>(planes.size()), kind});
  }
  wrong.list = wrong.fences.data();
  wrong.count = count;
  if (malformed) spoil_list(rng, wrong);
}

/// The answer's status, field and fence against what the list deserves.
void judge_answer(const World& world, const Wrong& wrong, Status status, tern::Field field, int fence, const char* what,
                  Findings& findings) {
  const bool about_fences = field == tern::Field::kFences;
  if (wrong.status == Status::kOk) {
    judge_fences(world, wrong.list, wrong.count, status, fence, what, findings);
    if (status == Status::kFenceEmpty && !about_fences) report(findings, "fence_empty", "%s: another field", what);
    return;
  }
  if (status == wrong.status && about_fences && fence == wrong.fence) return;
  report(findings, "fence_malformed", "%s: %s of fence %d in place of %s of fence %d", what, tern::status_name(status),
         fence, tern::status_name(wrong.status), wrong.fence);
}

/// A flight over a map of its own, in the middle of the world.
void start_flight(const World& world, tern::Planner& planner, const Wrong& wrong, Findings& findings) {
  const tern::Box& b = world.spec.boundary;
  const tern::Vec3 middle{0.5 * (b.lower.x + b.upper.x), 0.5 * (b.lower.y + b.upper.y), 0.5 * (b.lower.z + b.upper.z)};
  constexpr double kCell = 0.5;
  const tern::MapSpec spec =
      tern::map_spec({middle.x - 32 * kCell, middle.y - 4 * kCell, middle.z - 4 * kCell}, kCell, {64, 8, 8}, 0.5);
  std::vector<std::uint64_t> map_words(tern::map_words(spec));
  tern::RollingMap map;
  if (map.bind(spec, map_words.data(), map_words.size()) != Status::kOk) return;  // too far away for such cells
  map.assume_free(middle, 1.5);
  tern::FlightSpec flight_spec = tern::flight_spec({{2.0, 2.0, 2.0}, {4.0, 4.0, 4.0}});
  flight_spec.fences = wrong.list;
  flight_spec.fence_count = wrong.count;
  std::vector<std::uint64_t> words(tern::flight_words(spec.dims));
  tern::Flight flight;
  tern::FlightRefusal refusal;
  const Status status = flight.start(flight_spec, map, planner, words.data(), words.size(), middle, 0, &refusal);
  judge_answer(world, wrong, status, refusal.field, refusal.fence, "flight", findings);
}

}  // namespace

void attack_fences(Context& context, Rng& rng, tern::Planner& planner, const World& world, const Ask& ask) {
  Wrong wrong;
  make_wrong(rng, world, wrong);
  tern::Request request = ask.request;
  request.fences = wrong.list;
  request.fence_count = wrong.count;
  tern::Report answer;
  tern::Trajectory& out = context.bench.trajectory;
  spoil(out);
  const Status status = planner.plan(world.grid, request, out, answer);
  if (status != Status::kOk && !spoiled(out)) report(context.findings, "touched", "wrong fences: the output changed");
  judge_answer(world, wrong, status, answer.field, answer.fence, "plan", context.findings);
  start_flight(world, planner, wrong, context.findings);
}

}  // namespace tern_attack
