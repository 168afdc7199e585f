// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/math.hpp"
#include "tern/yaw.hpp"
#include "yaw/angle.hpp"

namespace tern {
namespace {

/// The angle with two derivatives: rad, rad/s, rad/s^2.
struct Turn {
  double angle;
  double rate;
  double acceleration;
};

Turn on_lead(const double* p, double t) {
  return {((p[3] * t + p[2]) * t + p[1]) * t + p[0], (3.0 * p[3] * t + 2.0 * p[2]) * t + p[1],
          6.0 * p[3] * t + 2.0 * p[2]};
}

/// The turn on a piece of the spline, `u` steps after its beginning, 0 .. 1, from de Boor's points of each derivative.
Turn on_piece(const double* c, double u, double step) {
  const double v = 1.0 - u;
  const double rates[3] = {c[1] - c[0], c[2] - c[1], c[3] - c[2]};
  const double first = rates[1] - rates[0];
  const double second = rates[2] - rates[1];
  // The cubic is its Taylor series at the beginning of the piece.
  const double begin = c[1] + (rates[1] - rates[0]) / 6.0;
  const double begin_rate = 0.5 * (rates[0] + rates[1]);
  const double angle = begin + u * (begin_rate + u * (0.5 * first + u * (second - first) / 6.0));
  const double rate = 0.5 * v * v * rates[0] + (0.5 + u * v) * rates[1] + 0.5 * u * u * rates[2];
  return {angle, rate / step, (v * first + u * second) / (step * step)};
}

Turn turn_at(const YawPlan& plan, double t) {
  if (!(t > 0.0)) return on_lead(plan.polynomial, 0.0);
  if (t < plan.lead) return on_lead(plan.polynomial, t);
  const double steps = (t - plan.lead) / plan.step;
  if (t >= duration(plan) || !(steps < plan.count)) return {plan.points[plan.count + 2], 0.0, 0.0};
  const int piece = static_cast<int>(steps);
  return on_piece(plan.points + piece, steps - piece, plan.step);
}

bool is_empty(const YawPlan& plan) {
  return plan.count < 1 || plan.count > kMaxYawPieces;
}

}  // namespace

double duration(const YawPlan& plan) noexcept {
  return is_empty(plan) ? 0.0 : plan.lead + plan.count * plan.step;
}

YawSample evaluate(const YawPlan& plan, double t) noexcept {
  if (is_empty(plan)) return {{1.0, 0.0, 0.0}, 0.0, 0.0};
  const Turn turn = turn_at(plan, t);
  const Heading heading = heading_of(turn.angle);
  return {{heading.cosine, heading.sine, turn.rate}, turn.acceleration, turn.angle};
}

}  // namespace tern
