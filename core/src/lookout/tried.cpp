// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lookout/tried.hpp"

#include "base/math.hpp"
#include "lookout/wanted.hpp"

namespace tern {
namespace {

/// Directions within 20 degrees of each other count as the same: their cosine.
constexpr double kSameDirection = 0.94;
/// Centres that are less than this part of a voxel apart are the same voxel's.
constexpr double kSameVoxel = 0.3;
/// Lookouts whose places, and whose middles of what they look at, are less than so many voxels apart are the same.
constexpr double kSameLookout = 2.5;

}  // namespace

bool TriedVoxel::was_tried_from(const Vec3& place) const noexcept {
  const Vec3 way = centre - place;
  const double least = kSameDirection * length(way);
  const std::int32_t kept = directions < kRememberedViews ? directions : kRememberedViews;
  for (std::int32_t k = 0; k < kept; ++k) {
    if (dot(way, direction[k]) > least) return true;
  }
  return false;
}

void Tried::note_voxel(const Vec3& centre, const Vec3& from, double cell) noexcept {
  const Vec3 way = centre - from;
  const double far = length(way);
  if (!(far > 0.0)) return;
  std::int32_t entry = find(centre, cell);
  if (entry < 0) {
    entry = voxels++ % kTriedVoxels;
    voxel[entry].centre = centre;
    voxel[entry].directions = 0;
  }
  TriedVoxel& tried = voxel[entry];
  tried.direction[tried.directions++ % kRememberedViews] = (1.0 / far) * way;
}

void Tried::note_failure(const Vec3& place, const Vec3& look) noexcept {
  failed[failures++ % kFailedLookouts] = {place, look};
}

std::int32_t Tried::find(const Vec3& centre, double cell) const noexcept {
  for (std::int32_t k = 0; k < kept_voxels(); ++k) {
    if (distance(voxel[k].centre, centre) < kSameVoxel * cell) return k;
  }
  return -1;
}

bool Tried::has_failed(const Vec3& place, const Vec3& look, double cell) const noexcept {
  const double near = kSameLookout * cell;
  for (std::int32_t k = 0; k < failures && k < kFailedLookouts; ++k) {
    if (distance(failed[k].place, place) < near && distance(failed[k].look, look) < near) return true;
  }
  return false;
}

std::int32_t Tried::most_tried(const RollingMap& map) const noexcept {
  std::int32_t best = -1;
  for (std::int32_t k = 0; k < kept_voxels(); ++k) {
    if (!is_unseen_at(map, voxel[k].centre)) continue;
    if (best < 0 || voxel[k].directions > voxel[best].directions) best = k;
  }
  return best;
}

std::int32_t Tried::list_unseen(const RollingMap& map, UnseenVoxel* list, std::int32_t capacity) const noexcept {
  std::int32_t count = 0;
  for (std::int32_t k = 0; k < kept_voxels(); ++k) {
    const TriedVoxel& tried = voxel[k];
    if (!is_unseen_at(map, tried.centre)) continue;
    if (count < capacity) {
      UnseenVoxel& out = list[count];
      out = {tried.centre, tried.directions, {}};
      for (std::int32_t n = 0; n < tried.directions && n < kRememberedViews; ++n)
        out.directions[n] = tried.direction[n];
    }
    ++count;
  }
  return count;
}

}  // namespace tern
