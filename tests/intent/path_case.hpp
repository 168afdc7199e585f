// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Ways to make intents of: straight ones, and random ones.
#ifndef TERN_TESTS_INTENT_PATH_CASE_HPP
#define TERN_TESTS_INTENT_PATH_CASE_HPP

#include <cmath>

#include "host/intent/timed_path.hpp"
#include "support/random.hpp"

namespace tern_test {

using tern_host::PathPiece;
using tern_host::TimedPath;

inline tern::Vec3 mix(const tern::Vec3& a, const tern::Vec3& b, double u) {
  return {a.x + u * (b.x - a.x), a.y + u * (b.y - a.y), a.z + u * (b.z - a.z)};
}

/// From a to b, as fast at all times.
inline PathPiece straight(double begin, double end, const tern::Vec3& a, const tern::Vec3& b) {
  PathPiece piece{begin, end, {}};
  for (std::size_t i = 0; i < piece.points.size(); ++i) piece.points[i] = mix(a, b, static_cast<double>(i) / 7.0);
  return piece;
}

/// Where the way is, by Bernstein's polynomials.
inline tern::Vec3 position(const PathPiece& piece, double t) {
  const long double u =
      (static_cast<long double>(t) - piece.begin) / (static_cast<long double>(piece.end) - piece.begin);
  const long double counts[8] = {1, 7, 21, 35, 35, 21, 7, 1};
  long double x = 0, y = 0, z = 0;
  for (int i = 0; i < 8; ++i) {
    const long double w = counts[i] * std::pow(u, i) * std::pow(1.0L - u, 7 - i);
    x += w * piece.points[static_cast<std::size_t>(i)].x;
    y += w * piece.points[static_cast<std::size_t>(i)].y;
    z += w * piece.points[static_cast<std::size_t>(i)].z;
  }
  return {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
}

/// Some segments of up to 30 s and 150 m, some of them rests or climbs, up to 10 km from the origin.
inline TimedPath random_path(Random& random) {
  TimedPath path{"random", {}, random.real(0.1, 5.0), {}};
  const double far = random.chance(0.5) ? 500.0 : 7000.0;
  tern::Vec3 at{random.real(-far, far), random.real(-far, far), random.real(0.0, 100.0)};
  double begin = random.real(-5.0, 50.0);
  const int count = random.integer(1, 6);
  for (int s = 0; s < count; ++s) {
    const double end = begin + random.real(0.5, 30.0);
    PathPiece piece = straight(begin, end, at, at);
    const bool climbs = random.chance(0.2), rests = random.chance(0.2);
    const double reach = random.real(0.0, 75.0);
    for (std::size_t i = 1; i < piece.points.size() && !rests; ++i) {
      tern::Vec3& p = piece.points[i];
      p = {p.x + (climbs ? 0.0 : random.real(-reach, reach)), p.y + (climbs ? 0.0 : random.real(-reach, reach)),
           p.z + random.real(-20.0, 20.0)};
    }
    at = piece.points.back();
    begin = end;
    path.pieces.push_back(piece);
  }
  return path;
}

}  // namespace tern_test

#endif
