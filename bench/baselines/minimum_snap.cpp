// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "baselines/minimum_snap.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "host/figures.hpp"

namespace tern_bench {
namespace {

using tern::Vec3;

constexpr int kOrder = 4;  ///< derivatives that an end of a segment has: position to jerk
using Form = Eigen::Matrix<double, 2 * kOrder, 2 * kOrder>;

/// i (i - 1) ... (i - k + 1)
double falling(int i, int k) {
  double product = 1.0;
  for (int j = 0; j < k; ++j) product *= i - j;
  return product;
}

/// The derivatives at 0 and at 1 of the monomials u^0 .. u^7.
Form ends_of_monomials() {
  Form ends = Form::Zero();
  for (int k = 0; k < kOrder; ++k) {
    ends(k, k) = falling(k, k);
    for (int i = k; i < 2 * kOrder; ++i) ends(kOrder + k, i) = falling(i, k);
  }
  return ends;
}

Form snap_of_monomials() {
  Form snap = Form::Zero();
  for (int i = 4; i < 2 * kOrder; ++i) {
    for (int j = 4; j < 2 * kOrder; ++j) snap(i, j) = falling(i, 4) * falling(j, 4) / (i + j - 7);
  }
  return snap;
}

const Form& monomials_from_ends() {
  static const Form inverse = ends_of_monomials().inverse();
  return inverse;
}

const Form& unit_form() {
  static const Form form = monomials_from_ends().transpose() * snap_of_monomials() * monomials_from_ends();
  return form;
}

/// The form of a segment that lasts `duration`, in derivatives with respect to time.
Form form_of(double duration) {
  Form form = unit_form();
  for (int i = 0; i < 2 * kOrder; ++i) {
    for (int j = 0; j < 2 * kOrder; ++j) form(i, j) *= std::pow(duration, i % kOrder + j % kOrder - 7);
  }
  return form;
}

double axis(const Vec3& v, int a) {
  return a == 0 ? v.x : (a == 1 ? v.y : v.z);
}

double& axis(Vec3& v, int a) {
  return a == 0 ? v.x : (a == 1 ? v.y : v.z);
}

/// Rows: the derivatives of all waypoints, four a waypoint; columns: x, y, z.
using States = Eigen::MatrixXd;

States optimal_states(const std::vector<Vec3>& waypoints, const std::vector<double>& durations) {
  const int points = static_cast<int>(waypoints.size());
  Eigen::MatrixXd form = Eigen::MatrixXd::Zero(kOrder * points, kOrder * points);
  for (int s = 0; s + 1 < points; ++s) {
    form.block<2 * kOrder, 2 * kOrder>(kOrder * s, kOrder * s) += form_of(durations[static_cast<std::size_t>(s)]);
  }
  States states = States::Zero(kOrder * points, 3);
  for (int p = 0; p < points; ++p) {
    for (int a = 0; a < 3; ++a) states(kOrder * p, a) = axis(waypoints[static_cast<std::size_t>(p)], a);
  }
  std::vector<int> free_rows;
  for (int p = 1; p + 1 < points; ++p) {
    for (int k = 1; k < kOrder; ++k) free_rows.push_back(kOrder * p + k);
  }
  const int n = static_cast<int>(free_rows.size());
  if (n == 0) return states;
  // The derivative of the cost with respect to the free states is zero; those that are given go to the right-hand side.
  Eigen::MatrixXd left(n, n);
  Eigen::MatrixXd right(n, 3);
  const Eigen::MatrixXd given = form * states;
  for (int i = 0; i < n; ++i) {
    right.row(i) = -given.row(free_rows[static_cast<std::size_t>(i)]);
    for (int j = 0; j < n; ++j) {
      left(i, j) = form(free_rows[static_cast<std::size_t>(i)], free_rows[static_cast<std::size_t>(j)]);
    }
  }
  const Eigen::MatrixXd solution = left.ldlt().solve(right);
  for (int i = 0; i < n; ++i) states.row(free_rows[static_cast<std::size_t>(i)]) = solution.row(i);
  return states;
}

double binomial(int n, int k) {
  return falling(n, k) / falling(k, k);
}

tern::Segment segment_of(const States& states, int index, double duration) {
  Eigen::Matrix<double, 2 * kOrder, 3> ends = states.middleRows<2 * kOrder>(kOrder * index);
  for (int k = 0; k < 2 * kOrder; ++k) ends.row(k) *= std::pow(duration, k % kOrder);
  const Eigen::Matrix<double, 2 * kOrder, 3> monomials = monomials_from_ends() * ends;
  tern::Segment segment{};
  segment.duration = duration;
  segment.polyhedron = index;
  for (int i = 0; i <= tern::kDegree; ++i) {
    for (int a = 0; a < 3; ++a) {
      for (int j = 0; j <= i; ++j) {
        axis(segment.points[i], a) += binomial(i, j) / binomial(tern::kDegree, j) * monomials(j, a);
      }
    }
  }
  return segment;
}

/// Seconds between samples: at 2 m/s a collision is looked for every two centimetres.
constexpr double kCollisionStep = 10e-3;
constexpr double kPeakStep = 1e-3;

/// Samples of every segment, `step` seconds apart at most.
template <typename Look>
void for_each_sample(const tern::Trajectory& trajectory, double step, Look look) {
  double begin = 0.0;
  for (int s = 0; s < trajectory.count; ++s) {
    const double duration = trajectory.segments[s].duration;
    const int samples = std::max(20, static_cast<int>(std::ceil(duration / step)));
    for (int i = 0; i < samples; ++i) look(s, tern::evaluate(trajectory, begin + duration * i / samples));
    begin += duration;
  }
}

std::vector<bool> colliding_segments(const tern::Trajectory& trajectory, const tern_host::Scenario& scenario) {
  std::vector<bool> hits(static_cast<std::size_t>(trajectory.count), false);
  for_each_sample(trajectory, kCollisionStep, [&](int s, const tern::Sample& sample) {
    const auto at = static_cast<std::size_t>(s);
    if (!hits[at]) hits[at] = tern_host::distance_to_blocks(sample.position, scenario) < scenario.radius;
  });
  return hits;
}

/// Puts waypoints into the segments that hit something. How many.
int insert_waypoints(const std::vector<bool>& hits, std::vector<Vec3>& waypoints, std::vector<double>& durations) {
  int inserted = 0;
  for (std::size_t s = hits.size(); s-- > 0;) {
    if (!hits[s] || durations.size() == static_cast<std::size_t>(tern::kMaxSegments)) continue;
    const Vec3& a = waypoints[s];
    const Vec3& b = waypoints[s + 1];
    const Vec3 middle{0.5 * (a.x + b.x), 0.5 * (a.y + b.y), 0.5 * (a.z + b.z)};
    waypoints.insert(waypoints.begin() + static_cast<std::ptrdiff_t>(s) + 1, middle);
    durations[s] *= 0.5;
    durations.insert(durations.begin() + static_cast<std::ptrdiff_t>(s), durations[s]);
    ++inserted;
  }
  return inserted;
}

}  // namespace

void snap_form_of_unit_segment(double form[8][8]) {
  for (int i = 0; i < 8; ++i) {
    for (int j = 0; j < 8; ++j) form[i][j] = unit_form()(i, j);
  }
}

tern::Trajectory minimum_snap(const std::vector<Vec3>& waypoints, const std::vector<double>& durations) {
  const auto positive = [](double t) { return t > 0.0; };
  if (waypoints.size() < 2 || durations.size() + 1 != waypoints.size() ||
      durations.size() > static_cast<std::size_t>(tern::kMaxSegments) ||
      !std::all_of(durations.begin(), durations.end(), positive)) {
    throw std::invalid_argument("minimum_snap: one positive duration a segment, two waypoints at least");
  }
  const States states = optimal_states(waypoints, durations);
  tern::Trajectory trajectory{};
  trajectory.count = static_cast<int>(durations.size());
  for (int s = 0; s < trajectory.count; ++s) {
    trajectory.segments[s] = segment_of(states, s, durations[static_cast<std::size_t>(s)]);
  }
  return trajectory;
}

MendedPolynomial mend_collisions(std::vector<Vec3> waypoints, std::vector<double> durations,
                                 const tern_host::Scenario& scenario, int rounds) {
  MendedPolynomial mended;
  for (int round = 0; round < rounds; ++round) {
    mended.trajectory = minimum_snap(waypoints, durations);
    ++mended.solves;
    const std::vector<bool> hits = colliding_segments(mended.trajectory, scenario);
    mended.clear = std::find(hits.begin(), hits.end(), true) == hits.end();
    if (mended.clear) break;
    const int inserted = insert_waypoints(hits, waypoints, durations);
    mended.inserted += inserted;
    if (inserted == 0) break;
  }
  return mended;
}

tern::Trajectory stretched_to_limits(const tern::Trajectory& trajectory, const tern_host::Scenario& scenario) {
  double factor = 0.0;
  for_each_sample(trajectory, kPeakStep, [&](int, const tern::Sample& sample) {
    for (int a = 0; a < 3; ++a) {
      factor = std::max({factor, std::fabs(axis(sample.velocity, a)) / axis(scenario.limits.v_max, a),
                         std::sqrt(std::fabs(axis(sample.acceleration, a)) / axis(scenario.limits.a_max, a))});
    }
  });
  tern::Trajectory slower = trajectory;
  for (int s = 0; s < slower.count; ++s) slower.segments[s].duration *= factor;
  return slower;
}

}  // namespace tern_bench
