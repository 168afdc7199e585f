// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Things that move, in exact numbers: how much room a curve in time leaves them.
#ifndef TERN_VERIFY_TRACKS_HPP
#define TERN_VERIFY_TRACKS_HPP

#include <optional>
#include <string>
#include <vector>

#include "verify/bezier.hpp"
#include "verify/exact.hpp"

namespace tern_verify {

enum class ThingShape { kBall, kCylinder, kBox };
enum class ThingEnd { kGoesOn, kGone, kStays, kReach };

/// A piece of a curve in time: control points, and how long it lasts, in seconds.
struct TimedCurve {
  Polygon<3> points;
  Rational duration;
};

/// A thing that moves. World frame, metres, seconds.
struct Thing {
  std::string name;
  ThingShape shape = ThingShape::kBall;
  Rational radius = 0;     ///< of a ball or a cylinder
  Point half = {0, 0, 0};  ///< of a box; z of a cylinder
  Point position = {0, 0, 0};
  Point velocity = {0, 0, 0};
  std::vector<TimedCurve> pieces;  ///< in place of position and velocity
  Rational error = 0, error_speed = 0, error_growth = 0;
  Rational reach = 0;  ///< 0: none
  Rational from = 0;
  bool has_from = false;
  Rational until = 0;
  ThingEnd end = ThingEnd::kGoesOn;
};

/// A vehicle's curve, from `begin` on; it rests at its end for `rest` seconds.
struct TimedWay {
  std::vector<TimedCurve> curves;
  Rational begin;
  Rational rest;
  Rational clearance;
};

/// What is proven: the room is at least `least`, and no more than `most` at some time. Metres. `least` is three
/// quarters of `most` or more, or a micrometre less than that.
struct RoomInTime {
  Rational least, most;
  Rational when;        ///< s since the beginning of the way
  bool leaves = false;  ///< the way begins too near to the thing, and leads away from it
  bool noted = false;   ///< the thing is there at some time
};

/// Where a chain of curves is, as control points, from one time to another within one of them: at rest past its end.
Polygon<3> chain_part(const std::vector<TimedCurve>& chain, Rational begin, const Rational& from, const Rational& to);

/// Numbers in which the room is looked for. What intervals of doubles find is as true as what exact numbers do; where
/// they do not tell whether there is `enough`, exact ones are asked.
enum class Numbers { kIntervalsFirst, kExact };

/// The least room that the way leaves the thing. Looks no closer where the room is `enough`.
RoomInTime room_beside(const TimedWay& way, const Thing& thing, const Rational& enough,
                       Numbers numbers = Numbers::kIntervalsFirst);

/// Seconds as the planner has them: whole nanoseconds.
Rational whole_nanoseconds(const Rational& seconds);

}  // namespace tern_verify

#endif
