// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "golden/corpus.hpp"

#include <cstring>

#include "support/random.hpp"

namespace tern_golden {
namespace {

#include "golden_maps.inc"

using tern::Box;
using tern::Vec3;
using tern_test::Random;

/// Tenths of a metre as metres: one division, so that every value is the double nearest to its decimal.
double tenths(int n) {
  return n / 10.0;
}

Box random_block(Random& random, int nx, int ny, int nz) {
  const int x = random.integer(0, nx - 4);
  const int y = random.integer(0, ny - 4);
  const int height = random.chance(0.6) ? nz : random.integer(5, nz);
  const int z = random.chance(0.5) ? 0 : nz - height;
  const int wx = random.integer(3, 14);
  const int wy = random.integer(3, 14);
  return {{tenths(x), tenths(y), tenths(z)},
          {tenths(x + wx < nx ? x + wx : nx), tenths(y + wy < ny ? y + wy : ny), tenths(z + height)}};
}

Vec3 random_point(Random& random, int nx, int ny, int nz) {
  return {random.integer(0, 100 * nx) / 1000.0, random.integer(0, 100 * ny) / 1000.0,
          random.integer(0, 100 * nz) / 1000.0};
}

/// Squared distance of a point from a box.
double distance_squared(const Vec3& p, const Box& box) {
  const double x = p.x < box.lower.x ? box.lower.x - p.x : (p.x > box.upper.x ? p.x - box.upper.x : 0.0);
  const double y = p.y < box.lower.y ? box.lower.y - p.y : (p.y > box.upper.y ? p.y - box.upper.y : 0.0);
  const double z = p.z < box.lower.z ? box.lower.z - p.z : (p.z > box.upper.z ? p.z - box.upper.z : 0.0);
  return x * x + y * y + z * z;
}

bool has_room(const Vec3& point, const Scenario& scenario) {
  const double room = scenario.radius + scenario.resolution;
  for (int b = 0; b < scenario.block_count; ++b) {
    if (distance_squared(point, scenario.blocks[b]) < room * room) return false;
  }
  return true;
}

/// A point that keeps away from the blocks, if one comes up in a few draws; else the corpus has an occupied end.
Vec3 random_free_point(Random& random, int nx, int ny, int nz, const Scenario& scenario) {
  Vec3 point = random_point(random, nx, ny, nz);
  for (int draw = 0; draw < 5 && !has_room(point, scenario); ++draw) point = random_point(random, nx, ny, nz);
  return point;
}

Vec3 random_vector(Random& random, double most) {
  const double step = most / 1024.0;
  return {step * random.integer(-512, 512), step * random.integer(-512, 512), step * random.integer(-512, 512)};
}

void random_scenario(int index, Scenario& out) {
  Random random(0x7465726Eu + static_cast<std::uint64_t>(index));
  const int nx = random.integer(50, 100);
  const int ny = random.integer(50, 100);
  const int nz = random.integer(15, 30);
  out = Scenario{};
  out.boundary = {{0.0, 0.0, 0.0}, {tenths(nx), tenths(ny), tenths(nz)}};
  out.resolution = random.chance(0.5) ? 0.1 : 0.2;
  out.radius = random.integer(0, 30) / 100.0;
  out.block_count = random.integer(0, kMaxStrips);
  for (int b = 0; b < out.block_count; ++b) out.blocks[b] = random_block(random, nx, ny, nz);
  const double v = random.integer(5, 40) / 10.0;
  const double a = random.integer(5, 40) / 10.0;
  out.request.limits = {{v, v, 0.5 * v}, {a, a, 0.5 * a}};
  out.request.start.position = random_free_point(random, nx, ny, nz, out);
  out.request.goal.position = random_free_point(random, nx, ny, nz, out);
  // One in four starts in flight.
  if (index % 4 == 3) out.request.start.velocity = random_vector(random, 0.5 * v);
}

void make_limits_uneven(int index, tern::Limits& limits) {
  limits.v_min.z = -0.5 * limits.v_max.z;
  limits.a_min.z = -0.75 * limits.a_max.z;
  if (index % 2 == 0) limits.v_horizontal = limits.v_max.x;
  if (index % 3 == 0) limits.a_horizontal = limits.a_max.x;
}

void add(std::uint64_t& hash, std::uint64_t word) {
  hash = (hash ^ word) * 0x100000001B3u;
}

void add(std::uint64_t& hash, double value) {
  std::uint64_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  add(hash, bits);
}

void add(std::uint64_t& hash, const Vec3& v) {
  add(hash, v.x);
  add(hash, v.y);
  add(hash, v.z);
}

/// Voxels along an axis of a boundary: rounded up, but for rounding.
std::int32_t cells(double extent, double resolution) {
  const double exact = extent / resolution - tern::kLatticeTolerance;
  const std::int32_t whole = static_cast<std::int32_t>(exact);
  return static_cast<double>(whole) < exact ? whole + 1 : whole;
}

}  // namespace

bool scenario(int index, Scenario& out) {
  if (index < 0 || index >= kScenarioCount) return false;
  if (index < kMapCount) {
    out = kMaps[index];
  } else {
    random_scenario(index - kMapCount, out);
    if (index >= kMapCount + kRandomCount) make_limits_uneven(index, out.request.limits);
  }
  return true;
}

tern::Status build_grid(const Scenario& scenario, std::uint64_t* words, std::size_t word_count, tern::Grid& grid) {
  const Box& boundary = scenario.boundary;
  tern::GridSpec spec{};
  spec.origin = boundary.lower;
  spec.cell = scenario.resolution;
  spec.dims = {cells(boundary.upper.x - boundary.lower.x, spec.cell),
               cells(boundary.upper.y - boundary.lower.y, spec.cell),
               cells(boundary.upper.z - boundary.lower.z, spec.cell)};
  spec.boundary = boundary;
  spec.radius = scenario.radius;
  const tern::Status status = grid.bind(spec, words, word_count);
  if (status != tern::Status::kOk) return status;
  for (int b = 0; b < scenario.block_count; ++b) grid.mark_box(scenario.blocks[b]);
  grid.inflate();
  return tern::Status::kOk;
}

std::uint64_t hash_plan(std::uint64_t hash, tern::Status status, const tern::Trajectory& trajectory) {
  add(hash, static_cast<std::uint64_t>(status));
  if (status != tern::Status::kOk) return hash;
  add(hash, static_cast<std::uint64_t>(trajectory.count));
  add(hash, trajectory.origin);
  for (int s = 0; s < trajectory.count; ++s) {
    const tern::Segment& segment = trajectory.segments[s];
    add(hash, segment.duration);
    add(hash, static_cast<std::uint64_t>(segment.polyhedron));
    for (const Vec3& point : segment.points) add(hash, point);
  }
  return hash;
}

}  // namespace tern_golden
