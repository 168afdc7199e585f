// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_TESTS_SUPPORT_WORLD_HPP
#define TERN_TESTS_SUPPORT_WORLD_HPP

#include <cstdint>
#include <cstring>
#include <memory>
#include <vector>

#include "tern/tern.hpp"

namespace tern_test {

/// A grid with its storage, and a planner with its memory: what a test of the whole planner needs.
class World {
 public:
  /// An empty grid of dims voxels at `origin`, the boundary its whole box.
  World(tern::Voxel dims, double cell, double radius, tern::Vec3 origin = {0.0, 0.0, 0.0})
      : words(tern::grid_words(dims)),
        memory(new unsigned char[tern::kWorkspaceBytes]),
        planner(memory.get(), tern::kWorkspaceBytes) {
    spec.origin = origin;
    spec.cell = cell;
    spec.dims = dims;
    spec.boundary = {origin, {origin.x + dims.x * cell, origin.y + dims.y * cell, origin.z + dims.z * cell}};
    spec.radius = radius;
    bind_status = grid.bind(spec, words.data(), words.size());
    request.limits = {{2.0, 2.0, 2.0}, {2.0, 2.0, 2.0}};
  }

  /// Marks a box given relative to the origin.
  World& block(tern::Vec3 lower, tern::Vec3 upper) {
    const tern::Vec3& o = spec.origin;
    grid.mark_box({{o.x + lower.x, o.y + lower.y, o.z + lower.z}, {o.x + upper.x, o.y + upper.y, o.z + upper.z}});
    return *this;
  }

  World& from(tern::Vec3 p) {
    request.start.position = {spec.origin.x + p.x, spec.origin.y + p.y, spec.origin.z + p.z};
    return *this;
  }

  World& to(tern::Vec3 p) {
    request.goal.position = {spec.origin.x + p.x, spec.origin.y + p.y, spec.origin.z + p.z};
    return *this;
  }

  /// Inflates and plans; the trajectory is first filled with a pattern so that a write on failure shows.
  tern::Status plan() {
    grid.inflate();
    return replan();
  }

  tern::Status replan() {
    std::memset(static_cast<void*>(&trajectory), 0x5A, sizeof trajectory);
    return planner.plan(grid, request, trajectory, report);
  }

  bool trajectory_untouched() const {
    const auto* bytes = reinterpret_cast<const unsigned char*>(&trajectory);
    for (std::size_t i = 0; i < sizeof trajectory; ++i) {
      if (bytes[i] != 0x5A) return false;
    }
    return true;
  }

  tern::GridSpec spec{};
  std::vector<std::uint64_t> words;
  std::unique_ptr<unsigned char[]> memory;
  tern::Grid grid;
  tern::Planner planner;
  tern::Request request{};
  tern::Trajectory trajectory{};
  tern::Report report{};
  tern::Status bind_status = tern::Status::kOk;
};

/// 4 x 4 x 2 m with nothing in it, and a request through its middle.
inline World open_world() {
  World world({40, 40, 20}, 0.1, 0.2);
  world.from({0.55, 0.55, 1.05}).to({3.45, 3.45, 1.05});
  return world;
}

}  // namespace tern_test

#endif
