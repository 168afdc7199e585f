// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bound.hpp"

#include "base/math.hpp"
#include "curve/bezier.hpp"
#include "yaw/angle.hpp"

namespace tern {
namespace {

constexpr double kHalfUlp = 1.0 / 16777216.0;          // of a float, relative
constexpr double kSmallest = 1e-45;                    // what a float may lose near 0
constexpr double kDoubles = 4.0 / 4503599627370496.0;  // rounding of world coordinates in double, relative
constexpr int kOrders = 4;                             // position, velocity, acceleration, jerk

/// Raises `most` to `x`. NaN stays NaN.
void raise(double& most, double x) {
  if (!(x <= most)) most = x;
}

/// Cuts a curve over [0, 1] to its part over [from, to].
void keep_part(Curve& curve, double from, double to) {
  for (int level = 1; level <= curve.degree; ++level) {
    for (int k = curve.degree; k >= level; --k) curve.c[k] = (1.0 - to) * curve.c[k - 1] + to * curve.c[k];
  }
  const double u = from / to;
  for (int level = 1; level <= curve.degree; ++level) {
    for (int k = 0; k <= curve.degree - level; ++k) curve.c[k] = (1.0 - u) * curve.c[k] + u * curve.c[k + 1];
  }
}

/// The time in which two curves overlap, seconds since the plan's beginning.
struct Overlap {
  double from, to;
};

void widen_by_overlap(const Segment& planned, double plan_begin, const Segment& flown, double begin, Overlap time,
                      const Vec3& shift, double (&most)[kOrders]) {
  Curve a = curve_of(planned);
  Curve b = curve_of(flown);
  for (int order = 0; order < kOrders; ++order) {
    if (order > 0) {
      a = hodograph(a, planned.duration);
      b = hodograph(b, flown.duration);
    }
    Curve plan_part = a;
    Curve flown_part = b;
    keep_part(plan_part, (time.from - plan_begin) / planned.duration, (time.to - plan_begin) / planned.duration);
    keep_part(flown_part, (time.from - begin) / flown.duration, (time.to - begin) / flown.duration);
    for (int i = 0; i <= a.degree; ++i) {
      const Vec3 apart = plan_part.c[i] - flown_part.c[i];
      raise(most[order], length(order == 0 ? apart + shift : apart));
    }
  }
}

/// Widens `error` by the difference between the yaw plan over [t, t + h], one cubic without a knot inside, and the same
/// part of the flown polynomial.
void widen_by_cubic(const YawPlan& plan, double t, double h, const Curve& flown, ExportError& error) {
  const YawSample first = evaluate(plan, t);
  const YawSample last = evaluate(plan, t + h);
  double c[kControlPoints] = {first.angle, first.angle + first.yaw.rate * h / 3.0, last.angle - last.yaw.rate * h / 3.0,
                              last.angle};
  for (int degree = 3; degree < kDegree; ++degree) {
    c[degree + 1] = c[degree];
    for (int k = degree; k > 0; --k) c[k] = (k * c[k - 1] + (degree + 1 - k) * c[k]) / (degree + 1);
  }
  for (int k = 0; k <= kDegree; ++k) {
    c[k] -= flown.c[k].x;
    raise(error.yaw, absolute(c[k]));
    if (k > 0) raise(error.yaw_rate, kDegree * absolute(c[k] - c[k - 1]) / h);
  }
}

/// Pieces of the spline, 0 in an empty plan.
int32_t pieces_of(const YawPlan& plan) {
  return plan.count < 1 || plan.count > kMaxYawPieces ? 0 : plan.count;
}

/// The first knot of the plan in (t, end), or the end. The knots are those of a uniform spline that follows the first
/// polynomial. `knot` is the number of a knot no later than the result.
double next_knot(const YawPlan& plan, double t, double end, int32_t& knot) {
  while (knot <= pieces_of(plan) && !(plan.lead + knot * plan.step > t)) ++knot;  // at most kMaxYawPieces + 1
  return knot <= pieces_of(plan) ? smaller(plan.lead + knot * plan.step, end) : end;
}

double rate_bound(const YawPlan& plan) {
  if (pieces_of(plan) == 0) return 0.0;
  const double* p = plan.polynomial;
  double most = absolute(p[1]) + plan.lead * (2.0 * absolute(p[2]) + 3.0 * plan.lead * absolute(p[3]));
  for (int32_t i = 0; i < plan.count + 2; ++i) {
    raise(most, absolute(plan.points[i + 1] - plan.points[i]) / plan.step);
  }
  return most;
}

}  // namespace

void widen_by_curve(const Trajectory& plan, const Segment& flown, const Vec3& origin, double begin,
                    ExportError& error) noexcept {
  double most[kOrders] = {error.position, error.velocity, error.acceleration, error.jerk};
  double plan_begin = 0.0;
  for (int i = 0; i < plan.count; ++i) {  // at most kMaxSegments: cut_spans() saw to it
    const Segment& planned = plan.segments[i];
    const double plan_end = plan_begin + planned.duration;
    const Overlap time{larger(begin, plan_begin), smaller(begin + flown.duration, plan_end)};
    if (time.from < time.to) {
      widen_by_overlap(planned, plan_begin, flown, begin, time, plan.origin - origin, most);
    }
    plan_begin = plan_end;
  }
  error.position = most[0];
  error.velocity = most[1];
  error.acceleration = most[2];
  error.jerk = most[3];
}

void widen_by_yaw(const YawPlan* plan, const double (&points)[kControlPoints], double begin, double duration,
                  ExportError& error) noexcept {
  if (plan == nullptr) return;
  Curve flown;
  flown.degree = kDegree;
  for (int i = 0; i < kControlPoints; ++i) flown.c[i] = {points[i], 0.0, 0.0};
  const double end = begin + duration;
  double t = begin;
  int32_t knot = 0;
  for (int turn = 0; turn < kMaxYawPieces + 3 && t < end; ++turn) {
    const double stop = next_knot(*plan, t, end, knot);
    Curve part = flown;
    keep_part(part, (t - begin) / duration, (stop - begin) / duration);
    widen_by_cubic(*plan, t, stop - t, part, error);
    t = stop;
  }
}

ExportError setpoint_error(const Trajectory& trajectory, const YawPlan* yaw, const Vec3& origin) noexcept {
  const Vec3 shift = trajectory.origin - origin;
  double world = 0.0;
  for (int a = 0; a < 3; ++a) raise(world, absolute(axis(trajectory.origin, a)) + absolute(axis(origin, a)));
  double most[kOrders] = {};
  for (int i = 0; i < trajectory.count && i < kMaxSegments; ++i) {
    Curve curve = curve_of(trajectory.segments[i]);
    for (int order = 0; order < kOrders; ++order) {
      if (order > 0) curve = hodograph(curve, trajectory.segments[i].duration);
      for (int k = 0; k <= curve.degree; ++k) {
        Vec3 size = order == 0 ? curve.c[k] + shift : curve.c[k];
        for (int a = 0; a < 3; ++a) axis(size, a) = kHalfUlp * absolute(axis(size, a)) + kSmallest;
        raise(most[order], length(size));
      }
    }
  }
  ExportError error{most[0] + kDoubles * world, most[1], most[2], most[3], 0.0, 0.0};
  if (yaw != nullptr) {
    error.yaw = kHalfUlp * kPi;
    error.yaw_rate = kHalfUlp * rate_bound(*yaw);
  }
  return error;
}

}  // namespace tern
