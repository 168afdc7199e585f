// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "capacity/requests.hpp"

#include "base/math.hpp"
#include "support/random.hpp"

namespace tern_capacity {
namespace {

using tern::Vec3;
using tern_test::Random;
using tern_test::World;

Vec3 any_point(Random& random, const World& world) {
  const Vec3& top = world.spec.boundary.upper;
  return {random.real(0.3, top.x - 0.3), random.real(0.3, top.y - 0.3), random.real(0.3, top.z - 0.3)};
}

Vec3 any_vector(Random& random, double most) {
  return {random.real(-most, most), random.real(-most, most), random.real(-most, most)};
}

/// Voxels strewn at random, or boxes.
void fill(Random& random, World& world) {
  const tern::Voxel& dims = world.spec.dims;
  if (random.chance(0.2)) {
    for (int k = random.integer(200, 1500); k > 0; --k) {
      const int x = random.integer(0, dims.x - 1);
      const int y = random.integer(0, dims.y - 1);
      world.grid.mark_voxel({x, y, random.integer(0, dims.z - 1)});
    }
  } else {
    for (int k = random.integer(0, 10); k > 0; --k) {
      const Vec3 low = any_point(random, world);
      world.grid.mark_box({low, low + Vec3{random.real(0.1, 2.0), random.real(0.1, 2.0), random.real(0.1, 2.0)}});
    }
  }
  world.grid.inflate();
}

/// A box: keep-out around a point, or keep-in that takes a little off the boundary.
void add_fence(Random& random, Asked& asked) {
  const bool keeps_in = random.chance(0.3);
  const Vec3 at = any_point(random, asked.world);
  const std::size_t first = asked.planes.size();
  for (int a = 0; a < 3; ++a) {
    Vec3 normal{0.0, 0.0, 0.0};
    tern::axis(normal, a) = 1.0;
    const double top = tern::axis(asked.world.spec.boundary.upper, a);
    asked.planes.push_back({normal, keeps_in ? top - random.real(0.0, 0.2) : tern::axis(at, a) + 0.4});
    asked.planes.push_back({-1.0 * normal, keeps_in ? -random.real(0.0, 0.2) : 0.4 - tern::axis(at, a)});
  }
  const auto kind = keeps_in ? tern::FenceKind::kKeepIn : tern::FenceKind::kKeepOut;
  asked.fences.push_back({asked.planes.data() + first, tern::kBoxPlanes, kind});
}

void add_fences(Random& random, Asked& asked) {
  asked.planes.reserve(2 * tern::kBoxPlanes);
  for (int k = random.integer(1, 2); k > 0; --k) add_fence(random, asked);
  asked.world.request.fences = asked.fences.data();
  asked.world.request.fence_count = static_cast<std::int32_t>(asked.fences.size());
}

void add_vias(Random& random, Asked& asked) {
  for (int k = random.integer(1, 2); k > 0; --k) {
    tern::Via via{};
    via.position = any_point(random, asked.world);
    via.tolerance = random.chance(0.5) ? 0.3 : 0.0;
    via.stop = random.chance(0.2);
    via.dwell = via.stop ? 0.5 : 0.0;
    asked.vias.push_back(via);
  }
  asked.world.request.vias = asked.vias.data();
  asked.world.request.via_count = static_cast<std::int32_t>(asked.vias.size());
}

/// What is asked for begins in the middle of its own plan, in some cases with another goal or an obstacle beside it.
void continue_plan(Random& random, Asked& asked) {
  World& world = asked.world;
  if (world.replan() != tern::Status::kOk) return;
  asked.previous = world.trajectory;
  const double t = random.real(0.0, 0.8) * tern::duration(asked.previous);
  const tern::Sample at = tern::evaluate(asked.previous, t);
  world.request.start = {at.position, at.velocity, at.acceleration, at.jerk};
  world.request.previous = &asked.previous;
  world.request.previous_time = t;
  world.request.begin = static_cast<std::int64_t>(t * 1e9);
  if (random.chance(0.5)) world.request.goal.position = any_point(random, world);
  if (random.chance(0.3)) {
    world.grid.mark_box({at.position + Vec3{0.5, 0.5, 0.0}, at.position + Vec3{1.0, 1.0, 1.0}});
    world.grid.inflate();
  }
}

/// Balls and boxes, some of which meet the way, and walls that stand for a while.
void add_tracks(Random& random, Asked& asked) {
  for (int k = random.integer(1, 2); k > 0; --k) {
    tern::Track track;
    track.measured = asked.world.request.begin;
    track.position = any_point(random, asked.world);
    track.velocity = any_vector(random, 1.0);
    track.radius = random.real(0.05, 0.3);
    track.half = {0.2, 0.2, 0.2};
    track.shape = random.chance(0.5) ? tern::TrackShape::kBall : tern::TrackShape::kBox;
    track.error_speed = 0.05;
    if (random.chance(0.3)) {
      track.velocity = {};
      track.error_speed = 0.0;
      track.shape = tern::TrackShape::kBox;
      track.half = {0.2, 1.5, 1.5};
      track.end = tern::TrackEnd::kGone;
      track.until = track.measured + 50000000000;
    }
    asked.tracks.push_back(track);
  }
  asked.world.request.tracks = asked.tracks.data();
  asked.world.request.track_count = static_cast<std::int32_t>(asked.tracks.size());
}

tern::Voxel any_dims(Random& random) {
  if (random.chance(0.2)) return {9, 61, 57};  // more blocks than the guide and the records of dominance have room for
  const int x = random.integer(12, 32);
  const int y = random.integer(12, 32);
  return {x, y, random.integer(6, 16)};
}

/// A request without tracks.
std::unique_ptr<Asked> standing_request(std::uint64_t seed) {
  Random random(seed);
  const tern::Voxel dims = any_dims(random);
  auto asked = std::make_unique<Asked>(dims, random.chance(0.2) ? 0.0 : random.real(0.1, 0.4));
  World& world = asked->world;
  fill(random, world);
  tern::Request& request = world.request;
  request.start.position = any_point(random, world);
  request.goal.position = any_point(random, world);
  if (random.chance(0.4)) request.start.velocity = any_vector(random, 1.9);
  if (random.chance(0.2)) request.start.acceleration = any_vector(random, 1.9);
  if (random.chance(0.2)) request.goal.velocity = any_vector(random, 1.0);
  if (random.chance(0.3)) request.limits.j_max = {20.0, 20.0, 20.0};
  request.search = random.chance(0.5) ? tern::SearchMode::kFast : tern::SearchMode::kOptimal;
  if (random.chance(0.3)) add_fences(random, *asked);
  if (random.chance(0.3)) {
    add_vias(random, *asked);
    return asked;
  }
  if (random.chance(0.5)) request.goal_mode = tern::GoalMode::kNearest;
  if (random.chance(0.3)) continue_plan(random, *asked);
  return asked;
}

}  // namespace

std::unique_ptr<Asked> random_request(std::uint64_t seed) {
  auto asked = standing_request(seed);
  Random random(~seed);
  if (random.chance(0.3)) add_tracks(random, *asked);
  return asked;
}

}  // namespace tern_capacity
