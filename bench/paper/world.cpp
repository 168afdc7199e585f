// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "paper/world.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "host/figures.hpp"
#include "host/grid_layout.hpp"

namespace tern_bench {
namespace {

using tern::Vec3;
using tern::Voxel;

constexpr double kSampleStep = 2e-3;

void require(tern::Status status) {
  if (status != tern::Status::kOk) throw std::runtime_error(tern::status_name(status));
}

}  // namespace

ScenarioGrid::ScenarioGrid(const tern_host::Scenario& scenario) {
  const tern::GridSpec spec = tern_host::lay_out_grid(scenario);
  words_.resize(tern::grid_words(spec.dims));
  require(grid_.bind(spec, words_.data(), words_.size()));
  for (const tern_host::Block& block : scenario.blocks) require(grid_.mark_box(block.box));
  grid_.inflate();
}

bool ScenarioGrid::nearest_free(const Vec3& point, Voxel& voxel) const {
  const Voxel at = grid_.voxel_of(grid_.to_local(point));
  const Voxel& dims = grid_.spec().dims;
  for (int ring = 0; ring < std::max({dims.x, dims.y, dims.z}); ++ring) {
    for (int z = at.z - ring; z <= at.z + ring; ++z) {
      for (int y = at.y - ring; y <= at.y + ring; ++y) {
        for (int x = at.x - ring; x <= at.x + ring; ++x) {
          voxel = {x, y, z};
          if (grid_.free(voxel)) return true;
        }
      }
    }
  }
  return false;
}

Vec3 ScenarioGrid::to_world(const Vec3& local) const {
  const Vec3& o = grid_.spec().origin;
  return {o.x + local.x, o.y + local.y, o.z + local.z};
}

std::vector<Vec3> ScenarioGrid::chain(const Vec3& start, const std::vector<Voxel>& voxels, const Vec3& goal) const {
  std::vector<Vec3> points{start};
  for (const Voxel& voxel : voxels) points.push_back(to_world(grid_.center(voxel)));
  points.push_back(goal);
  return points;
}

double clearance(const std::vector<Vec3>& points, const tern_host::Scenario& scenario) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Vec3& a = points[i - 1];
    const Vec3& b = points[i];
    const int steps = std::max(1, static_cast<int>(std::ceil(distance(a, b) / kSampleStep)));
    for (int k = 0; k <= steps; ++k) {
      const double t = static_cast<double>(k) / steps;
      const Vec3 p{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
      least = std::min(least, tern_host::distance_to_blocks(p, scenario));
    }
  }
  return least;
}

}  // namespace tern_bench
