// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstddef>
#include <cstdint>
#include <new>

#include "grid/grid_handle.hpp"
#include "map/map_handle.hpp"
#include "tern/tern_map.h"

namespace {

using tern::kMapTag;
using tern::object;
using tern::RollingMap;
using tern::Status;

constexpr std::uint8_t kInvalid = static_cast<std::uint8_t>(Status::kInvalidArgument);

static_assert(sizeof(std::uint64_t) + sizeof(RollingMap) <= sizeof(tern_map) &&
                  alignof(RollingMap) <= alignof(tern_map),
              "raise TERN_MAP_WORDS");

std::uint8_t code(Status status) {
  return static_cast<std::uint8_t>(status);
}

std::uint8_t put(const tern::Grid& grid, tern_grid* out) {
  new (out->opaque + 1) tern::Grid(grid);
  out->opaque[0] = tern::kGridTag;
  return code(Status::kOk);
}

/// The grid at `place`. If there is none, puts a new, unbound one there.
tern::Grid& grid_at(tern_grid& place) {
  if (*static_cast<const volatile std::uint64_t*>(place.opaque) != tern::kGridTag) put(tern::Grid{}, &place);
  return *std::launder(reinterpret_cast<tern::Grid*>(place.opaque + 1));
}

}  // namespace

extern "C" {

void tern_map_spec_init(tern_map_spec* spec, const tern_vec3* origin, double cell, tern_voxel dims, double radius) {
  if (spec == nullptr || origin == nullptr) return;
  *spec = tern::map_spec(*origin, cell, dims, radius);
}

std::size_t tern_map_words(const tern_map_spec* spec) {
  return spec == nullptr ? 0 : tern::map_words(*spec);
}

std::uint8_t tern_map_bind(tern_map* map, const tern_map_spec* spec, std::uint64_t* words, std::size_t word_count,
                           std::uint8_t* field) {
  if (map == nullptr || spec == nullptr) return kInvalid;
  RollingMap bound;
  tern::Field wrong = tern::Field::kNone;
  const Status status = bound.bind(*spec, words, word_count, &wrong);
  if (field != nullptr) *field = static_cast<std::uint8_t>(wrong);
  if (status != Status::kOk) return code(status);
  new (map->opaque + 1) RollingMap(bound);
  map->opaque[0] = kMapTag;
  return code(status);
}

std::uint8_t tern_map_begin_frame(tern_map* map, const tern_depth_view* view, const tern_pose* pose, std::int64_t t) {
  return view == nullptr || pose == nullptr ? kInvalid : code(object(map).begin_frame(*view, *pose, t));
}

std::uint8_t tern_map_begin_scan(tern_map* map, const tern_vec3* points, std::size_t count, const tern_vec3* origin,
                                 std::int64_t t) {
  return origin == nullptr ? kInvalid : code(object(map).begin_scan(points, count, *origin, t));
}

std::uint8_t tern_map_begin_beams(tern_map* map, const tern_beams* beams, const tern_vec3* origin, std::int64_t t) {
  return beams == nullptr || origin == nullptr ? kInvalid : code(object(map).begin_scan(*beams, *origin, t));
}

std::uint8_t tern_map_follow(tern_map* map, const tern_vec3* center) {
  return center == nullptr ? kInvalid : code(object(map).follow(*center));
}

std::uint8_t tern_map_forget_time(tern_map* map) {
  return code(object(map).forget_time());
}

std::uint8_t tern_map_step(tern_map* map, std::uint32_t work) {
  return code(object(map).step(work));
}

std::uint8_t tern_map_busy(const tern_map* map) {
  return object(map).busy() ? 1 : 0;
}

std::uint8_t tern_map_assume_free(tern_map* map, const tern_vec3* center, double radius) {
  return center == nullptr ? kInvalid : code(object(map).assume_free(*center, radius));
}

std::uint8_t tern_map_assume_column(tern_map* map, const tern_cylinder* column) {
  return column == nullptr ? kInvalid : code(object(map).assume_column(*column));
}

std::uint8_t tern_map_mark_box(tern_map* map, const tern_box* world) {
  return world == nullptr ? kInvalid : code(object(map).mark_box(*world));
}

std::uint8_t tern_map_mark_cylinder(tern_map* map, const tern_cylinder* world) {
  return world == nullptr ? kInvalid : code(object(map).mark_cylinder(*world));
}

std::uint8_t tern_map_mark_points(tern_map* map, const tern_vec3* world, std::size_t count) {
  return code(object(map).mark_points(world, count));
}

std::uint8_t tern_map_route(const tern_map* map, tern_grid* grid) {
  const RollingMap bound = object(map);
  return bound.bound() && grid != nullptr ? put(bound.route(), grid) : kInvalid;
}

std::uint8_t tern_map_safe(const tern_map* map, tern_grid* grid) {
  const RollingMap bound = object(map);
  return bound.bound() && grid != nullptr ? put(bound.safe(), grid) : kInvalid;
}

std::uint8_t tern_map_snapshot(tern_map* map, tern_grid* grid, std::uint64_t* words, std::size_t word_count) {
  return grid == nullptr ? kInvalid : code(object(map).snapshot(grid_at(*grid), words, word_count));
}

std::uint8_t tern_map_begin_snapshot(tern_map* map, tern_grid* grid, std::uint64_t* words, std::size_t word_count) {
  return grid == nullptr ? kInvalid : code(object(map).begin_snapshot(grid_at(*grid), words, word_count));
}

std::uint8_t tern_map_seen(const tern_map* map, tern_voxel voxel) {
  return object(map).seen(voxel) ? 1 : 0;
}

std::uint64_t tern_map_revision(const tern_map* map) {
  return object(map).revision();
}

}  // extern "C"
