// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/ray_length.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tern_host {
namespace {

using tern::Vec3;

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kParallel = 1e-12;

/// The part of a ray that lies in a thing; empty where enter > leave.
struct Inside {
  double enter = 0.0;
  double leave = kNever;

  /// Keeps what lies between two planes at right angles to one axis.
  void cut(double from, double along, double lower, double upper) {
    if (std::abs(along) < kParallel) {
      if (from < lower || from > upper) enter = kNever;
      return;
    }
    const double a = (lower - from) / along;
    const double b = (upper - from) / along;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  double length() const { return enter <= leave ? enter : kNever; }
};

Inside inside(const tern::Box& box, const Vec3& eye, const Vec3& along) {
  Inside part;
  part.cut(eye.x, along.x, box.lower.x, box.upper.x);
  part.cut(eye.y, along.y, box.lower.y, box.upper.y);
  part.cut(eye.z, along.z, box.lower.z, box.upper.z);
  return part;
}

Inside inside(const Cylinder& cylinder, const Vec3& eye, const Vec3& along) {
  const double x = eye.x - cylinder.x;
  const double y = eye.y - cylinder.y;
  const double a = along.x * along.x + along.y * along.y;
  const double b = x * along.x + y * along.y;
  const double c = x * x + y * y - cylinder.radius * cylinder.radius;
  Inside part;
  part.cut(eye.z, along.z, cylinder.bottom, cylinder.top);
  if (a < kParallel) return c <= 0.0 ? part : Inside{kNever, 0.0};
  const double root = b * b - a * c;
  if (root < 0.0) return {kNever, 0.0};
  part.enter = std::max(part.enter, (-b - std::sqrt(root)) / a);
  part.leave = std::min(part.leave, (-b + std::sqrt(root)) / a);
  return part;
}

}  // namespace

double ray_length(const FlightWorld& world, const Vec3& eye, const Vec3& along) {
  double least = std::max(0.0, inside(world.boundary, eye, along).leave);
  for (const tern::Box& block : world.blocks) least = std::min(least, inside(block, eye, along).length());
  for (const Cylinder& c : world.cylinders) least = std::min(least, inside(c, eye, along).length());
  return least;
}

}  // namespace tern_host
