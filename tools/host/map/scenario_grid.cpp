// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/map/scenario_grid.hpp"

#include <algorithm>
#include <cmath>

#include "host/grid_layout.hpp"
#include "host/map/known_space.hpp"

namespace tern_host {
namespace {

using tern::Box;
using tern::Grid;
using tern::Status;
using tern::Vec3;
using tern::Voxel;

Box world_box(const Grid& grid, const Voxel& v) {
  const Vec3& o = grid.spec().origin;
  const double cell = grid.spec().cell;
  return {{o.x + cell * v.x, o.y + cell * v.y, o.z + cell * v.z},
          {o.x + cell * (v.x + 1), o.y + cell * (v.y + 1), o.z + cell * (v.z + 1)}};
}

template <typename Visit>
void for_each_voxel(const Voxel& begin, const Voxel& end, Visit visit) {
  for (std::int32_t z = begin.z; z < end.z; ++z) {
    for (std::int32_t y = begin.y; y < end.y; ++y) {
      for (std::int32_t x = begin.x; x < end.x; ++x) visit(Voxel{x, y, z});
    }
  }
}

constexpr Voxel kFirst{0, 0, 0};

/// The voxel whose lower face, on each axis, is the boundary's upper face or the first one beyond it. At least a voxel
/// beyond `begin`, even where the boundary is flat.
Voxel beyond(const Grid& grid, const Voxel& begin, const Vec3& upper) {
  const auto index = [&](double x, std::int32_t first) {
    return std::max(first + 1, static_cast<std::int32_t>(std::ceil(x / grid.spec().cell - tern::kLatticeTolerance)));
  };
  return {index(upper.x, begin.x), index(upper.y, begin.y), index(upper.z, begin.z)};
}

}  // namespace

bool is_unknown(const Scenario& scenario, const Grid& grid, const Voxel& voxel) {
  if (scenario.known.empty() || grid.obstacle(voxel)) return false;
  const Box box = world_box(grid, voxel);
  return std::none_of(scenario.known.begin(), scenario.known.end(),
                      [&](const auto& known) { return known->free(box); });
}

namespace {

/// Voxels from `begin` to before `end`.
struct Room {
  Voxel begin;
  Voxel end;
};

/// All of the room is beyond one of the half-spaces.
bool is_beyond(const FenceRecord& fence, const Grid& grid, const Room& room) {
  const Box from = world_box(grid, room.begin);
  const Box to = world_box(grid, {room.end.x - 1, room.end.y - 1, room.end.z - 1});
  return std::any_of(fence.planes.begin(), fence.planes.end(), [&](const tern::Halfspace& plane) {
    const Vec3& n = plane.normal;
    const Vec3 nearest{n.x > 0.0 ? from.lower.x : to.upper.x, n.y > 0.0 ? from.lower.y : to.upper.y,
                       n.z > 0.0 ? from.lower.z : to.upper.z};
    return n.x * nearest.x + n.y * nearest.y + n.z * nearest.z > plane.offset;
  });
}

/// Halves the grid, and each half that the fence may reach into, down to voxels.
void mark_fence(const FenceRecord& fence, Grid& grid) {
  std::vector<Room> left{{kFirst, grid.spec().dims}};
  while (!left.empty()) {
    Room room = left.back();
    left.pop_back();
    if (is_beyond(fence, grid, room)) continue;
    const Voxel size{room.end.x - room.begin.x, room.end.y - room.begin.y, room.end.z - room.begin.z};
    const std::int32_t most = std::max({size.x, size.y, size.z});
    if (most == 1) {
      grid.mark_voxel(room.begin);
      continue;
    }
    std::int32_t Voxel::*const axis = size.x == most ? &Voxel::x : size.y == most ? &Voxel::y : &Voxel::z;
    Room other = room;
    other.begin.*axis = room.end.*axis = room.begin.*axis + most / 2;
    left.push_back(room);
    left.push_back(other);
  }
}

}  // namespace

Status fill_grid(const Scenario& scenario, Grid& grid) {
  for (const FenceRecord& fence : scenario.marked) mark_fence(fence, grid);
  for (const Block& block : scenario.blocks) {
    const Status marked = grid.mark_box(block.box);
    if (marked != Status::kOk) return marked;
  }
  if (scenario.unknown == Unknown::kFree) return Status::kOk;
  for_each_voxel(kFirst, grid.spec().dims, [&](const Voxel& v) {
    if (is_unknown(scenario, grid, v)) grid.mark_voxel(v);
  });
  return Status::kOk;
}

std::size_t GridMap::index(const Voxel& v) const {
  const Voxel& dims = grid.spec().dims;
  return static_cast<std::size_t>(v.x) +
         static_cast<std::size_t>(dims.x) *
             (static_cast<std::size_t>(v.y) + static_cast<std::size_t>(dims.y) * static_cast<std::size_t>(v.z));
}

bool GridMap::is_unknown(const Voxel& voxel) const {
  const std::size_t i = index(voxel);
  return (unknown[i / 64] >> (i % 64) & 1) != 0;
}

GridMap::GridMap(const Scenario& scenario) {
  const tern::GridSpec spec = lay_out_grid(scenario);
  words_.resize(tern::grid_words(spec.dims));
  status = grid.bind(spec, words_.data(), words_.size(), &field);
  Scenario known = scenario;
  known.unknown = Unknown::kFree;
  if (status == Status::kOk) status = fill_grid(known, grid);
  if (status != Status::kOk) return;
  begin = grid.voxel_of(grid.local_boundary().lower);
  end = beyond(grid, begin, grid.local_boundary().upper);
  find_unknown(scenario);
  for_each_voxel(begin, end, [&](const Voxel& v) {
    ++voxels;
    occupied_count += grid.obstacle(v) ? 1 : 0;
    unknown_count += is_unknown(v) ? 1 : 0;
  });
  for_each_voxel(kFirst, spec.dims, [&](const Voxel& v) {
    if (scenario.unknown == Unknown::kSolid && is_unknown(v)) grid.mark_voxel(v);
  });
  grid.inflate();
  for_each_voxel(begin, end, [&](const Voxel& v) { blocked_count += grid.free(v) ? 0 : 1; });
}

void GridMap::find_unknown(const Scenario& scenario) {
  const Voxel& dims = grid.spec().dims;
  unknown.assign(index({0, 0, dims.z}) / 64 + 1, 0);
  for_each_voxel(kFirst, dims, [&](const Voxel& v) {
    const std::size_t i = index(v);
    if (tern_host::is_unknown(scenario, grid, v)) unknown[i / 64] |= std::uint64_t{1} << (i % 64);
  });
}

}  // namespace tern_host
