// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The gate's second image: what each loop costs at its configured bound. Prints one CSV row a cap; gate.py fails where
// a row did not reach its bound. docs/timing.md says what the rows mean and leave out.
#include <cstddef>

#include "baremetal/board.hpp"
#include "caps/cap.hpp"

namespace tern_caps {
namespace {

using tern_board::print;

constexpr std::size_t kLayerWords = static_cast<std::size_t>(tern::kMaxCells) / 64;
/// Two layers, and room for the map of their changes, which takes less than a sixteenth of a layer.
constexpr std::size_t kGridWords = 2 * kLayerWords + kLayerWords / 16;

TERN_BOARD_LARGE std::uint64_t words[kGridWords];
TERN_BOARD_LARGE alignas(64) unsigned char block[kMemoryBytes];

}  // namespace

void report(const Cap& cap) {
  print(cap.name, ",", cap.stage, ",", cap.count, ",", cap.reached, ",", cap.capacity, ",", cap.units, ",", cap.times,
        "\n");
}

tern::Grid make_grid(const tern::Voxel& dims, double cell, double radius) {
  tern::GridSpec spec{};
  spec.cell = cell;
  spec.dims = dims;
  spec.boundary.upper = {dims.x * cell, dims.y * cell, dims.z * cell};
  spec.radius = radius;
  tern::Grid grid;
  grid.bind(spec, words, kGridWords);
  return grid;
}

void* memory() noexcept {
  return block;
}

std::uint64_t now() noexcept {
  return tern_board::counter();
}

tern::Request request_between(const tern::Vec3& start, const tern::Vec3& goal) {
  tern::Request request{};
  request.start.position = start;
  request.goal.position = goal;
  request.limits = {{2.0, 2.0, 2.0}, {2.0, 2.0, 2.0}, {-2.0, -2.0, -2.0}, {-2.0, -2.0, -2.0}};
  return request;
}

}  // namespace tern_caps

int main() {
  tern_board::print("# ", tern_board::name(), ", ", tern_board::counter_unit(), "\n# compiler ", __VERSION__, "\n");
  tern_board::print("cap,stage,count,reached,capacity,units,times\n");
  tern_caps::grid_caps();
  tern_caps::search_caps();
  tern_caps::guided_caps();
  tern_caps::shortcut_caps();
  tern_caps::corridor_caps();
  tern_caps::programme_caps();
  tern_caps::check_caps();
  tern_caps::map_caps();
  tern_caps::yaw_caps();
  tern_caps::via_caps();
  tern_caps::track_caps();
  return 0;
}
