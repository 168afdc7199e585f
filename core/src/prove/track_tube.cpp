// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "prove/track_tube.hpp"

#include "base/math.hpp"
#include "prove/grants.hpp"

namespace tern {
namespace {

constexpr int kNumbers = 4;

Vec3 place_of(const double* point) {
  return {point[0], point[1], point[2]};
}

/// de Casteljau: `points` become the part before u, `after` the part behind it.
void cut_tube(double (*points)[kNumbers], double u, double (*after)[kNumbers]) {
  const double rest = 1.0 - u;
  for (int level = 0; level <= kDegree; ++level) {
    for (int n = 0; n < kNumbers; ++n) after[kDegree - level][n] = points[kDegree][n];
    for (int i = kDegree; i > level; --i) {
      for (int n = 0; n < kNumbers; ++n) points[i][n] = rest * points[i - 1][n] + u * points[i][n];
    }
  }
}

double most_of(const double (*tube)[kNumbers], int number) {
  double most = tube[0][number];
  for (int i = 1; i < kControlPoints; ++i) most = larger(most, tube[i][number]);
  return most;
}

double least_of(const double (*tube)[kNumbers], int number) {
  double least = tube[0][number];
  for (int i = 1; i < kControlPoints; ++i) least = smaller(least, tube[i][number]);
  return least;
}

}  // namespace

double rounding_of_size(double size) noexcept {
  constexpr double kUlps = 160.0;
  return kUlps * kUlp * size;
}

double make_tube(const Vec3* points, const ThingMotion& motion, double distance, double (*tube)[4]) noexcept {
  double size = 0.0;
  for (int i = 0; i < kControlPoints; ++i) {
    const Vec3 apart = points[i] - motion.points[i];
    const double needed = motion.error[i] + distance;
    tube[i][0] = apart.x;
    tube[i][1] = apart.y;
    tube[i][2] = apart.z;
    tube[i][3] = needed;
    const double of_point = (absolute(points[i].x) + absolute(points[i].y)) + absolute(points[i].z);
    size = larger(size, of_point + absolute(needed));
  }
  return rounding_of_size(size + motion.size);
}

void hold(const Vec3& place, double error, double growth, ThingMotion& motion) noexcept {
  for (int i = 0; i < kControlPoints; ++i) {
    motion.points[i] = place;
    motion.error[i] = error + (i / 7.0) * growth;
  }
  motion.size = larger(motion.size, (absolute(place.x) + absolute(place.y)) + absolute(place.z));
}

void widen(const double (*from)[4], double width, double growth, double (*tube)[4]) noexcept {
  for (int i = 0; i < kControlPoints; ++i) {
    for (int n = 0; n < 3; ++n) tube[i][n] = from[i][n];
    tube[i][3] = width + (i / 7.0) * growth;
  }
}

void take_dyadic_part(const double (*tube)[4], std::int32_t number, std::int32_t depth, double (*part)[4]) noexcept {
  for (int i = 0; i < kControlPoints; ++i) {
    for (int n = 0; n < kNumbers; ++n) part[i][n] = tube[i][n];
  }
  if (depth == 0) return;
  const auto pieces = static_cast<double>(std::int32_t{1} << depth);
  const double begin = number / pieces;
  const double end = (number + 1) / pieces;
  double rest[kControlPoints][kNumbers];
  if (end < 1.0) cut_tube(part, end, rest);
  if (number == 0) return;
  cut_tube(part, begin / end, rest);
  for (int i = 0; i < kControlPoints; ++i) {
    for (int n = 0; n < kNumbers; ++n) part[i][n] = rest[i][n];
  }
}

bool plane_keeps_off(const Track& track, const double (*tube)[4], double slack) noexcept {
  const Vec3 middle = 0.5 * (place_of(tube[3]) + place_of(tube[4]));
  const Vec3 apart = middle - nearest_of(track, middle);
  const double distance = length(apart);
  if (!(distance > 0.0)) return false;
  const Vec3 normal = (1.0 / distance) * apart;
  const double wanted = reach_along(track, normal) + slack;
  for (int i = 0; i < kControlPoints; ++i) {
    if (!(dot(normal, place_of(tube[i])) >= wanted + tube[i][3])) return false;
  }
  return true;
}

bool axis_keeps_off(const Track& track, const double (*tube)[4], double slack) noexcept {
  const double distance = most_of(tube, 3) + slack;
  for (int a = 0; a < 3; ++a) {
    Vec3 normal = kZero;
    axis(normal, a) = 1.0;
    const double wanted = reach_along(track, normal) + distance;
    if (least_of(tube, a) >= wanted || -most_of(tube, a) >= wanted) return true;
  }
  return false;
}

double gap_of(const Track& track, const double* point) noexcept {
  const Vec3 place = place_of(point);
  return distance(place, nearest_of(track, place));
}

bool touches(const Track& track, const double* point) noexcept {
  return gap_of(track, point) < point[3];
}

bool are_apart(const Track& track, const ThingMotion& motion, double reach, const Box& box) noexcept {
  const double extent = distance(box.lower, kZero) + distance(box.upper, kZero);
  const double slack = rounding_of_size(((motion.size + reach) + shape_size(track)) + extent);
  for (int a = 0; a < 3; ++a) {
    Vec3 normal = kZero;
    axis(normal, a) = 1.0;
    const double wanted = (reach_along(track, normal) + reach) + slack;
    const double first = axis(motion.points[0], a);
    const double last = axis(motion.points[kDegree], a);
    const bool is_before = axis(box.lower, a) - larger(first, last) >= wanted;
    if (is_before || smaller(first, last) - axis(box.upper, a) >= wanted) return true;
  }
  return false;
}

}  // namespace tern
