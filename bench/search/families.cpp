// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "search/families.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <vector>

#include "draw.hpp"

namespace tern_bench {
namespace {

using tern::Voxel;

constexpr Voxel kDims{200, 160, 40};
constexpr int kApart = 60;
constexpr double kCell = 0.1;

void fill(World& world, const Voxel& low, const Voxel& high) {
  for (int z = std::max(low.z, 0); z <= std::min(high.z, kDims.z - 1); ++z) {
    for (int y = std::max(low.y, 0); y <= std::min(high.y, kDims.y - 1); ++y) {
      for (int x = std::max(low.x, 0); x <= std::min(high.x, kDims.x - 1); ++x) world.grid.mark_voxel({x, y, z});
    }
  }
}

void clear(World& world, const Voxel& low, const Voxel& high) {
  for (int z = std::max(low.z, 0); z <= std::min(high.z, kDims.z - 1); ++z) {
    for (int y = std::max(low.y, 0); y <= std::min(high.y, kDims.y - 1); ++y) {
      for (int x = std::max(low.x, 0); x <= std::min(high.x, kDims.x - 1); ++x) world.grid.clear_voxel({x, y, z});
    }
  }
}

Voxel random_voxel(Draw& draw) {
  const int x = draw.integer(0, kDims.x - 1);
  const int y = draw.integer(0, kDims.y - 1);
  return {x, y, draw.integer(0, kDims.z - 1)};
}

/// How many obstacles fill `percent` of the world, if each blocks this many voxels and none overlap.
int count_for(int percent, int voxels) {
  return kDims.x * kDims.y * kDims.z / 100 * percent / voxels;
}

void add_noise(Draw& draw, int radius, World& world) {
  const int wide = 2 * radius + 1;
  const int count = count_for(draw.integer(5, 60), radius == 0 ? 2 : wide * wide * wide / 2);
  for (int k = 0; k < count; ++k) world.grid.mark_voxel(random_voxel(draw));
}

void add_plates(Draw& draw, int radius, World& world) {
  const int side = 8 + 4 * radius;
  const int count = count_for(draw.integer(5, 50), side * side * (2 * radius + 1));
  for (int k = 0; k < count; ++k) {
    const Voxel low = random_voxel(draw);
    int size[3] = {draw.integer(3, 2 * side), draw.integer(3, 2 * side), draw.integer(3, 2 * side)};
    size[draw.integer(0, 2)] = 1;
    fill(world, low, {low.x + size[0] - 1, low.y + size[1] - 1, low.z + size[2] - 1});
  }
}

void add_pillars(Draw& draw, int radius, World& world) {
  const int wide = 3 + 2 * radius;
  const int count = count_for(draw.integer(10, 60), wide * wide * kDims.z);
  for (int k = 0; k < count; ++k) {
    const Voxel low = random_voxel(draw);
    const int side = draw.integer(0, 5);
    fill(world, {low.x, low.y, 0}, {low.x + side, low.y + draw.integer(0, 5), kDims.z - 1});
  }
}

/// A depth-first maze: everything is filled, then rooms and passages are cleared.
void add_maze(Draw& draw, int radius, World& world) {
  const int lane = 2 * radius + draw.integer(2, 6);
  const int pitch = lane + draw.integer(1, 2);
  const int count[3] = {kDims.x / pitch, kDims.y / pitch, std::max(1, kDims.z / pitch)};
  fill(world, {0, 0, 0}, {kDims.x - 1, kDims.y - 1, kDims.z - 1});
  const auto room = [&](int index) {
    return Voxel{pitch * (index % count[0]), pitch * (index / count[0] % count[1]),
                 pitch * (index / count[0] / count[1])};
  };
  const auto join = [&](int a, int b) {
    const Voxel low = room(std::min(a, b));
    const Voxel high = room(std::max(a, b));
    clear(world, low, {high.x + lane - 1, high.y + lane - 1, high.z + lane - 1});
  };
  const int steps[3] = {1, count[0], count[0] * count[1]};
  const auto neighbour = [&](int index) {
    const int axis = draw.integer(0, 2);
    const int at = index / steps[axis] % count[axis];
    const int to = at + (draw.integer(0, 1) == 0 ? -1 : 1);
    return to < 0 || to >= count[axis] ? index : index + (to - at) * steps[axis];
  };
  const int rooms = steps[2] * count[2];
  std::vector<bool> seen(static_cast<std::size_t>(rooms));
  std::vector<int> trail{draw.integer(0, rooms - 1)};
  seen[static_cast<std::size_t>(trail[0])] = true;
  join(trail[0], trail[0]);
  while (!trail.empty()) {
    const int from = trail.back();
    int to = from;
    for (int k = 0; k < 12 && (to == from || seen[static_cast<std::size_t>(to)]); ++k) to = neighbour(from);
    if (to == from || seen[static_cast<std::size_t>(to)]) {
      trail.pop_back();
      continue;
    }
    seen[static_cast<std::size_t>(to)] = true;
    join(from, to);
    trail.push_back(to);
  }
  for (int k = rooms / 20; k > 0; --k) {
    const int from = draw.integer(0, rooms - 1);
    join(from, neighbour(from));
  }
}

/// A wall through one storey, with doors.
void add_wall(Draw& draw, int door, int floor, int ceiling, World& world) {
  const bool along_x = draw.integer(0, 1) == 0;
  const int length = along_x ? kDims.x : kDims.y;
  const int at = draw.integer(0, (along_x ? kDims.y : kDims.x) - 1);
  const auto voxel = [&](int along, int z) { return along_x ? Voxel{along, at, z} : Voxel{at, along, z}; };
  fill(world, voxel(0, floor), voxel(length - 1, ceiling));
  for (int doors = draw.integer(2, 5); doors > 0; --doors) {
    const int from = draw.integer(0, length - door);
    clear(world, voxel(from, floor), voxel(from + door - 1, std::min(ceiling, floor + door + 2)));
  }
}

void add_storeys(Draw& draw, int radius, World& world) {
  const int door = 2 * radius + draw.integer(2, 6);
  const int height = door + draw.integer(4, 10);
  const int walls = 300 / (10 + 4 * radius);
  for (int floor = 0; floor < kDims.z; floor += height) {
    const int ceiling = std::min(floor + height, kDims.z) - 1;
    for (int k = draw.integer(2, walls); k > 0; --k) add_wall(draw, door, floor, ceiling, world);
    for (int k = draw.integer(0, 60); k > 0; --k) {
      const Voxel low = random_voxel(draw);
      const int side = draw.integer(0, 8);
      fill(world, {low.x, low.y, floor}, {low.x + side, low.y + draw.integer(0, 8), floor + draw.integer(2, height)});
    }
    if (floor == 0) continue;
    fill(world, {0, 0, floor}, {kDims.x - 1, kDims.y - 1, floor});
    for (int k = draw.integer(1, 4); k > 0; --k) {
      const Voxel low = random_voxel(draw);
      clear(world, {low.x, low.y, floor - 2}, {low.x + 2 * door, low.y + door, floor + 2});
    }
  }
}

int distance(const Voxel& a, const Voxel& b) {
  return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)});
}

Query random_query(Draw& draw, const World& world) {
  for (int k = 0; k < 100000; ++k) {
    const Query query{random_voxel(draw), random_voxel(draw)};
    const bool free = world.grid.free(query.start) && world.grid.free(query.goal);
    if (free && distance(query.start, query.goal) >= kApart) return query;
  }
  throw std::runtime_error("a world without two free voxels far apart");
}

}  // namespace

const char* family_name(Family family) {
  constexpr const char* kNames[kFamilies] = {"noise", "plates", "maze", "pillars", "storeys"};
  return kNames[static_cast<int>(family)];
}

Query build(Family family, int radius, std::uint64_t seed, World& world) {
  tern::GridSpec spec{};
  spec.dims = kDims;
  spec.cell = kCell;
  spec.radius = radius * kCell;
  spec.boundary.upper = {kDims.x * kCell, kDims.y * kCell, kDims.z * kCell};
  world.words.assign(tern::grid_words(spec.dims), 0);
  if (world.grid.bind(spec, world.words.data(), world.words.size()) != tern::Status::kOk)
    throw std::runtime_error("bind");
  Draw draw(seed * 100 + static_cast<std::uint64_t>(radius) * 10 + static_cast<std::uint64_t>(family));
  constexpr void (*kAdd[kFamilies])(Draw&, int, World&) = {add_noise, add_plates, add_maze, add_pillars, add_storeys};
  kAdd[static_cast<int>(family)](draw, radius, world);
  world.grid.inflate();
  return random_query(draw, world);
}

}  // namespace tern_bench
