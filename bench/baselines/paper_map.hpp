// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_BENCH_PAPER_MAP_HPP
#define TERN_BENCH_PAPER_MAP_HPP

#include <cstddef>
#include <vector>

#include "host/scenario.hpp"
#include "tern/vec3.hpp"

namespace tern_bench {

/// The map that the paper's front end searches (Section 3.2.2): every cuboid grown by a margin on all sides, every
/// voxel that it then touches an obstacle. Points outside belong to the nearest voxel. World frame.
class PaperMap {
 public:
  /// `cell` and `margin` in metres. Throws std::invalid_argument for a cell that is not positive.
  PaperMap(const tern_host::Scenario& scenario, double cell, double margin);

  const tern::Voxel& dims() const { return dims_; }
  double cell() const { return cell_; }
  bool inside(const tern::Voxel& v) const;
  /// Nothing outside the map is an obstacle, and nothing there is free.
  bool obstacle(const tern::Voxel& v) const { return inside(v) && obstacles_[index(v)]; }
  bool free(const tern::Voxel& v) const { return inside(v) && !obstacles_[index(v)]; }

  tern::Voxel voxel_of(const tern::Vec3& point) const;
  tern::Vec3 center(const tern::Voxel& v) const;
  std::size_t index(const tern::Voxel& v) const;
  std::size_t cells() const { return obstacles_.size(); }

 private:
  tern::Vec3 origin_;
  double cell_;
  tern::Voxel dims_;
  std::vector<bool> obstacles_;
};

/// The paper's line of sight: points along the segment, about one a voxel, none of them in an obstacle; a point that
/// lies on a face between voxels moves on by a hundredth of a voxel. A corner between two samples goes unseen.
bool sampled_sight(const PaperMap& map, const tern::Vec3& from, const tern::Vec3& to);

}  // namespace tern_bench

#endif
