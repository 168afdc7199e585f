// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/common_point.hpp"

#include "base/math.hpp"

namespace tern {
namespace {

/// Planes further away than this, in metres, are moved to this distance. Products of larger coordinates would overflow.
constexpr double kBeyondAnyMap = 1e100;
/// A line initially extends this far to both sides, in lengths of its direction vector: further than any half-space
/// lies.
constexpr double kEndless = 1e250;
/// Rounding error of a sum of products, relative to their sizes: 2^-48 in doubles, 2^-75 in twice their precision.
/// Products are accurate to 2^-52 and 2^-102. The smaller the angle between two planes, the less accurate are the
/// points of their line.
constexpr double kQuickRounding = 1.0 / 281474976710656.0;
constexpr double kRounding = 1.0 / 37778931862957161709568.0;

Triple<DoubleDouble> exact(const Vec3& v) {
  return {DoubleDouble(v.x), DoubleDouble(v.y), DoubleDouble(v.z)};
}

Vec3 rounded(const Triple<DoubleDouble>& a) {
  return {a.x.high, a.y.high, a.z.high};
}

}  // namespace

CommonPoint::CommonPoint(const Vec3& center, double margin, double scale) noexcept
    : center_(center), margin_(margin), scale_(scale), nearest_(exact(kZero)) {}

bool CommonPoint::breaks(const Wall& wall, const Place& p) noexcept {
  const double size = wall.norm * length(rounded(p)) + absolute(wall.offset.high);
  const double quick = dot(wall.normal, rounded(p)) - wall.offset.high;
  if (absolute(quick) > kQuickRounding * size) return quick > 0.0;
  return (dot(exact(wall.normal), p) - wall.offset).high > kRounding * size;
}

/// Cuts the line to its part in the half-space. False if no part of it lies there.
bool CommonPoint::shorten(const Wall& wall, Line& line) noexcept {
  const Place normal = exact(wall.normal);
  const DoubleDouble slope = dot(normal, line.along);
  if (absolute(slope.high) <= kRounding * wall.norm * length(rounded(line.along))) return !breaks(wall, line.from);
  const DoubleDouble end = (wall.offset - dot(normal, line.from)) / slope;
  if (slope.high > 0.0) {
    if (end < line.upper) line.upper = end;
  } else {
    if (line.lower < end) line.lower = end;
  }
  return !(line.upper < line.lower);
}

/// Sets nearest_ to the point nearest to the centre on the line in which two planes meet, within all half-spaces before
/// `other`. False if there is none.
bool CommonPoint::move_onto(int plane, int other) noexcept {
  const Place a = exact(walls_[plane].normal);
  const Place b = exact(walls_[other].normal);
  const Place along = cross(a, b);
  const DoubleDouble square = dot(along, along);
  if (!(square.high > 0.0)) return false;
  const Place from =
      (walls_[plane].offset / square) * cross(b, along) + (walls_[other].offset / square) * cross(along, a);
  Line line{from, along, DoubleDouble(-kEndless), DoubleDouble(kEndless)};
  for (int k = 0; k < other; ++k) {
    if (!shorten(walls_[k], line)) return false;
  }
  DoubleDouble at(0.0);
  if (at < line.lower) at = line.lower;
  if (line.upper < at) at = line.upper;
  nearest_ = line.from + at * line.along;
  return true;
}

/// Sets nearest_ to the point nearest to the centre on a plane, within all half-spaces before that plane. False if
/// there is none.
bool CommonPoint::move_onto(int plane) noexcept {
  const Place normal = exact(walls_[plane].normal);
  nearest_ = (walls_[plane].offset / dot(normal, normal)) * normal;
  for (int k = 0; k < plane; ++k) {
    if (breaks(walls_[k], nearest_) && !move_onto(plane, k)) return false;
  }
  return true;
}

bool CommonPoint::add(const Halfspace& plane) noexcept {
  const double norm = length(plane.normal);
  const double offset = clamp(plane.offset, -kBeyondAnyMap * norm, kBeyondAnyMap * norm);
  Wall& wall = walls_[count_++];
  wall = {plane.normal, norm, depth_of(DoubleDouble(offset), plane.normal, center_) + exact_product(margin_, norm)};
  return !breaks(wall, nearest_) || move_onto(count_ - 1);
}

Vec3 CommonPoint::nearest() const noexcept {
  return center_ + rounded(nearest_);
}

bool CommonPoint::within_reach() const noexcept {
  double farthest = scale_;
  for (int k = 0; k < count_; ++k) farthest = larger(farthest, absolute(walls_[k].offset.high) / walls_[k].norm);
  return length(rounded(nearest_)) <= kFarthest * farthest;
}

}  // namespace tern
