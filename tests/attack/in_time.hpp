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

#include "attack/curve.hpp"

namespace tern_attack {

/// Curves one after another; past its end the chain rests there. Times are seconds since its beginning.
template <class Piece>
struct Chain {
  const Piece* pieces;
  int count;

  Point place(Real t) const {
    const int i = reach(t);
    return i < count ? value(curve_of(pieces[i].points), std::max<Real>(0, t / pieces[i].duration))
                     : point(pieces[count - 1].points[tern::kDegree]);
  }

  Point velocity(Real t) const {
    const int i = reach(t);
    if (i == count) return Point{};
    return value(derivative(curve_of(pieces[i].points), pieces[i].duration), std::max<Real>(0, t / pieces[i].duration));
  }

  /// The most that control points allow between two times of the first derivative, or of the second.
  Real most(int order, Real from, Real to) const {
    Real most = 0;
    for (int i = 0; i < count && to >= 0; ++i) {
      const Real lasts = pieces[i].duration;
      if (from <= lasts) {
        const Curve first = derivative(curve_of(pieces[i].points), lasts);
        const Curve whole = order == 1 ? first : derivative(first, lasts);
        most = std::max(most, longest(between(whole, std::max<Real>(0, from / lasts), std::min<Real>(1, to / lasts))));
      }
      from -= lasts;
      to -= lasts;
    }
    return most;
  }

  bool lasts_until(Real t) const { return reach(t) < count; }

 private:
  /// The piece at `t`, which gets the seconds since it began.
  int reach(Real& t) const {
    int i = 0;
    for (; i < count && t >= pieces[i].duration; ++i) t -= pieces[i].duration;
    return i;
  }
};

inline Chain<tern::Segment> chain_of(const tern::Trajectory& plan) {
  return {plan.segments, plan.count};
}

struct Interval {
  Real begin, end;
};

/// Broken if `room_at` is below `least` at some time of the interval, which `when` gets. Pieces are halved, but not
/// those of which `is_sure(piece, room in its middle)` says that no time of them can be such a one, and not below 0.2
/// microseconds. Unproven if too many pieces are left; `when` is among them.
template <class RoomAt, class IsSure>
Proof stays_above(Real least, const Interval& whole, const RoomAt& room_at, const IsSure& is_sure, Real& when) {
  constexpr int kMostPieces = 2000000;
  constexpr Real kShortest = 2e-7L;
  std::vector<Interval> open{whole};
  for (int pieces = 0; !open.empty(); ++pieces) {
    const Interval piece = open.back();
    open.pop_back();
    const Real middle = (piece.begin + piece.end) / 2;
    const Real room = room_at(middle);
    when = middle;
    if (room < least) return Proof::kBroken;
    if (pieces >= kMostPieces) return Proof::kUnproven;
    if (piece.end - piece.begin < kShortest || is_sure(piece, room)) continue;
    open.push_back({middle, piece.end});
    open.push_back({piece.begin, middle});
  }
  return Proof::kProven;
}

}  // namespace tern_attack

#endif
