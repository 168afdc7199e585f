// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "baselines/soft_bspline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlopt.hpp>

#include "baselines/route.hpp"
#include "host/figures.hpp"

namespace tern_bench {
namespace {

using tern::Vec3;

/// Control points that are the same at either end: rest.
constexpr std::size_t kFixed = 3;
constexpr double kSampleStep = 5e-3;
constexpr double kRaise = 5.0;

double& axis(Vec3& v, int a) {
  return a == 0 ? v.x : (a == 1 ? v.y : v.z);
}
double axis(const Vec3& v, int a) {
  return a == 0 ? v.x : (a == 1 ? v.y : v.z);
}

Vec3 combine(const std::vector<Vec3>& points, std::size_t first, const double (&w)[4]) {
  Vec3 sum{0.0, 0.0, 0.0};
  for (std::size_t k = 0; k < 4; ++k) {
    for (int a = 0; a < 3; ++a) axis(sum, a) += w[k] * axis(points[first + k], a);
  }
  return sum;
}

/// Points `spacing` apart along a chain, both ends included.
std::vector<Vec3> resampled(const std::vector<Vec3>& chain, double spacing) {
  const double total = length(chain);
  const int pieces = std::max(2, static_cast<int>(std::lround(total / spacing)));
  std::vector<Vec3> points{chain.front()};
  double before = 0.0;
  std::size_t leg = 1;
  for (int k = 1; k < pieces; ++k) {
    const double wanted = total * k / pieces;
    while (leg + 1 < chain.size() && before + distance(chain[leg - 1], chain[leg]) < wanted) {
      before += distance(chain[leg - 1], chain[leg]);
      ++leg;
    }
    const double way = distance(chain[leg - 1], chain[leg]);
    const double t = way > 0.0 ? (wanted - before) / way : 0.0;
    Vec3 p{};
    for (int a = 0; a < 3; ++a)
      axis(p, a) = axis(chain[leg - 1], a) + t * (axis(chain[leg], a) - axis(chain[leg - 1], a));
    points.push_back(p);
  }
  points.push_back(chain.back());
  return points;
}

BSpline initial_curve(const std::vector<Vec3>& chain, const tern_host::Scenario& scenario, const SoftWeights& weights) {
  const std::vector<Vec3> way = resampled(chain, weights.spacing);
  const double speed = std::min({scenario.limits.v_max.x, scenario.limits.v_max.y, scenario.limits.v_max.z});
  BSpline curve;
  curve.interval = weights.pace * weights.spacing / speed;
  curve.points.assign(kFixed - 1, way.front());
  curve.points.insert(curve.points.end(), way.begin(), way.end());
  curve.points.insert(curve.points.end(), kFixed - 1, way.back());
  return curve;
}

/// Adds weight * |sum_k w[k] q[first + k]|^2 and its gradient.
double add_square(const std::vector<Vec3>& q, std::size_t first, const double (&w)[4], double weight,
                  std::vector<Vec3>& gradient) {
  const Vec3 d = combine(q, first, w);
  double cost = 0.0;
  for (int a = 0; a < 3; ++a) {
    cost += weight * axis(d, a) * axis(d, a);
    for (std::size_t k = 0; k < 4; ++k) axis(gradient[first + k], a) += 2.0 * weight * w[k] * axis(d, a);
  }
  return cost;
}

/// Adds weight * (excess of |sum_k w[k] q[first + k]| over the limit)^2 for each axis.
double add_excess(const std::vector<Vec3>& q, std::size_t first, const double (&w)[4], const Vec3& limit, double weight,
                  std::vector<Vec3>& gradient) {
  const Vec3 d = combine(q, first, w);
  double cost = 0.0;
  for (int a = 0; a < 3; ++a) {
    const double excess = std::fabs(axis(d, a)) - axis(limit, a);
    if (excess <= 0.0) continue;
    cost += weight * excess * excess;
    const double slope = 2.0 * weight * excess * (axis(d, a) > 0.0 ? 1.0 : -1.0);
    for (std::size_t k = 0; k < 4; ++k) axis(gradient[first + k], a) += slope * w[k];
  }
  return cost;
}

double add_collision(const Vec3& point, const tern_host::Scenario& scenario, const SoftWeights& weights,
                     Vec3& gradient) {
  Vec3 away{};
  const double lack = scenario.radius + weights.margin - signed_distance(point, scenario, away);
  if (lack <= 0.0) return 0.0;
  for (int a = 0; a < 3; ++a) axis(gradient, a) -= 2.0 * weights.collision * lack * axis(away, a);
  return weights.collision * lack * lack;
}

double cost_of(const BSpline& curve, const tern_host::Scenario& scenario, const SoftWeights& weights,
               std::vector<Vec3>& gradient) {
  const std::vector<Vec3>& q = curve.points;
  const double h = curve.interval;
  const double third[4] = {-1.0, 3.0, -3.0, 1.0};
  const double speed[4] = {-1.0 / h, 1.0 / h, 0.0, 0.0};
  const double push[4] = {1.0 / (h * h), -2.0 / (h * h), 1.0 / (h * h), 0.0};
  gradient.assign(q.size(), {0.0, 0.0, 0.0});
  double cost = 0.0;
  for (std::size_t i = 0; i + 3 < q.size(); ++i) {
    cost += add_square(q, i, third, weights.smoothness, gradient);
    cost += add_excess(q, i, speed, scenario.limits.v_max, weights.limits, gradient);
    cost += add_excess(q, i, push, scenario.limits.a_max, weights.limits, gradient);
  }
  for (std::size_t i = kFixed; i + kFixed < q.size(); ++i) {
    cost += add_collision(q[i], scenario, weights, gradient[i]);
  }
  return cost;
}

/// What NLopt sees: the free control points as one vector.
struct Problem {
  BSpline& curve;
  const tern_host::Scenario& scenario;
  const SoftWeights& weights;
  int evaluations = 0;
  std::vector<Vec3> gradient{};

  std::size_t size() const { return curve.points.size() > 2 * kFixed ? 3 * (curve.points.size() - 2 * kFixed) : 0; }

  std::vector<double> get() const {
    std::vector<double> x;
    for (std::size_t i = kFixed; i + kFixed < curve.points.size(); ++i) {
      for (int a = 0; a < 3; ++a) x.push_back(axis(curve.points[i], a));
    }
    return x;
  }
  void set(const std::vector<double>& x) {
    for (std::size_t i = 0; i < x.size(); ++i) axis(curve.points[kFixed + i / 3], static_cast<int>(i % 3)) = x[i];
  }
};

double evaluate_problem(const std::vector<double>& x, std::vector<double>& gradient, void* data) {
  Problem& problem = *static_cast<Problem*>(data);
  problem.set(x);
  ++problem.evaluations;
  const double cost = cost_of(problem.curve, problem.scenario, problem.weights, problem.gradient);
  for (std::size_t i = 0; i < gradient.size(); ++i) {
    gradient[i] = axis(problem.gradient[kFixed + i / 3], static_cast<int>(i % 3));
  }
  return cost;
}

void minimise(Problem& problem) {
  const std::size_t n = problem.size();
  if (n == 0) return;
  nlopt::opt optimiser(nlopt::LD_LBFGS, static_cast<unsigned>(n));
  optimiser.set_min_objective(evaluate_problem, &problem);
  optimiser.set_maxeval(problem.weights.evaluations);
  optimiser.set_ftol_rel(1e-6);
  std::vector<double> low(n), high(n);
  for (std::size_t i = 0; i < n; ++i) {
    low[i] = axis(problem.scenario.boundary.lower, static_cast<int>(i % 3));
    high[i] = axis(problem.scenario.boundary.upper, static_cast<int>(i % 3));
  }
  optimiser.set_lower_bounds(low);
  optimiser.set_upper_bounds(high);
  std::vector<double> x = problem.get();
  for (std::size_t i = 0; i < n; ++i) x[i] = std::min(std::max(x[i], low[i]), high[i]);
  double cost = 0.0;
  try {
    optimiser.optimize(x, cost);
  } catch (const nlopt::roundoff_limited&) {
    // As far as doubles go: x is the best so far.
  } catch (const std::runtime_error&) {
    // A line search without progress: likewise.
  }
  problem.set(x);
}

bool is_clear(const BSpline& curve, const tern_host::Scenario& scenario) {
  const int samples = static_cast<int>(std::ceil(curve.duration() / kSampleStep));
  for (int i = 0; i <= samples; ++i) {
    const Vec3 p = curve.evaluate(curve.duration() * i / samples).position;
    if (tern_host::distance_to_blocks(p, scenario) < scenario.radius) return false;
  }
  return true;
}

}  // namespace

tern::Sample BSpline::evaluate(double t) const {
  const double last = static_cast<double>(points.size() - 3);
  const double at = std::min(std::max(t / interval, 0.0), last);
  const std::size_t first = std::min(static_cast<std::size_t>(at), points.size() - 4);
  const double u = at - static_cast<double>(first);
  const double v = 1.0 - u;
  const double h = interval;
  const double w0[4] = {v * v * v / 6.0, (3.0 * u * u * u - 6.0 * u * u + 4.0) / 6.0,
                        (-3.0 * u * u * u + 3.0 * u * u + 3.0 * u + 1.0) / 6.0, u * u * u / 6.0};
  const double w1[4] = {-v * v / (2.0 * h), (3.0 * u * u - 4.0 * u) / (2.0 * h),
                        (-3.0 * u * u + 2.0 * u + 1.0) / (2.0 * h), u * u / (2.0 * h)};
  const double w2[4] = {v / (h * h), (3.0 * u - 2.0) / (h * h), (1.0 - 3.0 * u) / (h * h), u / (h * h)};
  const double cube = h * h * h;
  const double w3[4] = {-1.0 / cube, 3.0 / cube, -3.0 / cube, 1.0 / cube};
  return {combine(points, first, w0),
          combine(points, first, w1),
          combine(points, first, w2),
          combine(points, first, w3),
          {0.0, 0.0, 0.0}};
}

double signed_distance(const Vec3& p, const tern_host::Scenario& scenario, Vec3& gradient) {
  double least = std::numeric_limits<double>::infinity();
  gradient = {0.0, 0.0, 0.0};
  for (const tern_host::Block& block : scenario.blocks) {
    Vec3 out{0.0, 0.0, 0.0};
    double square = 0.0;
    double depth = -std::numeric_limits<double>::infinity();
    Vec3 face{0.0, 0.0, 0.0};
    for (int a = 0; a < 3; ++a) {
      const double below = axis(block.box.lower, a) - axis(p, a);
      const double above = axis(p, a) - axis(block.box.upper, a);
      const double beyond = std::max(below, above);
      if (beyond > depth) {
        depth = beyond;
        face = {0.0, 0.0, 0.0};
        axis(face, a) = above > below ? 1.0 : -1.0;
      }
      if (beyond > 0.0) {
        axis(out, a) = above > below ? beyond : -beyond;
        square += beyond * beyond;
      }
    }
    const double d = square > 0.0 ? std::sqrt(square) : depth;
    if (d >= least) continue;
    least = d;
    gradient = square > 0.0 ? Vec3{out.x / d, out.y / d, out.z / d} : face;
  }
  return least;
}

double soft_cost(const BSpline& curve, const tern_host::Scenario& scenario, const SoftWeights& weights,
                 std::vector<double>& gradient) {
  std::vector<Vec3> all;
  const double cost = cost_of(curve, scenario, weights, all);
  gradient.clear();
  for (std::size_t i = kFixed; i + kFixed < all.size(); ++i) {
    for (int a = 0; a < 3; ++a) gradient.push_back(axis(all[i], a));
  }
  return cost;
}

SoftResult soft_bspline(const std::vector<Vec3>& chain, const tern_host::Scenario& scenario,
                        const SoftWeights& weights) {
  SoftResult result;
  result.curve = initial_curve(chain, scenario, weights);
  SoftWeights raised = weights;
  while (result.rounds < weights.rounds && !result.clear) {
    Problem problem{result.curve, scenario, raised};
    minimise(problem);
    ++result.rounds;
    result.evaluations += problem.evaluations;
    result.clear = is_clear(result.curve, scenario);
    raised.collision *= kRaise;
  }
  return result;
}

}  // namespace tern_bench
