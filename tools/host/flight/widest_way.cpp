// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/widest_way.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

#include "host/flight/vectors.hpp"

namespace tern_host {
namespace {

using tern::Grid;
using tern::Vec3;
using tern::Voxel;

constexpr double kSlack = 1e-9;  // voxels

/// Voxels as numbers, in the grid's order.
class Numbers {
 public:
  explicit Numbers(const Voxel& dims) : dims_(dims) {}

  std::size_t count() const { return of({0, 0, dims_.z}); }
  std::size_t of(const Voxel& v) const {
    return static_cast<std::size_t>((std::int64_t{v.z} * dims_.y + v.y) * dims_.x + v.x);
  }
  Voxel voxel(std::size_t number) const {
    const auto n = static_cast<std::int64_t>(number);
    return {static_cast<std::int32_t>(n % dims_.x), static_cast<std::int32_t>(n / dims_.x % dims_.y),
            static_cast<std::int32_t>(n / dims_.x / dims_.y)};
  }

 private:
  Voxel dims_;
};

/// How far voxels are from the nearest solid one, as the square of the gap between their cubes, in voxels.
class Openings {
 public:
  explicit Openings(const Grid& grid) : grid_(grid) {
    const double radius = grid.spec().clearance() / grid.spec().cell - kSlack;
    enough_ = static_cast<int>(std::ceil(radius * radius));
    const int reach = static_cast<int>(std::ceil(radius)) + 1;
    for (int z = -reach; z <= reach; ++z) {
      for (int y = -reach; y <= reach; ++y) {
        for (int x = -reach; x <= reach; ++x) {
          const int room = square_of_gap(x) + square_of_gap(y) + square_of_gap(z);
          if (room < enough_) near_.push_back({room, {x, y, z}});
        }
      }
    }
    std::stable_sort(near_.begin(), near_.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  }

  /// What a plan needs.
  int enough() const { return enough_; }

  /// The room of a voxel, at most what a plan needs. What is beyond the grid counts as solid.
  int at(const Voxel& v) const {
    for (const auto& [room, off] : near_) {
      const Voxel other{v.x + off.x, v.y + off.y, v.z + off.z};
      if (!is_free(grid_, other)) return room;
    }
    return enough_;
  }

 private:
  static int square_of_gap(int off) {
    const int gap = std::max(0, std::abs(off) - 1);
    return gap * gap;
  }

  const Grid& grid_;
  int enough_;
  std::vector<std::pair<int, Voxel>> near_;  ///< rooms of voxels that are so far off, where that is too little
};

/// Floods the free voxels from a start, those first to which the widest ways lead.
class Flood {
 public:
  explicit Flood(const Grid& grid)
      : grid_(grid), numbers_(grid.spec().dims), openings_(grid), from_(numbers_.count(), kUnseen) {}

  WidestWay way(const Voxel& start, const Vec3& goal) {
    push(start, numbers_.of(start), openings_.enough());
    // As far as plans on both sides of a thin wall are apart: less may be a corner on this side of it.
    const double beyond = 2.0 * grid_.spec().clearance() + grid_.spec().cell;
    // The least distances from the goal: of what plans reach, and of all that is free.
    double reached = distance_between(grid_.center(start), goal);
    double least = reached;
    std::size_t nearest = numbers_.of(start);
    while (!open_.empty()) {
      const auto [width, room, order] = open_.top();
      open_.pop();
      const std::size_t at = kUnseen - order;
      const Voxel voxel = numbers_.voxel(at);
      const double far = distance_between(grid_.center(voxel), goal);
      const bool is_reached = width == openings_.enough();
      if (is_reached) reached = std::min(reached, far);
      if (!is_reached && far < reached - beyond && room == openings_.enough()) return way_to(at);
      if (far < least) nearest = at;
      least = std::min(least, far);
      push_neighbours(at, width);
    }
    if (least < reached - beyond) return way_to(nearest);
    return {};
  }

 private:
  static constexpr std::size_t kUnseen = std::numeric_limits<std::size_t>::max();

  /// Of equally wide ways, those come first that have more room now; of these, the voxel with the least number.
  void push(const Voxel& voxel, std::size_t from, int width) {
    const int room = openings_.at(voxel);
    from_[numbers_.of(voxel)] = from;
    open_.emplace(std::min(width, room), room, kUnseen - numbers_.of(voxel));
  }

  void push_neighbours(std::size_t at, int width) {
    const Voxel voxel = numbers_.voxel(at);
    for (int k = 0; k < 6; ++k) {
      const Voxel next = neighbour(voxel, k / 2, k % 2 == 0 ? 1 : -1);
      if (is_free(grid_, next) && from_[numbers_.of(next)] == kUnseen) push(next, at, width);
    }
  }

  WidestWay way_to(std::size_t at) const {
    WidestWay way;
    way.voxels = {numbers_.voxel(at)};
    for (; from_[at] != at; at = from_[at]) way.voxels.push_back(numbers_.voxel(from_[at]));
    std::reverse(way.voxels.begin(), way.voxels.end());
    for (const Voxel& voxel : way.voxels) way.gaps.push_back(grid_.spec().cell * std::sqrt(openings_.at(voxel)));
    const double least = *std::min_element(way.gaps.begin(), way.gaps.end());
    std::vector<std::size_t> narrow;
    for (std::size_t k = 0; k < way.gaps.size(); ++k) {
      if (way.gaps[k] <= least) narrow.push_back(k);
    }
    way.narrowest = narrow[narrow.size() / 2];
    return way;
  }

  const Grid& grid_;
  Numbers numbers_;
  Openings openings_;
  std::vector<std::size_t> from_;  ///< the voxel before
  std::priority_queue<std::tuple<int, int, std::size_t>> open_;
};

}  // namespace

bool is_free(const Grid& grid, const Voxel& voxel) {
  return grid.inside(voxel) && !grid.obstacle(voxel);
}

Voxel neighbour(const Voxel& voxel, int axis, int sign) {
  return {voxel.x + (axis == 0 ? sign : 0), voxel.y + (axis == 1 ? sign : 0), voxel.z + (axis == 2 ? sign : 0)};
}

WidestWay widest_way(const Grid& grid, const Vec3& start, const Vec3& goal) {
  const Voxel voxel = grid.voxel_of(start);
  if (!is_free(grid, voxel)) return {};
  return Flood(grid).way(voxel, goal);
}

}  // namespace tern_host
