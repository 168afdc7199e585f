// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/picture/oblique_camera.hpp"

#include <algorithm>
#include <limits>

namespace tern_host {
namespace {

using tern::Box;
using tern::Vec3;

// Pixels of scale 1: a metre away goes so far to the right and up, a metre of height so far up.
constexpr double kAwayRight = 0.30;
constexpr double kAwayUp = 0.74;
constexpr double kHeightUp = 0.72;
// All points of such a line fall on one pixel.
constexpr double kTowardsViewer[3] = {kAwayRight, -1.0, kAwayUp / kHeightUp};
constexpr double kNear = 1e-9;  // m

double part(const Vec3& v, int axis) {
  return axis == 0 ? v.x : (axis == 1 ? v.y : v.z);
}

/// The pixel at scale 1, without an offset.
Pixel flat(const Vec3& p) {
  return {p.x + kAwayRight * p.y, -(kAwayUp * p.y + kHeightUp * p.z)};
}

Rect bounds(const Box& box) {
  double low_x = std::numeric_limits<double>::infinity();
  double low_y = low_x;
  double high_x = -low_x;
  double high_y = -low_x;
  for (int corner = 0; corner < 8; ++corner) {
    const Pixel p = flat({(corner & 1) != 0 ? box.upper.x : box.lower.x, (corner & 2) != 0 ? box.upper.y : box.lower.y,
                          (corner & 4) != 0 ? box.upper.z : box.lower.z});
    low_x = std::min(low_x, p.x);
    high_x = std::max(high_x, p.x);
    low_y = std::min(low_y, p.y);
    high_y = std::max(high_y, p.y);
  }
  return {low_x, low_y, high_x - low_x, high_y - low_y};
}

/// A plane between the boxes has `a` on the side away from the viewer.
bool behind(const Box& a, const Box& b) {
  return a.lower.y >= b.upper.y - kNear || a.upper.x <= b.lower.x + kNear || a.upper.z <= b.lower.z + kNear;
}

double nearness(const Box& box) {
  double sum = 0.0;
  for (int a = 0; a < 3; ++a) sum += kTowardsViewer[a] * (part(box.lower, a) + part(box.upper, a));
  return sum;
}

/// For each box the boxes that it must be drawn before, and how many must be drawn before it.
struct Order {
  std::vector<std::vector<std::size_t>> after;
  std::vector<int> before;

  explicit Order(const std::vector<Box>& boxes) : after(boxes.size()), before(boxes.size(), 0) {
    std::vector<Rect> rooms;
    for (const Box& box : boxes) rooms.push_back(bounds(box));
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        if (rooms[i].overlaps(rooms[k])) add(boxes, i, k);
      }
    }
  }
  void add(const std::vector<Box>& boxes, std::size_t i, std::size_t k) {
    const bool first = behind(boxes[i], boxes[k]);
    const bool second = behind(boxes[k], boxes[i]);
    if (first && second) return;  // neither hides the other
    const bool i_first = first || (!second && nearness(boxes[i]) < nearness(boxes[k]));
    after[i_first ? i : k].push_back(i_first ? k : i);
    ++before[i_first ? k : i];
  }
};

}  // namespace

ObliqueCamera::ObliqueCamera(const Box& boundary)
    : boundary_(boundary),
      y_across_(boundary.upper.y - boundary.lower.y > 1.05 * (boundary.upper.x - boundary.lower.x)) {}

void ObliqueCamera::fit(const Rect& frame) {
  const Rect room = bounds(turned(boundary_));
  scale_ = std::min(frame.width / room.width, frame.height / room.height);
  offset_ = {frame.x + 0.5 * (frame.width - scale_ * room.width) - scale_ * room.x, frame.y - scale_ * room.y};
  bottom_ = frame.y + scale_ * room.height;
}

Vec3 ObliqueCamera::turned(const Vec3& p) const {
  return y_across_ ? Vec3{p.y, -p.x, p.z} : p;
}

Box ObliqueCamera::turned(const Box& box) const {
  if (!y_across_) return box;
  return {{box.lower.y, -box.upper.x, box.lower.z}, {box.upper.y, -box.lower.x, box.upper.z}};
}

Pixel ObliqueCamera::project_turned(const Vec3& point) const {
  const Pixel p = flat(point);
  return {offset_.x + scale_ * p.x, offset_.y + scale_ * p.y};
}

Pixel ObliqueCamera::project(const Vec3& world) const {
  return project_turned(turned(world));
}

bool ObliqueCamera::hides(const Box& box, const Vec3& point) {
  double from = 0.0;
  double to = std::numeric_limits<double>::infinity();
  for (int a = 0; a < 3; ++a) {
    const double low = (part(box.lower, a) - part(point, a)) / kTowardsViewer[a];
    const double high = (part(box.upper, a) - part(point, a)) / kTowardsViewer[a];
    from = std::max(from, std::min(low, high));
    to = std::min(to, std::max(low, high));
  }
  return to - from > kNear;
}

std::vector<std::size_t> back_to_front(const std::vector<Box>& boxes) {
  Order order(boxes);
  std::vector<bool> drawn(boxes.size(), false);
  std::vector<std::size_t> sequence;
  while (sequence.size() < boxes.size()) {
    // Of those with nothing left behind them, and in a ring of boxes of all, the farthest.
    std::size_t best = boxes.size();
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (drawn[i]) continue;
      const bool better = best == boxes.size() || order.before[i] < order.before[best] ||
                          (order.before[i] == order.before[best] && nearness(boxes[i]) < nearness(boxes[best]));
      if (better) best = i;
    }
    drawn[best] = true;
    sequence.push_back(best);
    for (const std::size_t next : order.after[best]) --order.before[next];
  }
  return sequence;
}

}  // namespace tern_host
