// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_TESTS_SUPPORT_PATH_WORLD_HPP
#define TERN_TESTS_SUPPORT_PATH_WORLD_HPP

#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <vector>

#include "path/search_stage.hpp"
#include "path/shortcut_stage.hpp"
#include "support/random.hpp"

namespace tern_test {

/// A grid whose blocked voxels are chosen one by one: cell 1, radius 0, origin 0 unless said otherwise.
class VoxelWorld {
 public:
  explicit VoxelWorld(tern::Voxel dims, double cell = 1.0, double radius = 0.0) : words_(tern::grid_words(dims)) {
    tern::GridSpec spec{};
    spec.cell = cell;
    spec.dims = dims;
    spec.boundary = {{0.0, 0.0, 0.0}, {dims.x * cell, dims.y * cell, dims.z * cell}};
    spec.radius = radius;
    grid.bind(spec, words_.data(), words_.size());
    grid.inflate();
  }

  /// Blocks a box of voxels, both corners included.
  VoxelWorld& block(const tern::Voxel& lower, const tern::Voxel& upper) {
    for (int z = lower.z; z <= upper.z; ++z) {
      for (int y = lower.y; y <= upper.y; ++y) {
        for (int x = lower.x; x <= upper.x; ++x) grid.mark_voxel({x, y, z});
      }
    }
    grid.inflate();
    return *this;
  }
  VoxelWorld& block(const tern::Voxel& voxel) { return block(voxel, voxel); }
  VoxelWorld& clear(const tern::Voxel& voxel) {
    grid.clear_voxel(voxel);
    grid.inflate();
    return *this;
  }

  tern::Grid grid;

 private:
  std::vector<std::uint64_t> words_;
};

/// What a path is asked for: the search stage's query.
struct PathQuery {
  tern::Vec3 start;
  tern::Vec3 goal;
  bool start_moves = false;
  bool goal_moves = false;
  tern::SearchMode search = tern::SearchMode::kOptimal;
  bool few_legs = false;
};

/// Runs the search stage and the shortcut stage in memory that starts as garbage.
class PathRunner {
 public:
  PathRunner() : search_(new tern::SearchStage), shortcut_(new tern::ShortcutStage), path_(new tern::Path) {
    fill(0xA5);
  }

  void fill(unsigned char byte) {
    std::memset(static_cast<void*>(search_.get()), byte, sizeof *search_);
    std::memset(static_cast<void*>(shortcut_.get()), byte, sizeof *shortcut_);
    std::memset(static_cast<void*>(path_.get()), byte, sizeof *path_);
  }

  /// Runs a query to its end in slices of `slice` units.
  tern::Status run(const tern::Grid& grid, const PathQuery& query, std::uint32_t slice = 0xFFFFFFFFu) {
    last_ = tern::Stage::kSearch;
    shortcut_->pieces = 0;  // stays so where the search fails
    tern::search_begin(*search_, tern::World(grid),
                       {query.start, query.goal, query.start_moves, query.goal_moves, query.search});
    const auto search = [&](tern::Work& work) {
      return tern::search_advance(*search_, tern::World(grid), work, *path_);
    };
    if (run_in_slices(search, slice) == tern::Progress::kFailed) return search_->status;
    last_ = tern::Stage::kShortcut;
    tern::shortcut_begin(*shortcut_, grid, *path_, query.few_legs);
    const auto shorten = [&](tern::Work& work) { return tern::shortcut_advance(*shortcut_, grid, work, *path_); };
    return run_in_slices(shorten, slice) == tern::Progress::kFailed ? shortcut_->status : tern::Status::kOk;
  }

  tern::Status run(const tern::Grid& grid, const tern::Vec3& start, const tern::Vec3& goal) {
    return run(grid, PathQuery{start, goal});
  }

  tern::Status run(const tern::Grid& grid, const tern::Voxel& start, const tern::Voxel& goal) {
    return run(grid, grid.center(start), grid.center(goal));
  }

  const tern::SearchStage& search() const { return *search_; }
  const tern::ShortcutStage& shortcut() const { return *shortcut_; }
  /// The stage that ended the last run.
  tern::Stage last() const { return last_; }
  const tern::Path& path() const { return *path_; }

 private:
  template <typename Advance>
  static tern::Progress run_in_slices(const Advance& advance, std::uint32_t slice) {
    tern::Progress progress = tern::Progress::kMore;
    while (progress == tern::Progress::kMore) {
      tern::Work work{slice};
      progress = advance(work);
    }
    return progress;
  }

  tern::Stage last_ = tern::Stage::kSearch;
  std::unique_ptr<tern::SearchStage> search_;
  std::unique_ptr<tern::ShortcutStage> shortcut_;
  std::unique_ptr<tern::Path> path_;
};

/// Distance of two points, apart from the core's own.
inline double between(const tern::Vec3& a, const tern::Vec3& b) {
  return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z));
}

/// The path that the shortcut's chain alone makes of a path's raw points, before it is pulled tight.
inline tern::Path chain_of(const tern::Grid& grid, const tern::Path& path) {
  tern::Path chain = path;
  const std::unique_ptr<tern::Shortcut> shortcut(new tern::Shortcut);
  tern::shortcut_begin(*shortcut, grid, chain);
  while (tern::shortcut_needs_step(*shortcut, chain)) tern::shortcut_step(*shortcut, grid, chain);
  tern::shortcut_finish(*shortcut, chain);
  return chain;
}

/// Any voxel of a grid.
inline tern::Voxel random_voxel(Random& random, const tern::Voxel& dims) {
  return {random.integer(0, dims.x - 1), random.integer(0, dims.y - 1), random.integer(0, dims.z - 1)};
}

/// A free voxel of the grid, chosen at random; false where there is none among 200 tries.
inline bool random_free(const tern::Grid& grid, Random& random, tern::Voxel& out) {
  const tern::Voxel& dims = grid.spec().dims;
  for (int k = 0; k < 200; ++k) {
    out = random_voxel(random, dims);
    if (grid.free(out)) return true;
  }
  return false;
}

/// Two free voxels; false where one was not found.
inline bool random_ends(const tern::Grid& grid, Random& random, tern::Voxel& start, tern::Voxel& goal) {
  return random_free(grid, random, start) && random_free(grid, random, goal);
}

/// Grids of many densities and shapes: noise, boxes and mazes; cubes, towers, plates, rods and rows beyond one word.
inline VoxelWorld random_world(Random& random) {
  static const tern::Voxel kShapes[] = {{10, 10, 10}, {6, 6, 24}, {20, 16, 3},  {18, 18, 1}, {1, 16, 16},
                                        {17, 1, 17},  {40, 1, 1}, {80, 6, 5},   {130, 4, 4}, {66, 9, 2},
                                        {5, 40, 5},   {3, 3, 60}, {12, 13, 14}, {64, 5, 5},  {2, 2, 2}};
  const tern::Voxel dims = kShapes[random.integer(0, 14)];
  VoxelWorld world(dims);
  const int kind = random.integer(0, 2);
  const double density = random.real(0.0, kind == 0 ? 0.6 : 0.35);
  const int cells = dims.x * dims.y * dims.z;
  int marked = 0;
  for (int k = 0; k < cells && marked < static_cast<int>(density * cells); ++k) {
    tern::Voxel low{random.integer(0, dims.x - 1), random.integer(0, dims.y - 1), random.integer(0, dims.z - 1)};
    tern::Voxel size{0, 0, 0};
    if (kind == 1) size = {random.integer(0, 4), random.integer(0, 4), random.integer(0, 4)};
    // A wall across the map with a hole in it.
    if (kind == 2) {
      const int axis = random.integer(0, 2);
      size = {axis == 0 ? 0 : dims.x, axis == 1 ? 0 : dims.y, axis == 2 ? 0 : dims.z};
      if (axis != 0) low.x = 0;
      if (axis != 1) low.y = 0;
      if (axis != 2) low.z = 0;
    }
    for (int z = low.z; z <= low.z + size.z && z < dims.z; ++z) {
      for (int y = low.y; y <= low.y + size.y && y < dims.y; ++y) {
        for (int x = low.x; x <= low.x + size.x && x < dims.x; ++x) {
          marked += world.grid.obstacle({x, y, z}) ? 0 : 1;
          world.grid.mark_voxel({x, y, z});
        }
      }
    }
    if (kind == 2) {
      for (int hole = random.integer(1, 3); hole > 0; --hole) {
        const tern::Voxel v{random.integer(low.x, std::min(low.x + size.x, dims.x - 1)),
                            random.integer(low.y, std::min(low.y + size.y, dims.y - 1)),
                            random.integer(low.z, std::min(low.z + size.z, dims.z - 1))};
        world.grid.clear_voxel(v);
      }
    }
  }
  world.grid.inflate();
  return world;
}

}  // namespace tern_test

#endif
