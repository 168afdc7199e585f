// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_TESTS_SUPPORT_SLAB_HPP
#define TERN_TESTS_SUPPORT_SLAB_HPP

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "base/math.hpp"
#include "grid/lattice.hpp"
#include "support/grid_storage.hpp"
#include "support/random.hpp"
#include "tern/fence.hpp"

namespace tern_test {

/// What makes the slab thin.
enum class ThinBy { kBoundary, kKeepIn };

/// A boundary, or the keep-in of a geofence, that holds no whole voxel on one axis, and boxes around it. Which voxels
/// are free and how they are connected is worked out here, from the obstacle voxels alone.
class Slab {
 public:
  static constexpr double kCell = 0.1;
  static constexpr int kSize = 40;

  explicit Slab(Random& random, ThinBy by = ThinBy::kBoundary)
      : thin_(random.integer(0, 2)), thin_spec_(spec_of(random, thin_)), owned_(bound_spec(random, by)) {
    fence_ = keep_in(random);
    for (int k = random.integer(0, 40); k > 0; --k) add(random);
    owned_.grid.inflate();
    for_each([this](const tern::Voxel& v) {
      if (owned_.grid.obstacle(v)) obstacles_.push_back(v);
    });
    find_parts();
  }

  const tern::Grid& grid() const { return owned_.grid; }
  const tern::GridSpec& spec() const { return owned_.grid.spec(); }
  int thin() const { return thin_; }
  /// Where the centre may be.
  const tern::Box& box() const { return thin_spec_.boundary; }
  /// The box as a geofence, in a random order, with normals of any length; often only the two planes that matter.
  tern::Fence fence() const { return {fence_.data(), static_cast<int>(fence_.size()), tern::FenceKind::kKeepIn}; }
  /// All free voxels.
  const std::vector<tern::Voxel>& free() const { return free_; }
  /// Free voxels with equal numbers are connected through faces; 0 for others.
  int part(const tern::Voxel& v) const { return part_[at(v)]; }

  /// A point of a free voxel inside the boundary, often on one of its faces.
  tern::Vec3 point(Random& random, const tern::Voxel& v) const {
    tern::Vec3 p{};
    for (int a = 0; a < 3; ++a) {
      const Range range = clip(v, a);
      double x = random.real(range.lower, range.upper);
      if (a == thin_ && random.chance(0.3)) x = random.chance(0.5) ? range.lower : range.upper;
      x = std::max(x, tern::axis(box().lower, a));
      tern::axis(p, a) = std::min(x, tern::axis(box().upper, a));
    }
    return p;
  }

  double clearance(const tern::Vec3& p) const {
    double least = 1e300;
    for (const tern::Voxel& o : obstacles_) {
      double squared = 0.0;
      for (int a = 0; a < 3; ++a) {
        const double lower = tern::axis(spec().origin, a) + kCell * tern::axis(o, a);
        const double gap = std::max({0.0, lower - tern::axis(p, a), tern::axis(p, a) - lower - kCell});
        squared += gap * gap;
      }
      least = std::min(least, squared);
    }
    return std::sqrt(least);
  }

 private:
  struct Range {
    double lower;
    double upper;
  };

  /// On a lattice plane or anywhere; no height, or up to a voxel's; in the middle of a grid, or in one of one layer.
  static tern::GridSpec spec_of(Random& random, int thin) {
    const double radius = random.chance(0.5) ? kCell * random.integer(0, 3) : random.real(0.05, 0.35);
    const int around = static_cast<int>(std::ceil(radius / kCell)) + 1;
    const bool one_layer = random.chance(0.2);
    tern::Voxel dims{kSize, kSize, kSize};
    tern::axis(dims, thin) = one_layer ? 1 : 2 * around + 1;
    tern::Vec3 origin{0.0, 0.0, 0.0};
    if (random.chance(0.5)) origin = {-3.0, 712.5, 0.5};
    tern::GridSpec spec = whole_grid(dims, kCell, radius, origin);
    const double height = random.chance(0.4) ? 0.0 : random.real(0.01, 0.95);
    double from = (one_layer ? 0 : around) + (random.chance(0.4) ? 0.0 : random.unit());
    if (one_layer) from = std::min(from, 1.0 - height);
    tern::axis(spec.boundary.lower, thin) = tern::axis(origin, thin) + from * kCell;
    tern::axis(spec.boundary.upper, thin) = tern::axis(origin, thin) + (from + height) * kCell;
    return spec;
  }

  /// The spec that the grid is bound to. With a keep-in, each face of its boundary is one of the slab, the grid's, or
  /// cuts a voxel anywhere between.
  tern::GridSpec bound_spec(Random& random, ThinBy by) const {
    tern::GridSpec spec = thin_spec_;
    if (by == ThinBy::kBoundary) return spec;
    const double floor = tern::axis(spec.origin, thin_);
    const double ceiling = floor + kCell * tern::axis(spec.dims, thin_);
    double& lower = tern::axis(spec.boundary.lower, thin_);
    double& upper = tern::axis(spec.boundary.upper, thin_);
    if (random.chance(0.8)) lower = random.chance(0.7) ? std::min(floor, lower) : random.real(floor, lower);
    if (random.chance(0.8)) upper = random.chance(0.7) ? std::max(ceiling, upper) : random.real(upper, ceiling);
    return spec;
  }

  std::vector<tern::Halfspace> keep_in(Random& random) const {
    tern::Halfspace faces[tern::kBoxPlanes];
    tern::box_planes(thin_spec_.boundary, faces);
    const bool all = random.chance(0.5);
    std::vector<tern::Halfspace> planes;
    for (int k = 0; k < tern::kBoxPlanes; ++k) {
      if (!all && k / 2 != thin_) continue;
      const double scale = random.chance(0.5) ? 1.0 : random.real(0.1, 30.0);
      planes.push_back({scale * faces[k].normal, scale * faces[k].offset});
      if (random.chance(0.2)) tern::axis(planes.back().normal, (k / 2 + 1) % 3) = scale * 6e-17;  // of a sine
      if (random.chance(0.5)) std::swap(planes.front(), planes.back());
    }
    return planes;
  }

  void add(Random& random) {
    tern::Box box{};
    for (int a = 0; a < 3; ++a) {
      const int count = tern::axis(spec().dims, a);
      const double lower = tern::axis(spec().origin, a) + kCell * random.integer(0, count - 1);
      tern::axis(box.lower, a) = lower;
      tern::axis(box.upper, a) = lower + kCell * random.integer(1, a == thin_ ? count : 9) - 1e-6;
    }
    owned_.grid.mark_box(box);
  }

  template <typename Visit>
  void for_each(Visit visit) const {
    const tern::Voxel& dims = spec().dims;
    for (int z = 0; z < dims.z; ++z) {
      for (int y = 0; y < dims.y; ++y) {
        for (int x = 0; x < dims.x; ++x) visit(tern::Voxel{x, y, z});
      }
    }
  }

  std::size_t at(const tern::Voxel& v) const {
    const tern::Voxel& dims = spec().dims;
    return static_cast<std::size_t>((v.z * dims.y + v.y) * dims.x + v.x);
  }

  /// What the boundary leaves of a voxel on one axis; lower > upper where that is nothing.
  Range clip(const tern::Voxel& v, int a) const {
    const double lower = tern::axis(spec().origin, a) + kCell * tern::axis(v, a);
    return {std::max(lower, tern::axis(box().lower, a)), std::min(lower + kCell, tern::axis(box().upper, a))};
  }

  /// The boundary is whole on the other axes. A layer that a slab of some height only touches does not count.
  bool is_inside(const tern::Voxel& v) const {
    const double height = tern::axis(box().upper, thin_) - tern::axis(box().lower, thin_);
    const Range range = clip(v, thin_);
    const double left = range.upper - range.lower;
    return height < 1e-9 ? left > -1e-9 : left > 1e-9;
  }

  bool is_clear(const tern::Voxel& v) const {
    const double cells = spec().radius / kCell;
    for (const tern::Voxel& o : obstacles_) {
      int squared = 0;
      for (int a = 0; a < 3; ++a) {
        const int gap = std::max(0, std::abs(tern::axis(v, a) - tern::axis(o, a)) - 1);
        squared += gap * gap;
      }
      if (squared < cells * cells - 1e-7 || (v.x == o.x && v.y == o.y && v.z == o.z)) return false;
    }
    return true;
  }

  void find_parts() {
    const tern::Voxel& dims = spec().dims;
    part_.assign(at({0, 0, dims.z}), 0);
    std::vector<bool> open(part_.size());
    for_each([&](const tern::Voxel& v) {
      open[at(v)] = is_inside(v) && is_clear(v);
      if (open[at(v)]) free_.push_back(v);
    });
    int parts = 0;
    for (const tern::Voxel& seed : free_) {
      if (part_[at(seed)] == 0) flood(seed, ++parts, open);
    }
  }

  void flood(const tern::Voxel& seed, int number, const std::vector<bool>& open) {
    std::vector<tern::Voxel> waiting{seed};
    part_[at(seed)] = number;
    while (!waiting.empty()) {
      const tern::Voxel v = waiting.back();
      waiting.pop_back();
      for (int k = 0; k < 6; ++k) {
        tern::Voxel next = v;
        tern::axis(next, k / 2) += k % 2 == 0 ? 1 : -1;
        if (!owned_.grid.inside(next) || !open[at(next)] || part_[at(next)] != 0) continue;
        part_[at(next)] = number;
        waiting.push_back(next);
      }
    }
  }

  int thin_;
  tern::GridSpec thin_spec_;  ///< of a grid whose boundary is the slab
  OwnedGrid owned_;
  std::vector<tern::Halfspace> fence_;
  std::vector<tern::Voxel> obstacles_;
  std::vector<int> part_;
  std::vector<tern::Voxel> free_;
};

}  // namespace tern_test

#endif
