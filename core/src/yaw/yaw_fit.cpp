// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "yaw/yaw_fit.hpp"

#include "base/math.hpp"

namespace tern {
namespace {

/// Shares of the acceleration limit. The brake slows down at the first. If the start is too fast, the bounds on the
/// rate fall at the second, more slowly, which keeps the brake inside them.
constexpr double kBrakeShare = 0.9;
constexpr double kBoundShare = 0.8;
/// An iteration aims at the share kAim of the gap if the last step was longer than kLongStep, and otherwise at
/// kAimAgain. A step goes at most the share kStay of the way to the nearest bound.
constexpr double kAim = 0.1;
constexpr double kAimAgain = 0.7;
constexpr double kLongStep = 0.6;
constexpr double kStay = 0.95;
/// Mean gap of a limit, rad^2, at which the fit is done.
constexpr double kLeastGap = 1e-11;
/// Least slack of a limit, as a share of the largest angle, at which the fit is done: rounding would decide anything
/// smaller.
constexpr double kLeastSlack = 1e-12;
/// The start's three control points are given.
constexpr int kGiven = 3;

}  // namespace

YawPlanner::Fit::Row YawPlanner::Fit::row(int first, double a, double b, double c) const noexcept {
  const double factors[3] = {a, b, c};
  const double* points = y_.plan_.points + first;
  Row result{0, {}, {}, (a * points[0] + b * points[1]) + c * points[2]};
  for (int i = 0; i < 3; ++i) {
    const int wanted = first + i - kGiven;
    if (wanted < 0) continue;
    const int variable = wanted < variables_ ? wanted : variables_ - 1;
    if (result.count > 0 && result.variable[result.count - 1] == variable) {
      result.factor[result.count - 1] += factors[i];
      continue;
    }
    result.variable[result.count] = variable;
    result.factor[result.count++] = factors[i];
  }
  return result;
}

/// The row that gives the angle at a knot.
YawPlanner::Fit::Row YawPlanner::Fit::fit_row(int knot) const noexcept {
  return row(knot, 1.0 / 6.0, 4.0 / 6.0, 1.0 / 6.0);
}

double YawPlanner::Fit::acceleration_bound() const noexcept {
  return y_.request_.acceleration_max * y_.plan_.step * y_.plan_.step;
}

/// The limits in turn: even numbers are accelerations, odd ones rates, of the control points that are free.
YawPlanner::Fit::Limit YawPlanner::Fit::limit(int number) const noexcept {
  const int k = 2 + number / 2;
  if (is_rate(number)) return {row(k, -1.0, 1.0, 0.0), y_.rate_bound_[k], y_.rate_price_ + 2 * k};
  return {row(k - 1, 1.0, -2.0, 1.0), acceleration_bound(), y_.acceleration_price_ + 2 * k};
}

/// Sets the control points to the brake, and the bounds of the rates around it.
void YawPlanner::Fit::brake() noexcept {
  double* c = y_.plan_.points;
  const double most = acceleration_bound();
  const double rate = y_.request_.rate_max * y_.plan_.step;
  double step = c[2] - c[1];
  double allowed = absolute(step);
  for (int k = 2; k < y_.plan_.count + 2; ++k) {
    step -= clamp(step, -kBrakeShare * most, kBrakeShare * most);
    allowed = larger(0.0, allowed - kBoundShare * most);
    y_.rate_bound_[k] = larger(rate, allowed);
    c[k + 1] = c[k] + step;
  }
}

/// Mean square of the brake's distance from the wish, rad^2: how much there is to gain.
double YawPlanner::Fit::first_gap() const noexcept {
  double sum = 0.0;
  for (int i = 1; i <= y_.plan_.count; ++i) {
    const double error = fit_row(i).value - y_.wish_[i];
    sum += error * error;
  }
  return larger(sum / y_.plan_.count, kLeastGap);
}

void YawPlanner::Fit::begin() noexcept {
  y_.last_step_ = 0.0;
  brake();
  const double gap = first_gap();
  for (int i = 0; i < limit_count(); ++i) {
    const Limit l = limit(i);
    l.price[0] = gap / (l.bound - l.row.value);
    l.price[1] = gap / (l.bound + l.row.value);
  }
}

/// Adds weight/2 (row)^2 + slope row to the objective's second-order model.
void YawPlanner::Fit::add(const Row& row, double weight, double slope) noexcept {
  for (int i = 0; i < row.count; ++i) {
    y_.change_[row.variable[i]] -= slope * row.factor[i];
    for (int j = 0; j <= i; ++j) {
      y_.band_[3 * row.variable[i] + (row.variable[i] - row.variable[j])] += weight * row.factor[i] * row.factor[j];
    }
  }
}

/// Assembles the matrix and the right-hand side of Newton's step towards the point of the central path with the gap
/// `target`.
void YawPlanner::Fit::assemble(double target) noexcept {
  for (int i = 0; i < 3 * variables_; ++i) y_.band_[i] = 0.0;
  for (int i = 0; i < variables_; ++i) y_.change_[i] = 0.0;
  const double ratio = kYawSmoothing / y_.plan_.step;
  const double smoothing = ratio * ratio * ratio * ratio;
  for (int i = 1; i <= y_.plan_.count; ++i) {
    const Row row = fit_row(i);
    add(row, 1.0, row.value - y_.wish_[i]);
  }
  for (int i = 0; i < limit_count(); ++i) {
    const Limit l = limit(i);
    const double above = l.bound - l.row.value;
    const double below = l.bound + l.row.value;
    const double smooth = is_rate(i) ? 0.0 : smoothing;
    add(l.row, smooth + (l.price[0] / above + l.price[1] / below),
        smooth * l.row.value + (target / above - target / below));
  }
}

/// Replaces the five diagonals by their Cholesky factors, and the right-hand side by the solution.
void YawPlanner::Fit::solve() noexcept {
  double* a = y_.band_;
  double* x = y_.change_;
  for (int i = 0; i < variables_; ++i) {
    double* r = a + 3 * i;
    if (i >= 2) r[2] /= a[3 * (i - 2)];
    if (i >= 2) r[1] -= r[2] * a[3 * (i - 1) + 1];
    if (i >= 1) r[1] /= a[3 * (i - 1)];
    for (int k = 1; k <= 2 && k <= i; ++k) r[0] -= r[k] * r[k];
    r[0] = square_root(r[0]);
    for (int k = 1; k <= 2 && k <= i; ++k) x[i] -= r[k] * x[i - k];
    x[i] /= r[0];
  }
  for (int i = variables_ - 1; i >= 0; --i) {
    for (int k = 1; k <= 2 && i + k < variables_; ++k) x[i] -= a[3 * (i + k) + k] * x[i + k];
    x[i] /= a[3 * i];
  }
}

double YawPlanner::Fit::change_of(const Row& row) const noexcept {
  double sum = 0.0;
  for (int i = 0; i < row.count; ++i) sum += row.factor[i] * y_.change_[row.variable[i]];
  return sum;
}

/// Mean product of slack and price: half the distance from the optimum, for each limit.
double YawPlanner::Fit::gap() const noexcept {
  double sum = 0.0;
  for (int i = 0; i < limit_count(); ++i) {
    const Limit l = limit(i);
    sum += l.price[0] * (l.bound - l.row.value) + l.price[1] * (l.bound + l.row.value);
  }
  return sum / (2.0 * limit_count());
}

namespace {

/// How a price changes if its slack falls by `fall`.
double price_change(double price, double slack, double fall, double target) {
  return ((target - slack * price) + price * fall) / slack;
}

/// The part of a step after which `value` would be 0.
double part_to_zero(double value, double change) {
  return change < 0.0 ? -value / change : 1e9;
}

}  // namespace

/// The least of the limits' slacks, as a share of the largest angle.
double YawPlanner::Fit::least_slack() const noexcept {
  double least = 1e9;
  double size = 1.0;
  for (int i = 0; i < limit_count(); ++i) {
    const Limit l = limit(i);
    least = smaller(least, l.bound - absolute(l.row.value));
    size = larger(size, absolute(y_.plan_.points[2 + i / 2]));
  }
  return least / size;
}

double YawPlanner::Fit::longest_step(double target) const noexcept {
  double longest = 1.0 / kStay;
  for (int i = 0; i < limit_count(); ++i) {
    const Limit l = limit(i);
    const double rise = change_of(l.row);
    const double above = l.bound - l.row.value;
    const double below = l.bound + l.row.value;
    longest = smaller(longest, part_to_zero(above, -rise));
    longest = smaller(longest, part_to_zero(below, rise));
    longest = smaller(longest, part_to_zero(l.price[0], price_change(l.price[0], above, rise, target)));
    longest = smaller(longest, part_to_zero(l.price[1], price_change(l.price[1], below, -rise, target)));
  }
  return kStay * longest;
}

void YawPlanner::Fit::move(double step, double target) noexcept {
  for (int i = 0; i < limit_count(); ++i) {
    const Limit l = limit(i);
    const double rise = change_of(l.row);
    const double above = l.bound - l.row.value;
    const double below = l.bound + l.row.value;
    l.price[0] += step * price_change(l.price[0], above, rise, target);
    l.price[1] += step * price_change(l.price[1], below, -rise, target);
  }
  double* free = y_.plan_.points + kGiven;
  for (int i = 0; i < variables_; ++i) free[i] += step * y_.change_[i];
  for (int i = 0; i < 2; ++i) free[variables_ + i] = free[variables_ - 1];
}

bool YawPlanner::Fit::iterate() noexcept {
  const double now = gap();
  if (!(now > kLeastGap && least_slack() > kLeastSlack)) return false;
  const double target = (y_.last_step_ > kLongStep ? kAim : kAimAgain) * now;
  assemble(target);
  solve();
  y_.last_step_ = longest_step(target);
  move(y_.last_step_, target);
  return true;
}

}  // namespace tern
