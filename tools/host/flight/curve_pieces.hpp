// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Commands are curves of degree 7, piece by piece, whose position to jerk are continuous. From commands alone, this
// finds the pieces, and so what holds between two samples, too.
#ifndef TERN_HOST_FLIGHT_CURVE_PIECES_HPP
#define TERN_HOST_FLIGHT_CURVE_PIECES_HPP

#include <array>
#include <cstdint>
#include <functional>

#include "tern/request.hpp"
#include "tern/trajectory.hpp"

namespace tern_host {

/// The commanded motion at a time in nanoseconds.
using Commands = std::function<tern::Sample(std::int64_t)>;

struct TimedSample {
  std::int64_t t;
  tern::Sample sample;
};

/// Bernstein coefficients of one piece's derivatives: at every instant of the piece, they lie in the hull of these.
struct PieceHull {
  std::array<tern::Vec3, 7> velocity;
  std::array<tern::Vec3, 6> acceleration;
  std::array<tern::Vec3, 5> jerk;
};

/// The curve of degree 7 that has the acceleration, jerk and snap of the first and the last sample. False where it does
/// not lead from one to the other, or not through the one between them: then there is a joint.
bool single_piece(const TimedSample& first, const TimedSample& middle, const TimedSample& last, PieceHull& hull);

/// What the two sides of an instant may differ by: rounding. A plan's positions are sums of two numbers, and each of
/// its derivatives is a quotient of differences of those, so that not even the bits of equal states are equal: the
/// shortest segments last 0.01 s, which makes 1e-15 m in a control point 1e-6 m/s^3 of jerk. Metres and seconds; the
/// position's is for each metre of the coordinates, and one more.
struct JointRounding {
  double position, velocity, acceleration, jerk;
};
constexpr JointRounding kJointRounding{1e-13, 1e-11, 1e-8, 1e-5};

/// True where the motion from `a` to `b`, some nanoseconds later, is continuous from position to jerk.
bool is_continuous(const TimedSample& a, const TimedSample& b);

/// The limit that an instant between two samples breaks by more than a millionth, in words; null where none does.
const char* broken_limit(const tern::Limits& limits, const PieceHull& hull);
/// The same for one instant.
const char* broken_limit(const tern::Limits& limits, const tern::Sample& sample);

/// What is wrong with commands, and where.
struct CurveFault {
  const char* what = nullptr;  ///< null: nothing
  bool is_limit = false;       ///< a limit is broken; otherwise the motion jumps
  std::int64_t t = 0;
};

/// Looks at all instants of a plan, one stretch after the other: the motion is continuous and keeps the limits. Very
/// short pieces are slivers, which a plan has where it was cut next to a joint. Their jerk is rounding, so it is the
/// motion before and behind them that must be continuous.
class CurveCheck {
 public:
  CurveCheck(Commands commands, const tern::Limits& limits) : commands_(std::move(commands)), limits_(limits) {}

  void look(const TimedSample& a, const TimedSample& b);
  const CurveFault& fault() const { return fault_; }
  /// The largest snap that was met, m/s^4.
  double snap() const { return snap_; }
  /// Sides of slivers that were met.
  std::uint64_t slivers() const { return slivers_; }

 private:
  void look_at_joint(const TimedSample& a, const TimedSample& b);

  Commands commands_;
  const tern::Limits& limits_;
  CurveFault fault_;
  double snap_ = 0.0;
  std::uint64_t slivers_ = 0;
};

}  // namespace tern_host

#endif
