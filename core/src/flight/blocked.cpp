// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "flight/blocked.hpp"

#include "base/math.hpp"
#include "flight/closing.hpp"
#include "flight/fence_hours.hpp"
#include "grid/bit_rows.hpp"
#include "grid/lattice.hpp"
#include "prove/fences.hpp"

namespace tern {
namespace {

/// How many voxels beyond the radius a solid voxel is sought.
constexpr double kBeyondRadius = 2.0;

/// True if a keep-in for a while will begin.
bool is_keep_in_to_come(const FlightFacts& flight) {
  for (std::int32_t k = 0; k < flight.spec.fence_count; ++k) {
    const Fence& fence = flight.fences[k];
    if (fence.kind == FenceKind::kKeepIn && hours_of(fence, flight.time).is_to_come()) return true;
  }
  return false;
}

/// The distance of a coordinate from a voxel's extent along an axis.
double gap(double at, std::int32_t index, double cell) {
  return larger(0.0, larger(index * cell - at, at - (index + 1) * cell));
}

/// The voxels along an axis that are less than `most` from a coordinate.
IndexRange indices_around(double at, double most, double cell, std::int32_t count) {
  return {floor_index((at - most) / cell, 0, count), ceil_index((at + most) / cell, 0, count)};
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

/// Calls visit(x, y) for the columns of voxels nearer than the radius to a place, seen from above, until it answers
/// true. True if it did.
template <typename Visit>
bool visit_columns(const Grid& grid, const Vec3& place, Visit visit) {
  const GridSpec& window = grid.spec();
  const Vec3 local = grid.to_local(place);
  const double most = window.clearance();
  const IndexRange xs = indices_around(local.x, most, window.cell, window.dims.x);
  const IndexRange ys = indices_around(local.y, most, window.cell, window.dims.y);
  for (std::int32_t y = ys.begin; y < ys.end; ++y) {
    const double aside = gap(local.y, y, window.cell);
    for (std::int32_t x = xs.begin; x < xs.end; ++x) {
      const double along = gap(local.x, x, window.cell);
      if (along * along + aside * aside < most * most && visit(x, y)) return true;
    }
  }
  return false;
}

}  // namespace

bool is_by_time(Status status) noexcept {
  return status == Status::kStartInContact || status == Status::kGoalCovered || status == Status::kNoClearTime ||
         status == Status::kFloodFull || status == Status::kSeparationsFull || status == Status::kBudgetTracks;
}

NearestSolid nearest_solid(const Grid& grid, const Vec3& local, double most) noexcept {
  const GridSpec& spec = grid.spec();
  NearestSolid best{false, {-1, -1, -1}, most, 0};
  const IndexRange along = indices_around(local.x, most, spec.cell, spec.dims.x);
  const IndexRange rows = indices_around(local.y, most, spec.cell, spec.dims.y);
  const IndexRange planes = indices_around(local.z, most, spec.cell, spec.dims.z);
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

bool Blockage::is_temporary(const FlightFacts& flight, Work& work) const noexcept {
  if (by != BlockedBy::kFence) return by == BlockedBy::kTrack;
  const Fence& shut = flight.fences[fence];
  if (!is_timed(shut)) return false;
  if (shut.kind == FenceKind::kKeepOut) return !hours_of(shut, flight.time).is_over();
  work.spend(ops::kTurn * flight.spec.fence_count);
  return is_keep_in_to_come(flight);
}

Blockage block_at(const RollingMap& map, const Voxel& voxel) noexcept {
  const Grid& safe = map.safe();
  const bool is_seen = map.route().obstacle(voxel);
  return {is_seen ? BlockedBy::kObstacle : BlockedBy::kUnseen, safe.spec().origin + safe.center(voxel), kNoFence};
}

double Blockage::note_near(const RollingMap& map, const Vec3& place, const Grid& grid, Work& work) noexcept {
  if (!grid.bound()) return kAnywhere;
  const GridSpec& window = grid.spec();
  const double most = window.clearance() + kBeyondRadius * window.cell;
  const NearestSolid solid = nearest_solid(grid, grid.to_local(place), most);
  work.spend(8 * ops::kWord * solid.words);
  if (solid.found) *this = block_at(map, solid.voxel);
  return solid.distance;
}

bool Blockage::note_site(const RollingMap& map, const Vec3& place, double ground, Work& work) noexcept {
  const Grid& route = map.route();
  const GridSpec& window = route.spec();
  const auto layers_below = [&](double height) {
    return ceil_index((height - window.origin.z) / window.cell, 0, window.dims.z);
  };
  const std::int32_t above = layers_below(ground);
  const std::int32_t end = layers_below(height_above(window, ground));
  const std::int32_t around = 2 * ceil_index(window.clearance() / window.cell, 0, window.dims.x) + 2;
  work.spend(8 * ops::kWord * around * around * (end - above + 2));
  *this = kNoBlockage;
  const bool is_occupied = visit_columns(route, place, [&](std::int32_t x, std::int32_t y) {
    for (std::int32_t z = above; z < end; ++z) {
      if (!route.obstacle({x, y, z})) continue;
      *this = {BlockedBy::kObstacle, window.origin + route.center({x, y, z}), kNoFence};
      return true;
    }
    return false;
  });
  if (is_occupied) return false;
  double stated = 0.0;
  if (map.ground_at(place, ground_needed(window), stated) && stated <= ground) return true;
  return !visit_columns(route, place, [&](std::int32_t x, std::int32_t y) {
    const Voxel top{x, y, above - 1};
    const Voxel deeper{x, y, above - 2};
    if (route.obstacle(top) || route.obstacle(deeper)) return false;
    const Voxel unseen = map.seen(top) ? deeper : top;
    if (!map.seen(unseen)) *this = {BlockedBy::kUnseen, window.origin + route.center(unseen), kNoFence};
    return true;
  });
}

void Blockage::note_unproven(const RollingMap& map, const Draft& draft) noexcept {
  const ProofReport& found = draft.proof.report();
  const Vec3 place = evaluate(draft.plan.planned, found.until).position;
  *this = kNoBlockage;
  if (found.finding == Finding::kObstacle) *this = block_at(map, found.voxel);
  if (found.finding == Finding::kOutside) *this = {BlockedBy::kWindow, place, kNoFence};
  if (found.finding == Finding::kFence) *this = {BlockedBy::kFence, place, found.fence};
  if (found.finding == Finding::kTrack) *this = {BlockedBy::kTrack, place, kNoFence};
}

/// A fence counts before any voxel: it does not go away, whatever is seen there.
void Blockage::note_beyond(const FlightFacts& flight, const Aim& aim, const Vec3& reachable, Work& work) noexcept {
  const Vec3 way = aim.target_place - reachable;
  const double far = length(way);
  if (!(far > 0.0)) return;
  const double clearance = flight.map.safe().spec().clearance();
  const Vec3 place = reachable + (smaller(far, clearance) / far) * way;
  for (std::int32_t k = 0; k < flight.spec.fence_count; ++k) {
    const Fence& next = flight.spec.fences[k];
    if (is_timed(next) && !is_closed(next, flight.time, 0.0)) continue;
    if (fence_clear(next, {place, clearance, 0.0}, &kZero, 1, work)) continue;
    *this = {BlockedBy::kFence, place, k};
    return;
  }
  note_near(flight.map, place, flight.map.safe(), work);
}

void Blockage::note_no_plan(const FlightFacts& flight, const Aim& aim, const Report& found, Work& work) noexcept {
  const Grid& safe = flight.map.safe();
  if (!safe.bound()) return;
  if (is_voxel() && safe.obstacle(safe.voxel_of(safe.to_local(at)))) return;
  *this = kNoBlockage;
  if (is_by_time(found.status)) {
    *this = {found.fence == kNoFence ? BlockedBy::kTrack : BlockedBy::kFence, aim.place, found.fence};
  }
  if (found.status == Status::kGoalFenced) *this = {BlockedBy::kFence, aim.place, found.fence};
  if (found.status == Status::kViaFenced) *this = {BlockedBy::kFence, aim.asked[found.via].position, found.fence};
  if (found.status == Status::kGoalOccupied) note_near(flight.map, aim.place, safe, work);
  if (found.status == Status::kStartOccupied) note_near(flight.map, aim.start.d[0], safe, work);
  if (found.status == Status::kNoPath && found.has_reachable) note_beyond(flight, aim, found.reachable, work);
}

}  // namespace tern
