// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How a proof begins: what it may assume, and what it is granted.
#include "base/fence_fault.hpp"
#include "base/math.hpp"
#include "base/track_fault.hpp"
#include "prove/allowed.hpp"
#include "prove/fences.hpp"
#include "prove/grants.hpp"
#include "tern/proof.hpp"

namespace tern {
namespace {

/// The first voxel of an axis whose centre is at `local` or behind it, within 0 .. count.
std::int32_t first_centre(double local, double cell, std::int32_t count) {
  const double from = local / cell - 0.5;
  if (!(from > 0.0)) return 0;
  if (from >= static_cast<double>(count)) return count;
  const auto whole = static_cast<std::int32_t>(from);
  return static_cast<double>(whole) < from ? whole + 1 : whole;
}

/// The voxel behind the last one whose centre is at `local` or before it, within 0 .. count.
std::int32_t behind_centre(double local, double cell, std::int32_t count) {
  const double to = local / cell - 0.5;
  if (!(to >= 0.0)) return 0;
  return to >= static_cast<double>(count) ? count : static_cast<std::int32_t>(to) + 1;
}

Box grown(const Box& box, double by) {
  const Vec3 all{by, by, by};
  return {box.lower - all, box.upper + all};
}

}  // namespace

Status Proof::begin(const Grid& grid, const Trajectory& trajectory, double from, const Limits* limits, Beyond beyond,
                    const ProofGrounds& grounds) noexcept {
  const Status begun = begin_accepted(grid, trajectory, from, limits, beyond, grounds);
  if (begun != Status::kRunning) return begun;
  const FenceFault fault = find_fence_fault(grounds.fences, grounds.fence_count, grid.spec());
  const TrackFault of_track = find_track_fault(grounds.tracks, grounds.track_count);
  if (fault.status == Status::kOk && of_track.status == Status::kOk) return begun;
  refuse(from);
  report_.fence = fault.fence;
  if (fault.status != Status::kOk) return fault.status;
  report_.track = of_track.track;
  return of_track.status;
}

/// Resets the report: nothing is proven, and there is nothing to do.
void Proof::refuse(double from) noexcept {
  running_ = is_watching_ = false;
  watched_ = TrackGrounds{};
  from_ = from;
  slice_ = Work{};
  spent_ = 0;
  report_ = ProofReport{};
  report_.until = from > 0.0 ? from : 0.0;
  report_.finding = Finding::kMalformed;
}

Status Proof::begin_accepted(const Grid& grid, const Trajectory& trajectory, double from, const Limits* limits,
                             Beyond beyond, const ProofGrounds& grounds) noexcept {
  refuse(from);
  if (!grid.bound() || !(grid.spec().clearance() > 0.0)) return Status::kInvalidArgument;
  if (trajectory.count < 1 || trajectory.count > kMaxSegments) return Status::kInvalidArgument;
  hints_ = nullptr;
  take_grant(grid, grant_to_curve(grid, trajectory), beyond);
  has_limits_ = limits != nullptr;
  if (has_limits_) limits_ = *limits;
  has_added_ = grounds.added != nullptr;
  if (has_added_) added_ = {grid.to_local(grounds.added->lower), grid.to_local(grounds.added->upper)};
  depart(grounds);
  fences_ = grounds.fences;
  fence_count_ = grounds.fence_count;
  pardoned_ = nullptr;
  if (grounds.alarm != nullptr) pardon(*grounds.alarm);
  watched_ = {grounds.tracks, grounds.track_count, grid.spec().clearance(), 0.0, has_departed_};
  if (!has_added_) {
    watched_.fences = grounds.fences;
    watched_.fence_count = grounds.fence_count;
  }
  track_grant_ = kTrackTolerance;
  enter(trajectory);
  return Status::kRunning;
}

void Proof::begin_plan(const Grid& grid, const Trajectory& trajectory, double from, const Limits* limits,
                       const AskedWorld* world, double spare, PlanHints& hints) noexcept {
  refuse(from);
  trajectory_ = &trajectory;
  hints_ = &hints;
  Grant grant = grant_to_plan(grid, trajectory);
  grant.near -= spare;
  grant.boundary = grown(grant.boundary, -spare);
  take_grant(grid, grant, Beyond::kEmpty);
  has_limits_ = limits != nullptr;
  if (has_limits_) limits_ = *limits;
  fences_ = world != nullptr ? world->fence : nullptr;
  fence_count_ = world != nullptr ? world->count : 0;
  if (trajectory.count >= 1 && trajectory.count <= kMaxSegments) enter(trajectory);
}

void Proof::watch(const TrackGrounds& tracks, double grant) noexcept {
  watched_ = tracks;
  track_grant_ = grant;
}

void Proof::take_grant(const Grid& grid, const Grant& grant, Beyond beyond) noexcept {
  grid_ = &grid;
  distance_ = grid.spec().clearance() - grant.near;
  near_ = grant.near;
  outside_ = grant.outside;
  excess_ = grant.excess;
  is_cut_ = grant.is_cut;
  boundary_ = beyond == Beyond::kSolid ? grown(grant.boundary, -grid.spec().clearance()) : grant.boundary;
}

/// A vehicle that stands on the ground never gets lower than it stands: nothing else would keep it from sinking into a
/// voxel that its centre is in.
void Proof::depart(const ProofGrounds& grounds) noexcept {
  has_departed_ = grounds.departed != nullptr;
  ground_ = __builtin_inf();
  if (!has_departed_) return;
  departed_ = grid_->to_local(*grounds.departed);
  if (grounds.ground == nullptr) return;
  ground_ = *grounds.ground - grid_->spec().origin.z;
  boundary_.lower.z = larger(boundary_.lower.z, departed_.z - near_);
}

/// Pardons seen voxels whose centres are in the alarm's box.
void Proof::pardon(const Alarm& alarm) noexcept {
  const GridSpec& spec = grid_->spec();
  pardoned_ = alarm.seen;
  const Vec3 lower = grid_->to_local(alarm.box.lower);
  const Vec3 upper = grid_->to_local(alarm.box.upper);
  const double cell = spec.cell;
  pardon_begin_ = {first_centre(lower.x, cell, spec.dims.x), first_centre(lower.y, cell, spec.dims.y),
                   first_centre(lower.z, cell, spec.dims.z)};
  pardon_end_ = {behind_centre(upper.x, cell, spec.dims.x), behind_centre(upper.y, cell, spec.dims.y),
                 behind_centre(upper.z, cell, spec.dims.z)};
}

}  // namespace tern
