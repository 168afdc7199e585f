// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "baselines/paper_map.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "baselines/route.hpp"

namespace tern_bench {
namespace {

using tern::Vec3;
using tern::Voxel;

/// A coordinate this close to a face, in voxels, lies on it.
constexpr double kOnFace = 1e-9;

int count(double low, double high, double cell) {
  return std::max(1, static_cast<int>(std::ceil((high - low) / cell)));
}

/// Counted from 1 before it is rounded down: many of the maps' faces lie on the lattice but for rounding, and this is
/// the rounding that the paper's figures come from.
int clamped(double offset, double cell, int cells) {
  return static_cast<int>(std::min(std::max(std::floor(offset / cell + 1.0), 1.0), 1.0 * cells)) - 1;
}

bool on_face(double coordinate, double cell) {
  const double voxels = coordinate / cell;
  return std::fabs(voxels - std::round(voxels)) < kOnFace;
}

}  // namespace

PaperMap::PaperMap(const tern_host::Scenario& scenario, double cell, double margin)
    : origin_(scenario.boundary.lower), cell_(cell) {
  if (!(cell > 0.0)) throw std::invalid_argument("a cell must be larger than 0");
  const Vec3& upper = scenario.boundary.upper;
  dims_ = {count(origin_.x, upper.x, cell), count(origin_.y, upper.y, cell), count(origin_.z, upper.z, cell)};
  obstacles_.assign(static_cast<std::size_t>(dims_.x) * static_cast<std::size_t>(dims_.y * dims_.z), false);
  for (const tern_host::Block& block : scenario.blocks) {
    const Vec3& lo = block.box.lower;
    const Vec3& hi = block.box.upper;
    const Voxel first = voxel_of({lo.x - margin, lo.y - margin, lo.z - margin});
    const Voxel last = voxel_of({hi.x + margin, hi.y + margin, hi.z + margin});
    for (int z = first.z; z <= last.z; ++z) {
      for (int y = first.y; y <= last.y; ++y) {
        for (int x = first.x; x <= last.x; ++x) obstacles_[index({x, y, z})] = true;
      }
    }
  }
}

bool PaperMap::inside(const Voxel& v) const {
  return v.x >= 0 && v.y >= 0 && v.z >= 0 && v.x < dims_.x && v.y < dims_.y && v.z < dims_.z;
}

std::size_t PaperMap::index(const Voxel& v) const {
  return static_cast<std::size_t>(v.x + dims_.x * (v.y + dims_.y * v.z));
}

Voxel PaperMap::voxel_of(const Vec3& p) const {
  return {clamped(p.x - origin_.x, cell_, dims_.x), clamped(p.y - origin_.y, cell_, dims_.y),
          clamped(p.z - origin_.z, cell_, dims_.z)};
}

Vec3 PaperMap::center(const Voxel& v) const {
  return {origin_.x + (v.x + 0.5) * cell_, origin_.y + (v.y + 0.5) * cell_, origin_.z + (v.z + 0.5) * cell_};
}

bool sampled_sight(const PaperMap& map, const Vec3& from, const Vec3& to) {
  const Vec3 d{to.x - from.x, to.y - from.y, to.z - from.z};
  const double far = std::max(std::hypot(d.x, d.y), std::fabs(d.z)) / map.cell();
  const int last = static_cast<int>(std::lround(far)) + 2;
  const double nudge = 0.01 * map.cell() / std::max(distance(from, to), 1e-12);
  for (int i = 0; i <= last; ++i) {
    double t = static_cast<double>(i) / last;
    const Vec3 p{from.x + t * d.x, from.y + t * d.y, from.z + t * d.z};
    const bool between = on_face(p.x, map.cell()) || on_face(p.y, map.cell()) || on_face(p.z, map.cell());
    if (between && i > 0 && i < last) t += nudge;
    if (map.obstacle(map.voxel_of({from.x + t * d.x, from.y + t * d.y, from.z + t * d.z}))) return false;
  }
  return true;
}

}  // namespace tern_bench
