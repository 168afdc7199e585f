// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where the nose points during a flight: a yaw plan beside a trajectory, within limits on its rate and acceleration for
// all times. docs/yaw.md explains the method.
#ifndef TERN_YAW_HPP
#define TERN_YAW_HPP

#include <stdint.h>

#include "tern/config.hpp"
#include "tern/flatness.hpp"
#include "tern/status.hpp"
#include "tern/trajectory.hpp"
#include "tern/vec3.hpp"
#include "tern/work.hpp"

namespace tern {

/// What the nose should point at.
enum class YawMode : uint8_t {
  kFixed = 0,     ///< YawRequest::heading
  kAlongMotion,   ///< the horizontal velocity
  kTowardsPoint,  ///< YawRequest::point, seen from above
  kTimed,         ///< YawRequest::timed, and between two of them the shorter turn at a constant rate
};

/// A direction seen from above, by cosine and sine of its angle, counter-clockwise from x of the world. Their common
/// scale does not matter; they must not both be zero.
struct Heading {
  double cosine;
  double sine;
};

/// A heading to have at a time.
struct TimedHeading {
  /// Seconds after the trajectory's beginning, >= 0.
  double time;
  Heading heading;
};

/// What to plan. Fill it in after yaw_request().
struct YawRequest {
  YawMode mode;
  /// Limit on |rate|, rad/s, 0.01 .. 100.
  double rate_max;
  /// Limit on |acceleration|, rad/s^2, 0.01 .. 1000.
  double acceleration_max;
  /// Heading, rate and acceleration of the vehicle at the trajectory's beginning. A rate beyond the limit falls to it
  /// as fast as the acceleration allows.
  Heading start;
  double start_rate;          ///< rad/s, -100 .. 100
  double start_acceleration;  ///< rad/s^2, at most acceleration_max
  /// For kFixed.
  Heading heading;
  /// For kTowardsPoint: world frame, m. Its height does not matter.
  Vec3 point;
  /// For kTimed: headings with rising times. The caller owns them, and keeps them until the plan is finished.
  const TimedHeading* timed;
  int32_t timed_count;  ///< 1 at least for kTimed
  /// For kAlongMotion: below this horizontal speed, the motion has no direction, and the last one counts. m/s, > 0.
  double least_speed;
  /// For kTowardsPoint: nearer than this, the point has no direction, and the last one counts. m, > 0.
  double least_distance;
};

/// A request with the nose along the motion, from rest at that heading. Least speed 0.3 m/s, least distance 0.5 m.
YawRequest yaw_request(const Heading& start, double rate_max, double acceleration_max) noexcept;

/// The heading at one time, with its first two derivatives.
struct YawSample {
  Yaw yaw;              ///< cosine, sine and rate, for flat_state()
  double acceleration;  ///< rad/s^2
  /// rad, counter-clockwise from x of the world; it does not jump at half turns. Between -pi and pi at the beginning.
  double angle;
};

/// A yaw plan: the angle as a function of time with two continuous derivatives. First a polynomial of degree 3, in
/// which the start's acceleration comes to 0, then a uniform cubic B-spline. Plain data without pointers; the caller
/// owns it.
struct YawPlan {
  /// Pieces of the spline, 0 in an empty plan.
  int32_t count;
  /// Duration of the first polynomial in seconds, >= 0, and its coefficients: rad, rad/s, rad/s^2, rad/s^3, by rising
  /// powers of t.
  double lead;
  double polynomial[4];
  /// Duration of a piece of the spline, s.
  double step;
  /// Control points of the spline, rad: count + 3 of them. Points i to i + 3 shape piece i.
  double points[kMaxYawPieces + 3];
};

/// Duration in seconds: the trajectory's, and the time of half a turn. The nose may rest earlier. 0 for an empty plan.
double duration(const YawPlan& plan) noexcept;

/// The heading `t` seconds after the beginning. Every input has an answer: the beginning for NaN and before it, rest
/// after the end, and heading 0 for an empty plan. Takes constant time.
YawSample evaluate(const YawPlan& plan, double t) noexcept;

/// Iterations of a yaw plan's optimisation, at most. Of 3,000 random plans, the median took 16, and the longest 29.
constexpr int kYawIterations = 40;

/// Units of work of a whole yaw plan, at most: three for a point of the spline, two for a piece of it in an iteration.
constexpr uint32_t kYawWorkBound = 3 * (kMaxYawPieces + 2) + 2 * (kYawIterations + 2) * kMaxYawPieces;

/// Plans yaws. An object of about 90 * kMaxYawPieces bytes, with no other memory; it can be used again. Not
/// thread-safe.
class YawPlanner {
 public:
  /// The yaw plan for `trajectory`. kOk; kNonFiniteInput; kLimitsInvalid (a limit out of its range); kInvalidArgument
  /// (an empty trajectory, a mode that is none, a heading without direction, times that do not rise, least_speed or
  /// least_distance not positive); kStartExceedsLimits (the start's acceleration or rate). Unless it is kOk, `plan`
  /// stays as it was.
  Status plan(const Trajectory& trajectory, const YawRequest& request, YawPlan& plan) noexcept;

  /// Begins a yaw plan in slices. kRunning, or what is wrong with the request. `trajectory` must stay as it is until
  /// finish().
  Status begin(const Trajectory& trajectory, const YawRequest& request) noexcept;
  /// Goes on as long as work is left. A piece is a point of the spline, or an iteration of the optimisation. kRunning,
  /// kOk, or kInvalidArgument without begin().
  Status step(Work& work) noexcept;
  /// The same with `work` more units. What a call takes beyond them, the next calls take less.
  Status step(uint32_t work) noexcept;
  /// Hands over the plan. Before step() is done: the plan so far, which keeps the limits too, but follows the wish less
  /// closely. kInvalidArgument without begin().
  Status finish(YawPlan& plan) noexcept;

 private:
  class Fit;
  enum class Phase : uint8_t { kIdle = 0, kWish, kFit, kDone };

  void begin_lead() noexcept;
  void begin_spline() noexcept;
  double time_of(int knot) const noexcept;
  bool wished_direction(double t, Heading& direction) noexcept;
  double timed_angle(double t) const noexcept;
  void wish_next() noexcept;
  void take_point(Work& work) noexcept;

  Phase phase_ = Phase::kIdle;
  Work slice_;  // the work given to step(); a debt between two calls
  const Trajectory* trajectory_ = nullptr;
  YawRequest request_;
  YawPlan plan_;
  int knot_;
  double follower_;  ///< the angle that follows the wish as fast as the limit on the rate lets it
  int iterations_;
  double last_step_;  ///< of the optimisation, 0 .. 1
  // A number for each knot or control point; two prices for each limit on a rate or an acceleration.
  double wish_[kMaxYawPieces + 1];
  double rate_bound_[kMaxYawPieces + 3];
  double band_[3 * kMaxYawPieces];
  double change_[kMaxYawPieces];
  double rate_price_[2 * (kMaxYawPieces + 3)];
  double acceleration_price_[2 * (kMaxYawPieces + 3)];
};

}  // namespace tern

#endif
