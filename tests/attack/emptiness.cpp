// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "attack/emptiness.hpp"

#include <array>
#include <cmath>

namespace tern_attack {
namespace {

using tern::Status;

/// Rounds of projections onto the half-spaces that do not hold the point.
constexpr int kRounds = 40;
/// A point counts up to so many times as far away as the world is wide and the half-spaces are; a proof, further.
constexpr Real kNear = 1e4L;
constexpr Real kFar = 1e6L;
/// Half-spaces that miss each other by less than this part of all that are in doubt.
constexpr Real kMiss = 1e-8L;

bool finds_point(const std::vector<Plane>& planes, Real farthest) {
  Point at{{0, 0, 0}};
  for (int round = 0; round < kRounds; ++round) {
    bool holds = true;
    for (const Plane& plane : planes) {
      const Real beyond = dot(plane.normal, at) - plane.offset;
      if (beyond <= 0) continue;
      holds = false;
      at = at - (1.0001L * beyond) * plane.normal;
    }
    if (holds) return length(at) <= kNear * farthest;
  }
  return false;
}

/// Multipliers >= 0 whose normals vanish and whose offsets are below 0.
bool proves_empty(const std::array<const Plane*, 4>& p, Real farthest) {
  const std::array<Real, 4> m{
      dot(p[1]->normal, cross(p[2]->normal, p[3]->normal)), -dot(p[0]->normal, cross(p[2]->normal, p[3]->normal)),
      dot(p[0]->normal, cross(p[1]->normal, p[3]->normal)), -dot(p[0]->normal, cross(p[1]->normal, p[2]->normal))};
  Real most = 0;
  for (const Real x : m) most = std::fabs(x) > std::fabs(most) ? x : most;
  if (std::fabs(most) < 1e-6L) return false;
  Real sum = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const Real share = m[k] / most;
    if (share < -1e-17L) return false;
    sum += std::max(share, 0.0L) * p[k]->offset;
  }
  return sum < -kMiss * farthest;
}

bool four_prove_it(const std::vector<Plane>& planes, Real farthest) {
  const std::size_t n = planes.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      for (std::size_t k = j + 1; k < n; ++k) {
        for (std::size_t l = k + 1; l < n; ++l) {
          if (proves_empty({&planes[i], &planes[j], &planes[k], &planes[l]}, farthest)) return true;
        }
      }
    }
  }
  return false;
}

Real width_of(const World& world) {
  const tern::Box& b = world.spec.boundary;
  return length(point(b.upper) - point(b.lower)) + world.radius();
}

}  // namespace

Emptiness emptiness_of(const std::vector<Plane>& planes, Real size) {
  Real farthest = size;
  for (const Plane& plane : planes) farthest = std::max(farthest, std::fabs(plane.offset));
  if (finds_point(planes, farthest)) return Emptiness::kHasPoint;
  std::vector<Plane> cut = planes;
  for (int a = 0; a < 3; ++a) {
    Point up{{0, 0, 0}};
    up[a] = 1;
    cut.push_back({up, kFar * farthest});
    cut.push_back({-1.0L * up, kFar * farthest});
  }
  return four_prove_it(cut, farthest) ? Emptiness::kEmpty : Emptiness::kDoubt;
}

void judge_fences(const World& world, const tern::Fence* fences, int count, Status status, int named, const char* what,
                  Findings& findings) {
  const Real size = width_of(world);
  std::vector<Plane> inside;
  bool some_empty = false;
  for (int f = 0; f < count; ++f) {
    const std::vector<Plane> own = planes_of(world, fences[f]);
    const bool in = fences[f].kind == tern::FenceKind::kKeepIn;
    if (in) inside.insert(inside.end(), own.begin(), own.end());
    const Emptiness found = emptiness_of(in ? inside : own, size);
    some_empty = some_empty || found == Emptiness::kEmpty;
    if (status == Status::kFenceEmpty && f == named && found == Emptiness::kHasPoint) {
      report(findings, "fence_empty", "%s: fence %d has a point", what, f);
    }
  }
  if (status == Status::kFenceEmpty && (named < 0 || named >= count)) {
    report(findings, "fence_empty", "%s: of fence %d, which there is not", what, named);
  }
  if (some_empty && status != Status::kFenceEmpty) {
    report(findings, "fence_empty", "%s: %s, though a fence has no point", what, tern::status_name(status));
  }
}

}  // namespace tern_attack
