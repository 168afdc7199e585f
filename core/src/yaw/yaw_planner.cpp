// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/capacity.hpp"
#include "base/math.hpp"
#include "base/work.hpp"
#include "tern/yaw.hpp"
#include "yaw/angle.hpp"
#include "yaw/yaw_check.hpp"
#include "yaw/yaw_fit.hpp"

namespace tern {
namespace {

/// Operations for a point of the spline: a sample of the trajectory, its direction and its angle.
constexpr Operations kPointOperations = 4 * ops::kCurve;
/// Operations for a piece of the spline in an iteration: four passes over its two limits.
constexpr Operations kPieceOperations = 4 * 2 * ops::kPiece;
static_assert(kPointOperations <= 3 * kUnit && kPieceOperations <= 2 * kUnit, "kYawWorkBound counts with these");

/// Pieces are this long, s, unless the plan then needs more than kMaxYawPieces.
constexpr double kPiece = 0.1;
constexpr int kLeastPieces = 8;
/// Time for a half turn after the trajectory, in parts of the time that it takes at the limits.
constexpr double kTurnShare = 1.2;
/// The first polynomial may use this share of the room between the rate and its limit.
constexpr double kLeadShare = 0.9;
constexpr double kShortestLead = 1e-6;

Heading horizontal(const Vec3& v) {
  return {v.x, v.y};
}

double norm(const Heading& h) {
  return square_root(h.cosine * h.cosine + h.sine * h.sine);
}

}  // namespace

Status YawPlanner::begin(const Trajectory& trajectory, const YawRequest& request) noexcept {
  phase_ = Phase::kIdle;
  const Status status = check_yaw(trajectory, request);
  if (status != Status::kOk) return status;
  trajectory_ = &trajectory;
  request_ = request;
  begin_lead();
  begin_spline();
  knot_ = 0;
  slice_ = Work{};
  iterations_ = 0;
  phase_ = Phase::kWish;
  return Status::kRunning;
}

/// Begins with a polynomial on which the acceleration falls to 0 at a constant jerk, before the rate comes near to its
/// limit.
void YawPlanner::begin_lead() noexcept {
  const double rate = request_.start_rate;
  const double acceleration = request_.start_acceleration;
  plan_.lead = 0.0;
  const bool is_moving = absolute(acceleration) > 0.0;
  if (is_moving) {
    const double left = larger(0.0, request_.rate_max - (acceleration < 0.0 ? -rate : rate));
    plan_.lead = clamp(kLeadShare * 2.0 * left / absolute(acceleration), kShortestLead, kPiece);
  }
  plan_.polynomial[0] = angle_of(request_.start);
  plan_.polynomial[1] = rate;
  plan_.polynomial[2] = 0.5 * acceleration;
  plan_.polynomial[3] = is_moving ? -acceleration / (6.0 * plan_.lead) : 0.0;
}

/// The pieces reach past the trajectory's end, so far that a half turn can end there. The first three control points
/// follow from angle and rate; the acceleration is 0.
void YawPlanner::begin_spline() noexcept {
  const double* p = plan_.polynomial;
  const double t = plan_.lead;
  const double angle = ((p[3] * t + p[2]) * t + p[1]) * t + p[0];
  const double rate = (3.0 * p[3] * t + 2.0 * p[2]) * t + p[1];
  const double turn = kPi / request_.rate_max + (request_.rate_max + 2.0 * absolute(rate)) / request_.acceleration_max;
  const double length = larger(duration(*trajectory_) - t, 0.0) + kTurnShare * turn + kYawSmoothing;
  const double wanted = length / kPiece;
  plan_.count = is_full(!(wanted < kMaxYawPieces)) ? kMaxYawPieces : static_cast<int32_t>(wanted) + 1;
  if (plan_.count < kLeastPieces) plan_.count = kLeastPieces;
  plan_.step = length / plan_.count;
  for (int k = 0; k < 3; ++k) plan_.points[k] = angle + (k - 1) * plan_.step * rate;
  follower_ = angle;
}

double YawPlanner::time_of(int knot) const noexcept {
  return plan_.lead + knot * plan_.step;
}

/// The direction that the mode asks for at time `t`. False if there is none.
bool YawPlanner::wished_direction(double t, Heading& direction) noexcept {
  if (request_.mode == YawMode::kFixed) {
    direction = request_.heading;
    return true;
  }
  if (t >= duration(*trajectory_) && request_.mode == YawMode::kAlongMotion) return false;
  const Sample sample = evaluate(*trajectory_, t);
  if (request_.mode == YawMode::kAlongMotion) {
    direction = horizontal(sample.velocity);
    return norm(direction) >= request_.least_speed;
  }
  direction = horizontal(request_.point - sample.position);
  return norm(direction) >= request_.least_distance;
}

/// The angle at a time: between two headings the shorter turn, at a constant rate, and before the first heading the
/// turn from the start's.
double YawPlanner::timed_angle(double t) const noexcept {
  double last = angle_of(request_.start);
  double since = 0.0;
  for (int i = 0; i < request_.timed_count; ++i) {
    const TimedHeading& next = request_.timed[i];
    const double turn = wrapped(angle_of(next.heading) - last);
    if (t < next.time) return last + turn * ((t - since) / (next.time - since));
    last += turn;
    since = next.time;
  }
  return last;
}

/// Sets the wish at the next knot, without whole turns: within half a turn of `follower_`.
void YawPlanner::wish_next() noexcept {
  const double t = time_of(knot_);
  double turn = 0.0;
  Heading direction{1.0, 0.0};
  if (request_.mode == YawMode::kTimed) {
    turn = wrapped(timed_angle(t) - follower_);
  } else if (wished_direction(t, direction)) {
    turn = wrapped(angle_of(direction) - follower_);
  } else if (knot_ > 0) {
    turn = wish_[knot_ - 1] - follower_;
  }
  wish_[knot_] = follower_ + turn;
  const double most = request_.rate_max * plan_.step;
  follower_ += clamp(turn, -most, most);
}

/// The next point of the spline. The last one also begins the fit.
void YawPlanner::take_point(Work& work) noexcept {
  work.spend(kPointOperations);
  wish_next();
  if (knot_++ < plan_.count) return;
  work.spend(kPieceOperations * plan_.count);
  Fit(*this).begin();
  phase_ = Phase::kFit;
}

Status YawPlanner::step(Work& work) noexcept {
  if (phase_ == Phase::kIdle) return Status::kInvalidArgument;
  while (phase_ != Phase::kDone) {
    if (!work.left()) return Status::kRunning;
    if (phase_ == Phase::kWish) {
      take_point(work);
      continue;
    }
    work.spend(kPieceOperations * plan_.count);
    if (is_full(iterations_++ == kYawIterations) || !Fit(*this).iterate()) phase_ = Phase::kDone;
  }
  return Status::kOk;
}

Status YawPlanner::step(uint32_t work) noexcept {
  slice_.add(work);
  return step(slice_);
}

Status YawPlanner::finish(YawPlan& plan) noexcept {
  if (phase_ == Phase::kIdle) return Status::kInvalidArgument;
  if (phase_ == Phase::kWish) Fit(*this).begin();
  phase_ = Phase::kIdle;
  plan = plan_;
  return Status::kOk;
}

Status YawPlanner::plan(const Trajectory& trajectory, const YawRequest& request, YawPlan& plan) noexcept {
  const Status status = begin(trajectory, request);
  if (status != Status::kRunning) return status;
  step(kYawWorkBound);
  return finish(plan);
}

}  // namespace tern
