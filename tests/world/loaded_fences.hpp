// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fences as three grids of different radii load them.
#ifndef TERN_TESTS_WORLD_LOADED_FENCES_HPP
#define TERN_TESTS_WORLD_LOADED_FENCES_HPP

#include <gtest/gtest.h>

#include <memory>

#include "base/math.hpp"
#include "support/corridor_reference.hpp"
#include "support/random.hpp"
#include "world/fences.hpp"
#include "world/solid_layer.hpp"
#include "world/world.hpp"

namespace tern_test {

class FencesTest : public ::testing::Test {
 protected:
  /// The first solid.
  tern::ConvexSolid solid() const { return solid_of(*solids_, solids_->parts[0]); }
  /// All planes of a solid.
  void block(int k, tern::SolidLayer& layer, const tern::Grid& view) {
    tern::Work work;
    prepare_solid(solid_of(*solids_, solids_->parts[k]), layer, view, work);
    for (int z = 0; z < view.spec().dims.z; ++z) block_solid(layer, view, z, work);
  }
  /// Of a grid with this radius: 0, 0.2 or 0.4.
  bool is_clear(const tern::Vec3& from, const tern::Vec3& to, double radius) const {
    const MarkedWorld& marked = radius > 0.3 ? wide_ : radius > 0.1 ? world_ : bare_;
    return tern::World(marked.grid, *solids_).solids_clear(from, to);
  }
  tern::Status load(const std::vector<tern::Fence>& list) {
    return load_fences(world_.grid, list.data(), static_cast<std::int32_t>(list.size()), *solids_).status;
  }
  tern::Status load_one(tern::FenceKind kind, const std::vector<tern::Halfspace>& planes) {
    return load({{planes.data(), static_cast<std::int32_t>(planes.size()), kind}});
  }

  MarkedWorld world_{{40, 40, 20}, 0.1, 0.2};
  MarkedWorld bare_{{40, 40, 20}, 0.1, 0.0};
  MarkedWorld wide_{{40, 40, 20}, 0.1, 0.4};
  std::unique_ptr<tern::Solids> solids_ = std::make_unique<tern::Solids>();
};

inline tern::Vec3 random_unit(Random& random) {
  tern::Vec3 n{random.real(-1.0, 1.0), random.real(-1.0, 1.0), random.real(-1.0, 1.0)};
  const double norm = norm3(n);
  if (norm < 0.1) return {1.0, 0.0, 0.0};
  return {n.x / norm, n.y / norm, n.z / norm};
}

}  // namespace tern_test

#endif
