// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What keeps the flight from going on, for its report and for lookouts.
#include "flight/blocked.hpp"

#include "base/math.hpp"
#include "flight/flight_state.hpp"
#include "grid/bit_rows.hpp"
#include "grid/lattice.hpp"
#include "proof/fence_clear.hpp"

namespace tern {
namespace {

/// Instructions for a row or word in the search for a solid voxel.
constexpr std::uint32_t kSolidEffort = 40;
/// Instructions to compare two faces of a fence with a place.
constexpr std::uint32_t kFenceEffort = 100;
/// How many voxels beyond the radius a solid voxel is sought.
constexpr double kBeyondRadius = 2.0;

/// The distance of a coordinate from a voxel's extent along an axis.
double gap(double at, std::int32_t index, double cell) {
  return larger(0.0, larger(index * cell - at, at - (index + 1) * cell));
}

/// The voxels along an axis that are less than `reach` from a coordinate.
IndexRange indices_around(double at, double reach, double cell, std::int32_t count) {
  return {floor_index((at - reach) / cell, 0, count), ceil_index((at + reach) / cell, 0, count)};
}

/// Updates `best` with the marked voxels of a row within a range. In each word, only the last marked voxel before the
/// place and the first one after it can be the nearest.
void look_at_row(const Grid& grid, const Vec3& local, const IndexRange& range, const Voxel& first, double aside,
                 NearestSolid& best) {
  const double cell = grid.spec().cell;
  const std::uint64_t* const row = grid.obstacle_row(first.y, first.z);
  for (std::int32_t k = range.begin / kWordBits; k * kWordBits < range.end; ++k) {
    ++best.words;
    const std::uint64_t bits = row[k] & bits_met(range, k);
    const std::uint64_t before = bits & bits_met({kWordBits * k, first.x + 1}, k);
    const std::uint64_t after = bits & ~before;
    const std::int32_t candidates[2] = {before == 0 ? -1 : kWordBits * k + 63 - __builtin_clzll(before),
                                        after == 0 ? -1 : kWordBits * k + __builtin_ctzll(after)};
    for (const std::int32_t x : candidates) {
      if (x < 0) continue;
      const double along = gap(local.x, x, cell);
      const double distance = square_root(aside + along * along);
      if (distance < best.distance) {
        best.found = true;
        best.distance = distance;
        best.voxel = {x, first.y, first.z};
      }
    }
  }
}

}  // namespace

NearestSolid nearest_solid(const Grid& grid, const Vec3& local, double reach) noexcept {
  const GridSpec& spec = grid.spec();
  NearestSolid best{false, {-1, -1, -1}, reach, 0};
  const IndexRange along = indices_around(local.x, reach, spec.cell, spec.dims.x);
  const IndexRange rows = indices_around(local.y, reach, spec.cell, spec.dims.y);
  const IndexRange planes = indices_around(local.z, reach, spec.cell, spec.dims.z);
  const std::int32_t at = floor_index(local.x / spec.cell, 0, spec.dims.x);
  for (std::int32_t z = planes.begin; z < planes.end; ++z) {
    for (std::int32_t y = rows.begin; y < rows.end; ++y) {
      ++best.words;
      const double off_y = gap(local.y, y, spec.cell);
      const double off_z = gap(local.z, z, spec.cell);
      const double aside = off_y * off_y + off_z * off_z;
      if (aside < best.distance * best.distance) look_at_row(grid, local, along, {at, y, z}, aside, best);
    }
  }
  return best;
}

/// Reports what ended the proof of the draft. If the flight gave up, or something is too near to the resting vehicle,
/// the report keeps that instead.
void FlightState::note_unproven() noexcept {
  if (parked || is_beside()) return;
  const ProofReport& found = proof.report();
  const Vec3 place = evaluate(draft.wished, found.until).position;
  block = kNoBlockage;
  if (found.end == ProofEnd::kObstacle) block = block_at(found.voxel);
  if (found.end == ProofEnd::kOutside) block = {BlockedBy::kWindow, place, kNoFence};
  if (found.end == ProofEnd::kFence) block = {BlockedBy::kFence, place, found.fence};
}

/// A voxel that is solid in the safe grid: something was seen or marked in it, or nothing is known of it.
Blockage FlightState::block_at(const Voxel& voxel) const noexcept {
  const Grid& safe = map.safe();
  const bool is_seen = map.route().obstacle(voxel);
  return {is_seen ? BlockedBy::kObstacle : BlockedBy::kUnseen, safe.spec().origin + safe.center(voxel), kNoFence};
}

/// Reports the solid voxel of the safe or route grid that is too near to a place, and returns its distance, or more
/// than the radius if there is none. Returns kAnywhere while the map slides, because nothing is known of it then.
double FlightState::note_block_near(const Vec3& place, const Grid& grid) noexcept {
  if (!grid.bound()) return kAnywhere;
  const GridSpec& window = grid.spec();
  const double reach = window.clearance() + kBeyondRadius * window.cell;
  const NearestSolid solid = nearest_solid(grid, grid.to_local(place), reach);
  owed += kSolidEffort * solid.words;
  if (solid.found) block = block_at(solid.voxel);
  return solid.distance;
}

/// Reports what comes next on the straight line from the reachable point to the goal. A fence counts before any voxel:
/// it does not go away, whatever is seen there.
void FlightState::note_block_beyond(const Vec3& reachable) noexcept {
  const Vec3 way = goal - reachable;
  const double far = length(way);
  if (!(far > 0.0)) return;
  const double clearance = map.safe().spec().clearance();
  const Vec3 place = reachable + (smaller(far, clearance) / far) * way;
  for (std::int32_t k = 0; k < spec.fence_count; ++k) {
    owed += kFenceEffort * static_cast<std::uint32_t>(spec.fences[k].count * spec.fences[k].count);
    if (fence_clear(spec.fences[k], {place, clearance, 0.0}, &kZero, 1)) continue;
    block = {BlockedBy::kFence, place, k};
    return;
  }
  note_block_near(place, map.safe());
}

/// Reports what is in the way of a plan that failed, unless an earlier proof named a voxel that is still solid.
void FlightState::note_no_plan(const Report& found) noexcept {
  const Grid& safe = map.safe();
  if (!safe.bound()) return;
  const bool is_voxel = block.by == BlockedBy::kObstacle || block.by == BlockedBy::kUnseen;
  if (is_voxel && safe.obstacle(safe.voxel_of(safe.to_local(block.at)))) return;
  block = kNoBlockage;
  if (found.status == Status::kGoalFenced) block = {BlockedBy::kFence, aim, found.fence};
  if (found.status == Status::kViaFenced) block = {BlockedBy::kFence, asked[found.via].position, found.fence};
  if (found.status == Status::kGoalOccupied) note_block_near(aim, safe);
  if (found.status == Status::kStartOccupied) note_block_near(start.d[0], safe);
  if (found.status == Status::kNoPath && found.has_reachable) note_block_beyond(found.reachable);
}

}  // namespace tern
