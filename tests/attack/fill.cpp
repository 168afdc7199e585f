// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The obstacles of each family.
#include "attack/world.hpp"

namespace tern_attack {
namespace {

void fill_box(World& world, const int (&low)[3], const int (&high)[3], bool value) {
  for (int z = low[2]; z < high[2]; ++z) {
    for (int y = low[1]; y < high[1]; ++y) {
      for (int x = low[0]; x < high[0]; ++x) world.set(x, y, z, value);
    }
  }
}

void noise(Rng& rng, World& world, double density) {
  for (std::uint8_t& voxel : world.solid) {
    if (rng.chance(density)) voxel = 1;
  }
}

void boxes(Rng& rng, World& world, int count) {
  for (int k = 0; k < count; ++k) add_box(rng, world, true);
}

/// Walls square to x with one gap each, of 2 * half voxels or one or two more; the last of them through at any height.
void slots(Rng& rng, int half, World& world) {
  const tern::Voxel d = world.spec.dims;
  const int step = rng.integer(2, 4) + 2 * half;
  for (int x = rng.integer(1, step); x < d.x - 1; x += step) {
    fill_box(world, {x, 0, 0}, {x + 1, d.y, d.z}, true);
    const int wide = std::max(1, 2 * half + rng.integer(0, 2));
    const int high = rng.chance(0.5) ? d.z : std::max(1, 2 * half + rng.integer(0, 2));
    const int y = rng.integer(0, std::max(0, d.y - wide));
    const int z = rng.integer(0, std::max(0, d.z - high));
    fill_box(world, {x, y, z}, {x + 1, y + wide, z + high}, false);
  }
}

/// Ways of `wide` voxels between walls one voxel thick, dug by walking at random from room to room.
void maze(Rng& rng, int half, World& world) {
  std::fill(world.solid.begin(), world.solid.end(), 1);
  const tern::Voxel d = world.spec.dims;
  const int wide = 2 * half + 1 + (rng.chance(0.3) ? 1 : 0);
  const int step = wide + rng.integer(1, 2);
  const int rooms[3] = {(d.x - wide) / step + 1, (d.y - wide) / step + 1, (d.z - wide) / step + 1};
  int at[3] = {0, 0, 0};
  const int moves = 2 * rooms[0] * rooms[1] * rooms[2];
  for (int k = 0; k < moves; ++k) {
    const int a = rng.integer(0, rng.chance(0.15) ? 2 : 1);
    int to[3] = {at[0], at[1], at[2]};
    to[a] = std::max(0, std::min(rooms[a] - 1, to[a] + (rng.chance(0.5) ? 1 : -1)));
    int low[3];
    int high[3];
    for (int b = 0; b < 3; ++b) {
      low[b] = std::min(at[b], to[b]) * step;
      high[b] = std::max(at[b], to[b]) * step + wide;
      at[b] = to[b];
    }
    fill_box(world, low, high, false);
  }
}

/// Voxels that touch others at an edge or a corner only.
void corners(Rng& rng, World& world) {
  const tern::Voxel d = world.spec.dims;
  const int count = world.count() / rng.integer(6, 60);
  for (int k = 0; k < count; ++k) {
    const int x = rng.integer(0, d.x - 1);
    const int y = rng.integer(0, d.y - 1);
    const int z = rng.integer(0, d.z - 1);
    const int length = rng.integer(1, 4);
    const int move[3] = {rng.integer(-1, 1), rng.integer(-1, 1), rng.integer(-1, 1)};
    for (int i = 0; i < length; ++i) world.set(x + i * move[0], y + i * move[1], z + i * move[2], true);
  }
  if (!rng.chance(0.2)) return;
  for (int z = 0; z < d.z / 2; ++z) {
    for (int y = 0; y < d.y; ++y) {
      for (int x = 0; x < d.x / 2; ++x) world.set(x, y, z, (x + y + z) % 2 == 0);
    }
  }
}

/// Stairs up, stairs down or none along x and y, under a ceiling with the same steps.
void stairs(Rng& rng, int half, World& world) {
  const tern::Voxel d = world.spec.dims;
  const int tread = rng.integer(1, 3);
  const int slope_x = rng.integer(-1, 1);
  const int slope_y = rng.integer(-1, 1);
  const int gap = 2 * half + rng.integer(1, 4);
  const int base = rng.integer(0, d.z - 1);
  for (int y = 0; y < d.y; ++y) {
    for (int x = 0; x < d.x; ++x) {
      const int raw = base + (slope_x * x + slope_y * y) / tread;
      const int rise = 2 * std::max(1, d.z - gap);
      const int folded = ((raw % rise) + rise) % rise;
      const int floor = folded < rise / 2 ? folded : rise - folded;
      for (int z = 0; z < d.z; ++z) world.set(x, y, z, z < floor || z >= floor + gap);
    }
  }
}

/// Solid, with winding tunnels of 2 * half + 1 voxels.
void tunnels(Rng& rng, int half, World& world) {
  std::fill(world.solid.begin(), world.solid.end(), 1);
  const tern::Voxel d = world.spec.dims;
  int at[3] = {rng.integer(half, d.x - 1), rng.integer(half, d.y - 1), rng.integer(half, d.z - 1)};
  const int legs = rng.integer(4, 24);
  for (int k = 0; k < legs; ++k) {
    const int a = rng.integer(0, 2);
    const int to = rng.integer(half, axis(d, a) - 1 - half);
    int low[3];
    int high[3];
    for (int b = 0; b < 3; ++b) {
      low[b] = at[b] - half;
      high[b] = at[b] + half + 1;
    }
    low[a] = std::min(at[a], to) - half;
    high[a] = std::max(at[a], to) + half + 1;
    at[a] = to;
    fill_box(world, low, high, false);
  }
}

}  // namespace

void add_box(Rng& rng, World& world, bool value) {
  int low[3];
  int high[3];
  for (int a = 0; a < 3; ++a) {
    const int count = axis(world.spec.dims, a);
    low[a] = rng.integer(-2, count - 1);
    high[a] = low[a] + rng.integer(1, std::max(2, count / 3));
  }
  if (rng.chance(0.4)) {
    low[2] = 0;
    high[2] = world.spec.dims.z;
  }
  fill_box(world, low, high, value);
}

void fill(Rng& rng, Family family, int half, World& world) {
  switch (family) {
    case Family::kNoise:
      return noise(rng, world, rng.real(0.005, half > 0 ? 0.08 : 0.4));
    case Family::kBoxes:
      return boxes(rng, world, rng.integer(1, 14));
    case Family::kSlots:
      return slots(rng, half, world);
    case Family::kMaze:
      return maze(rng, half, world);
    case Family::kCorners:
      return corners(rng, world);
    case Family::kStairs:
      return stairs(rng, half, world);
    case Family::kTunnels:
      return tunnels(rng, half, world);
    case Family::kFar:
      return rng.chance(0.75) ? void() : noise(rng, world, 0.002);
    case Family::kFences:
      return boxes(rng, world, rng.integer(0, 3));
    case Family::kChanges:
      return boxes(rng, world, rng.integer(2, 12));
  }
}

}  // namespace tern_attack
