// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The edges of polyhedra, for displays.
#ifndef TERN_ROS_EDGES_HPP
#define TERN_ROS_EDGES_HPP

#include <algorithm>
#include <cstddef>
#include <vector>

#include "tern/halfspace.hpp"
#include "tern_onboard/pose.hpp"

namespace tern_ros {

inline double dot(const tern::Vec3& a, const tern::Vec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

inline tern::Vec3 cross(const tern::Vec3& a, const tern::Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// The part of the line `from` + t * `along` inside all planes but two: false if there is none.
inline bool clip(const std::vector<tern::Halfspace>& planes, std::size_t i, std::size_t j, const tern::Vec3& from,
                 const tern::Vec3& along, double& first, double& last) {
  for (std::size_t k = 0; k < planes.size(); ++k) {
    if (k == i || k == j) continue;
    const double room = planes[k].offset - dot(planes[k].normal, from);
    const double speed = dot(planes[k].normal, along);
    if (speed > 1e-12) {
      last = std::min(last, room / speed);
    } else if (speed < -1e-12) {
      first = std::max(first, room / speed);
    } else if (room < 0.0) {
      return false;
    }
  }
  return first < last;
}

/// Appends the edges of a polyhedron, two points each: of each line in which two planes meet, the part that is inside
/// all others.
inline void add_edges(const std::vector<tern::Halfspace>& planes, std::vector<tern::Vec3>& lines) {
  using tern_onboard::plus;
  using tern_onboard::times;
  constexpr double kLongest = 1e4;  // m: what is longer has no end
  for (std::size_t i = 0; i < planes.size(); ++i) {
    for (std::size_t j = i + 1; j < planes.size(); ++j) {
      const tern::Vec3 along = cross(planes[i].normal, planes[j].normal);
      const double square = dot(along, along);
      if (square < 1e-12) continue;  // parallel
      const tern::Vec3 from = times(plus(times(cross(planes[j].normal, along), planes[i].offset),
                                         times(cross(along, planes[i].normal), planes[j].offset)),
                                    1.0 / square);
      double first = -kLongest, last = kLongest;
      if (!clip(planes, i, j, from, along, first, last)) continue;
      lines.push_back(plus(from, times(along, first)));
      lines.push_back(plus(from, times(along, last)));
    }
  }
}

}  // namespace tern_ros

#endif
