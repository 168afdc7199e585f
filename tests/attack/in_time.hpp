// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the checkers of things that move and of fences for a while share: where a plan is, how fast it is, and a search
// for a time at which something is too small.
#ifndef TERN_TESTS_ATTACK_IN_TIME_HPP
#define TERN_TESTS_ATTACK_IN_TIME_HPP

#include <algorithm>
#include <cmath>
#include <vector>

#include "attack/exact.hpp"

namespace tern_attack {

inline Point bezier(const tern::Vec3* points, Real u) {
  constexpr Real kBinomial[] = {1, 7, 21, 35, 35, 21, 7, 1};
  Point sum = point({0.0, 0.0, 0.0});
  for (int i = 0; i < tern::kControlPoints; ++i) {
    const Real weight = kBinomial[i] * std::pow(u, static_cast<Real>(i)) * std::pow(1 - u, static_cast<Real>(7 - i));
    for (int a = 0; a < 3; ++a) sum[a] += weight * axis(points[i], a);
  }
  return sum;
}

/// The most that control points allow, m/s.
inline Real fastest(const tern::Vec3* points, Real duration) {
  Real most = 0;
  for (int i = 0; i < tern::kDegree; ++i) {
    const Point step = point(points[i + 1]) - point(points[i]);
    most = std::max(most, std::sqrt(dot(step, step)));
  }
  return tern::kDegree * most / duration;
}

inline Real fastest(const tern::Trajectory& plan) {
  Real most = 0;
  for (int s = 0; s < plan.count; ++s) {
    most = std::max(most, fastest(plan.segments[s].points, plan.segments[s].duration));
  }
  return most;
}

/// On a chain of curves, past its end at rest there.
template <class PieceAt>
Point on_chain(int count, const PieceAt& piece_at, Real t) {
  for (int i = 0; i < count; ++i) {
    const auto& piece = piece_at(i);
    if (t < piece.duration) return bezier(piece.points, std::max<Real>(0, t / piece.duration));
    t -= piece.duration;
  }
  return point(piece_at(count - 1).points[tern::kDegree]);
}

/// In the plan's frame, `t` seconds after its beginning.
inline Point place_at(const tern::Trajectory& plan, Real t) {
  const auto segment_at = [&](int i) -> const tern::Segment& { return plan.segments[i]; };
  return on_chain(plan.count, segment_at, t);
}

struct Interval {
  Real begin, end;
};

/// False if `room_at` is below `least` at some time of the interval, which `when` gets. Pieces are halved, but not
/// those of which `is_sure(piece, half its length, room in its middle)` says that no time of them can be such a one.
template <class RoomAt, class IsSure>
bool stays_above(Real least, const Interval& whole, const RoomAt& room_at, const IsSure& is_sure, Real& when) {
  constexpr int kMostPieces = 20000;
  constexpr Real kShortest = 1e-7L;
  std::vector<Interval> open{whole};
  for (int pieces = 0; !open.empty() && pieces < kMostPieces; ++pieces) {
    const Interval piece = open.back();
    open.pop_back();
    const Real half = (piece.end - piece.begin) / 2;
    const Real middle = (piece.begin + piece.end) / 2;
    const Real room = room_at(middle);
    when = middle;
    if (room < least) return false;
    if (half < kShortest || is_sure(piece, half, room)) continue;
    open.push_back({middle, piece.end});
    open.push_back({piece.begin, middle});
  }
  return true;
}

}  // namespace tern_attack

#endif
