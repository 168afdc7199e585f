// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Geofences at random: boxes, oblique polyhedra, and keep-outs with planes that are nearly equal, nearly opposite,
// redundant, or meet in a needle.
#include "attack/asking.hpp"

namespace tern_attack {
namespace {

using Planes = std::vector<tern::Halfspace>;

/// The half-space through `from` plus `distance` along `direction`, with a normal of some length.
void add_plane(Rng& rng, const tern::Vec3& from, const tern::Vec3& direction, double distance, Planes& planes) {
  const double size = std::sqrt(direction.x * direction.x + direction.y * direction.y + direction.z * direction.z);
  if (size < 1e-6) return;
  const double scale = rng.chance(0.5) ? 1.0 / size : std::pow(10.0, rng.real(-4.0, 4.0)) / size;
  const tern::Vec3 n{direction.x * scale, direction.y * scale, direction.z * scale};
  planes.push_back({n, n.x * from.x + n.y * from.y + n.z * from.z + distance * size * scale});
}

/// Planes beside `direction`: equal, opposite or shifted but for as little as 1e-14.
void add_doubles(Rng& rng, const tern::Vec3& from, const tern::Vec3& d, double distance, double size, Planes& planes) {
  const int count = rng.integer(0, 3);
  for (int k = 0; k < count; ++k) {
    const double e = std::pow(10.0, -rng.real(1.0, 14.0));
    const tern::Vec3 turn{e * rng.real(-1, 1), e * rng.real(-1, 1), e * rng.real(-1, 1)};
    const double u = rng.unit();
    if (u < 0.4) {
      add_plane(rng, from, {d.x + turn.x, d.y + turn.y, d.z + turn.z}, distance + e * rng.real(-1, 1), planes);
    } else if (u < 0.75) {
      add_plane(rng, from, {turn.x - d.x, turn.y - d.y, turn.z - d.z},
                rng.chance(0.5) ? e - distance : rng.real(0.0, 0.5) * size, planes);
    } else {
      add_plane(rng, from, d, distance + rng.real(0.0, 1e-9), planes);
    }
  }
}

void add_needle(Rng& rng, const tern::Vec3& from, double size, Planes& planes) {
  const double e = std::pow(10.0, -rng.real(1.0, 8.0));
  add_plane(rng, from, {0, 1, e}, 0.05 * size, planes);
  add_plane(rng, from, {0, -1, e}, 0.05 * size, planes);
  add_plane(rng, from, {e, e, 1}, 0.3 * size, planes);
  add_plane(rng, from, {1, e, 0}, 0.4 * size, planes);
  add_plane(rng, from, {-1, 0, e}, 0.4 * size, planes);
}

tern::Vec3 somewhere(Rng& rng, const World& world, double low, double high) {
  const tern::Box& b = world.spec.boundary;
  return {b.lower.x + rng.real(low, high) * (b.upper.x - b.lower.x),
          b.lower.y + rng.real(low, high) * (b.upper.y - b.lower.y),
          b.lower.z + rng.real(low, high) * (b.upper.z - b.lower.z)};
}

void keep_out(Rng& rng, const World& world, Planes& planes) {
  const double size = rng.real(2.0, 6.0) * world.spec.cell;
  const tern::Vec3 from = somewhere(rng, world, 0.2, 0.8);
  if (rng.chance(0.2)) {
    const tern::Vec3 to{from.x + size, from.y + rng.real(0.0, 1.0) * size, from.z + size};
    tern::Halfspace faces[tern::kBoxPlanes];
    tern::box_planes({from, to}, faces);
    planes.assign(faces, faces + tern::kBoxPlanes);
    return;
  }
  const int count = rng.integer(1, 5);
  for (int k = 0; k < count && planes.size() < 10; ++k) {
    const tern::Vec3 d{rng.real(-1, 1), rng.real(-1, 1), rng.chance(0.4) ? 0.0 : rng.real(-1, 1)};
    const double distance = rng.real(0.05, 1.2) * size;
    add_plane(rng, from, d, distance, planes);
    add_doubles(rng, from, d, distance, size, planes);
  }
  if (rng.chance(0.25)) add_needle(rng, from, size, planes);
}

void keep_in(Rng& rng, const World& world, Planes& planes) {
  if (rng.chance(0.5)) {
    tern::Halfspace faces[tern::kBoxPlanes];
    tern::box_planes({somewhere(rng, world, 0.0, 0.2), somewhere(rng, world, 0.8, 1.0)}, faces);
    planes.assign(faces, faces + tern::kBoxPlanes);
    return;
  }
  const tern::Vec3 middle = somewhere(rng, world, 0.4, 0.6);
  const int count = rng.integer(1, 4);
  for (int k = 0; k < count; ++k) {
    const tern::Vec3 d{rng.real(-1, 1), rng.real(-1, 1), rng.real(-1, 1)};
    const double distance = rng.real(2.0, 8.0) * world.spec.cell;
    add_plane(rng, middle, d, distance, planes);
  }
}

}  // namespace

void make_fences(Rng& rng, const World& world, Ask& ask) {
  const int count = rng.integer(1, 2);
  for (int k = 0; k < count; ++k) {
    Planes planes;
    const bool in = rng.chance(0.25);
    if (in) {
      keep_in(rng, world, planes);
    } else {
      keep_out(rng, world, planes);
    }
    if (planes.size() > 20) planes.resize(20);
    if (planes.empty()) continue;
    ask.planes.push_back(std::move(planes));
    const Planes& kept = ask.planes.back();
    ask.fences.push_back({kept.data(), static_cast<std::int32_t>(kept.size()),
                          in ? tern::FenceKind::kKeepIn : tern::FenceKind::kKeepOut});
  }
  ask.request.fences = ask.fences.empty() ? nullptr : ask.fences.data();
  ask.request.fence_count = static_cast<std::int32_t>(ask.fences.size());
}

}  // namespace tern_attack
