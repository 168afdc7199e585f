// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// From a chain of segments to a quadratic programme and back (the paper's Sections 3.4.2 and 3.4.3).
//
// The unknowns of each axis are the states of the interior joints, 4 (count - 1) numbers. They are in normalised time
// (durations divided by their mean) and scaled so that the Hessian's diagonal is 1. So the conditioning depends neither
// on where the map is nor on how long the flight takes.
#ifndef TERN_TRAJECTORY_PROGRAMME_HPP
#define TERN_TRAJECTORY_PROGRAMME_HPP

#include "base/bounds.hpp"
#include "qp/qp.hpp"
#include "tern/corridor.hpp"
#include "tern/request.hpp"
#include "tern/trajectory.hpp"
#include "times/chain.hpp"
#include "trajectory/hodograph_points.hpp"

namespace tern {

/// What a point of a programme stands for: control point `index` of a segment (order 0), point `index` of
/// kHodographPoints (order 1 to 3), or a row of a separation (kSeparationOrder).
struct PointOrigin {
  std::int16_t segment;
  std::int8_t order;
  std::int8_t index;
};

constexpr std::int8_t kSeparationOrder = -1;

static_assert(kJerkPoints == kQpTurningInstants, "room for the rows of body rates");

/// With a limit on body rates, what the rows at an instant of a segment bound (trajectory/turning.hpp).
struct TurningRows {
  Vec3 thrust;   ///< unit vector along the thrust
  Vec3 turn;     ///< unit vector across the thrust, to where the jerk turns it
  double least;  ///< of the thrust's part along `thrust`, m/s^2
  double most;   ///< of the jerk's part along `turn`, either way, m/s^3
  double side;   ///< of the jerk's part across both, either way, m/s^3
};

/// The rows of all jerk points, and how the last solution would share each bound.
struct Turning {
  TurningRows rows[kMaxSegments][kJerkPoints];
  double share[kMaxSegments][kJerkPoints];  ///< above 1: more thrust, and more jerk across it
  double worth[kMaxSegments][kJerkPoints];  ///< what both bounds cost that solution
};

/// How to convert a programme's unknowns to states, its points to parts of segments, and its cost to snap.
struct ProgrammeScale {
  double tau;                               ///< mean duration, seconds
  double joint[kMaxSegments][kJointOrder];  ///< derivative k of joint i + 1, times tau^k, is joint[i][k] * unknown
  double unit[4];                           ///< unit of the points of each order: metres, m/s, m/s^2, m/s^3
  int turning;                              ///< the first plane of the limit on body rates
  double snap_per_cost;                     ///< integral of squared snap divided by the programme's objective
  PointOrigin origin[kQpMaxPoints];
};

/// Fills the programme: minimum snap over the chain, and its constraints. Constraints without unknowns, which follow
/// from the boundary states and the durations alone, are left out: whoever accepts a solution checks all control points
/// anyway. A constraint keeps its (point, plane) from one assembly of a chain to the next, whatever the durations. So a
/// working set can warm-start the next programme.
///
/// `turning` is read only with a limit on body rates.
void assemble(const Chain& chain, const Corridor& corridor, const MotionLimits& limits, const Turning* turning,
              QpProblem& problem, ProgrammeScale& scale) noexcept;

/// The control points of a solution. `points`: chain.count rows of kControlPoints, local frame. Segments have the same
/// bits at a common joint. The first and the last control point are the start and the goal, bit for bit.
void read_points(const Chain& chain, const ProgrammeScale& scale, const QpSolution& solution,
                 Vec3 (*points)[kControlPoints]) noexcept;

/// prices[i] = -T_i dJ/dT_i in m^2/s^7, where J is the least integral of squared snap that the constraints allow: by
/// how much J falls per relative growth of segment i's duration. By the envelope theorem this is the derivative of the
/// Lagrangian with the joints' states and the multipliers fixed, so it takes no further solve. An active constraint
/// that presses on a segment raises its price. A price is negative if a shorter segment would have less snap. `points`:
/// the solution's control points.
void time_prices(const Chain& chain, const QpProblem& problem, const QpSolution& solution, const ProgrammeScale& scale,
                 const Vec3 (*points)[kControlPoints], double* prices) noexcept;

}  // namespace tern

#endif
