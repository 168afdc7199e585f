// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/rooms.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/flight/full_knowledge.hpp"
#include "host/nanoseconds.hpp"
#include "host/track_record.hpp"

namespace tern_host {
namespace {

using tern::Vec3;

constexpr double kSearchVoxels = 1.5;  // beyond the radius, in which the nearest solid voxel is looked for

/// Distances of a point from voxels, which are solid cubes.
class VoxelGaps {
 public:
  VoxelGaps(const Vec3& p, const tern::GridSpec& grid)
      : at_{p.x - grid.origin.x, p.y - grid.origin.y, p.z - grid.origin.z}, cell_(grid.cell) {}
  double to(const tern::Voxel& v) const {
    const double x = gap(v.x, at_.x);
    const double y = gap(v.y, at_.y);
    const double z = gap(v.z, at_.z);
    return std::sqrt(x * x + y * y + z * z);
  }
  double to_faces(const tern::GridSpec& grid) const {
    return std::min(
        {at_.x, at_.y, at_.z, grid.dims.x * cell_ - at_.x, grid.dims.y * cell_ - at_.y, grid.dims.z * cell_ - at_.z});
  }
  /// The voxel that holds the point moved by `by` along every axis; it may be outside.
  tern::Voxel voxel_at(double by) const { return {index(at_.x + by), index(at_.y + by), index(at_.z + by)}; }

 private:
  int index(double x) const { return static_cast<int>(std::floor(x / cell_)); }
  double gap(int k, double x) const { return std::max({k * cell_ - x, x - (k + 1) * cell_, 0.0}); }
  Vec3 at_;
  double cell_;
};

Vec3 center_of(const tern::Voxel& v, const tern::GridSpec& grid) {
  return {grid.origin.x + grid.cell * (v.x + 0.5), grid.origin.y + grid.cell * (v.y + 0.5),
          grid.origin.z + grid.cell * (v.z + 0.5)};
}

struct HoldingTimes {
  std::int64_t from;
  std::int64_t until;
};

/// Of a fence for a while, ns: the error of its clock makes a keep-out longer and a keep-in shorter.
HoldingTimes holding_times(const tern::Fence& fence) {
  const std::int64_t error = nanoseconds(fence.clock_error);
  const std::int64_t longer = fence.kind == tern::FenceKind::kKeepOut ? error : -error;
  return {fence.from - longer, fence.until + longer};
}

}  // namespace

Rooms::Rooms(const FlightWorld& world, const tern::RollingMap& map)
    : world_(world), map_(map), radius_(radius_of(world.settings)), pads_(pads_of(world)) {}

double Rooms::from_solid(const Vec3& p, const LeaveOut& leave_out) const {
  const tern::Grid& safe = map_.safe();
  const tern::GridSpec& grid = safe.spec();
  const VoxelGaps here(p, grid);
  const VoxelGaps there(left_, grid);
  const double most = radius_ + kSearchVoxels * grid.cell;
  double room = std::min(most, here.to_faces(grid)) - radius_;
  const Pad* const pad = pad_below(pads_, p, kOverPad);
  const VoxelGaps standing(pad != nullptr ? pad->place : p, grid);
  if (pad != nullptr) room = std::min(room, p.z - pad->place.z);
  const tern::Voxel low = here.voxel_at(-most);
  const tern::Voxel high = here.voxel_at(most);
  for (int z = low.z; z <= high.z; ++z) {
    for (int y = low.y; y <= high.y; ++y) {
      for (int x = low.x; x <= high.x; ++x) {
        const double distance = here.to({x, y, z});
        double kept = leaves_ ? std::min(radius_, there.to({x, y, z})) : radius_;
        const bool is_ground = pad != nullptr && grid.origin.z + grid.cell * z < pad->ground;
        if (is_ground) kept = std::min(kept, standing.to({x, y, z}));
        if (distance - kept >= room || !safe.obstacle({x, y, z})) continue;
        if (!leave_out || !leave_out(center_of({x, y, z}, grid))) room = distance - kept;
      }
    }
  }
  return room;
}

double Rooms::from_faces(const Vec3& p) const {
  return VoxelGaps(p, window()).to_faces(window()) - radius_;
}

double Rooms::from_fences(const Vec3& p, std::int64_t t, std::int64_t& change) const {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  double room = kFar;
  double in_chain = -kFar;
  bool has_chain = false;
  for (const FenceRecord& record : world_.fences) {
    const tern::Fence& fence = record.fence;
    const bool keeps_out = fence.kind == tern::FenceKind::kKeepOut;
    const bool is_link = is_timed(fence) && !keeps_out;
    has_chain = has_chain || is_link;
    if (is_timed(fence)) {
      const HoldingTimes holds = holding_times(fence);
      for (const std::int64_t at : {holds.from, holds.until}) {
        if (at > t) change = std::min(change, at);
      }
      if (t < holds.from || t > holds.until) continue;
    }
    const double gap = fence_gap(record, p) - (keeps_out ? radius_ : 0.0);
    if (is_link) {
      in_chain = std::max(in_chain, gap);
    } else {
      room = std::min(room, gap);
    }
  }
  return has_chain ? std::min(room, in_chain) : room;
}

double Rooms::from_world(const Vec3& p) const {
  return clearance_of_flight(world_, p, kOverPad) - (world_.settings.body_radius + world_.settings.tracking_margin);
}

void Rooms::rest_at(const Vec3& place) {
  leaves_ = false;
  left_ = place;
  leaves_ = readable() && from_solid(place) < 0.0;
}

}  // namespace tern_host
