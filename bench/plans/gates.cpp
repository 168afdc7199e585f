// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "plans/gates.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "support/random.hpp"
#include "tern/planner.hpp"

namespace tern_bench {
namespace {

constexpr int kGates = 10;
constexpr double kSpeed = 5.0;         ///< m/s for each axis
constexpr double kAcceleration = 8.0;  ///< m/s^2 for each axis
constexpr double kNever = 1e9;

using Velocities = std::array<std::array<double, 3>, kGates + 2>;

struct Course {
  std::array<tern::Vec3, kGates + 2> points;  ///< start, gates, goal
};

double part(const tern::Vec3& v, std::size_t axis) {
  return axis == 0 ? v.x : (axis == 1 ? v.y : v.z);
}

Course random_course(tern_test::Random& random) {
  Course course;
  double x = 2.0;
  for (std::size_t i = 0; i < course.points.size(); ++i) {
    const bool is_end = i == 0 || i + 1 == course.points.size();
    course.points[i] = {x, is_end ? 8.0 : 8.0 + random.real(-2.5, 2.5), is_end ? 4.0 : 4.0 + random.real(-1.0, 1.0)};
    x += random.real(3.5, 5.5);
  }
  return course;
}

/// The least time of a point mass on one axis, from one velocity to another; both signs of the first push are tried.
double axis_time(double way, double from, double to) {
  double best = kNever;
  for (const double sign : {1.0, -1.0}) {
    const double d = sign * way;
    const double u = sign * from;
    const double w = sign * to;
    const double square = kAcceleration * d + 0.5 * (u * u + w * w);  // of the highest speed
    if (square < 0.0) continue;
    const double top = std::min(std::sqrt(square), kSpeed);
    if (top < u - 1e-12 || top < w - 1e-12) continue;
    const double ramps = (2.0 * top - u - w) / kAcceleration;
    const double covered = (2.0 * top * top - u * u - w * w) / (2.0 * kAcceleration);
    best = std::min(best, ramps + (top > 0.0 ? std::max(0.0, d - covered) / top : 0.0));
  }
  return best;
}

double leg_time(const Course& course, const Velocities& v, std::size_t leg) {
  double longest = 0.0;
  for (std::size_t a = 0; a < 3; ++a) {
    const double way = part(course.points[leg + 1], a) - part(course.points[leg], a);
    longest = std::max(longest, axis_time(way, v[leg][a], v[leg + 1][a]));
  }
  return longest;
}

double course_time(const Course& course, const Velocities& v) {
  double sum = 0.0;
  for (std::size_t leg = 0; leg + 1 < course.points.size(); ++leg) sum += leg_time(course, v, leg);
  return sum;
}

/// Random steps at one gate, ever smaller, from many random starts.
double point_mass_time(const Course& course, tern_test::Random& random) {
  constexpr int kRestarts = 30;
  constexpr int kSteps = 6000;
  double best = kNever;
  for (int restart = 0; restart < kRestarts; ++restart) {
    Velocities v{};
    for (std::size_t g = 1; g <= kGates; ++g) v[g] = {random.real(1.0, 4.0), random.real(-1.0, 1.0), 0.0};
    double time = course_time(course, v);
    for (int step = 0; step < kSteps; ++step) {
      const auto g = static_cast<std::size_t>(random.integer(1, kGates));
      const double size = 2.0 * std::pow(0.01, static_cast<double>(step) / kSteps);
      const std::array<double, 3> before = v[g];
      for (double& component : v[g]) {
        component = std::clamp(component + size * random.real(-1.0, 1.0), -kSpeed, kSpeed);
      }
      const double now = course_time(course, v);
      if (now < time) {
        time = now;
      } else {
        v[g] = before;
      }
    }
    best = std::min(best, time);
  }
  return best;
}

class Gates {
 public:
  Gates(const Course& course, double time_weight, double tolerance)
      : memory_(new tern::Workspace), planner_(memory_.get(), sizeof *memory_) {
    tern::GridSpec spec{};
    spec.cell = 0.25;
    spec.dims = {256, 64, 32};
    spec.boundary = {{0.0, 0.0, 0.0}, {64.0, 16.0, 8.0}};
    spec.radius = 0.3;
    words_.resize(tern::grid_words(spec.dims));
    grid_.bind(spec, words_.data(), words_.size());
    grid_.inflate();
    request_.start.position = course.points.front();
    request_.goal.position = course.points.back();
    request_.limits.v_max = {kSpeed, kSpeed, kSpeed};
    request_.limits.a_max = {kAcceleration, kAcceleration, kAcceleration};
    request_.time_weight = time_weight;
    for (int g = 0; g < kGates; ++g) {
      vias_[g].position = course.points[static_cast<std::size_t>(g) + 1];
      vias_[g].tolerance = tolerance;
    }
    request_.vias = vias_;
    request_.via_count = kGates;
  }

  double plan() {
    tern::Report report;
    return planner_.plan(grid_, request_, plan_, report) == tern::Status::kOk ? tern::duration(plan_) : 0.0;
  }

  /// Gives all gates the velocities of the last plan, then changes those of one at a time at random, and keeps what is
  /// faster.
  double climb(double best, int rounds, tern_test::Random& random) {
    give_velocities();
    for (int round = 0; round < rounds; ++round) {
      tern::Via& via = vias_[random.integer(0, kGates - 1)];
      const tern::Vec3 before = via.velocity;
      const double size = 1.0 * std::pow(0.05, static_cast<double>(round) / rounds);
      const auto changed = [&](double x) {
        return std::clamp(x + size * random.real(-1.0, 1.0), -0.999 * kSpeed, 0.999 * kSpeed);
      };
      via.velocity = {changed(before.x), changed(before.y), changed(before.z)};
      const double time = plan();
      if (time > 0.0 && time < best) {
        best = time;
      } else {
        via.velocity = before;
      }
    }
    return best;
  }

 private:
  void give_velocities() {
    tern::Report report;
    planner_.plan(grid_, request_, plan_, report);
    for (int g = 0; g < kGates; ++g) {
      const tern::Vec3 v = tern::evaluate(plan_, report.vias[g].time).velocity;
      const auto within = [](double x) { return std::clamp(x, -0.999 * kSpeed, 0.999 * kSpeed); };
      vias_[g].velocity = {within(v.x), within(v.y), within(v.z)};
      vias_[g].has_velocity = true;
    }
  }

  std::unique_ptr<tern::Workspace> memory_;
  tern::Planner planner_;
  std::vector<std::uint64_t> words_;
  tern::Grid grid_;
  tern::Request request_{};
  tern::Via vias_[kGates];
  tern::Trajectory plan_{};
};

}  // namespace

GateTimes fly_gates(std::uint64_t seed, double time_weight, double tolerance, int rounds) {
  tern_test::Random random(seed);
  const Course course = random_course(random);
  const auto gates = std::make_unique<Gates>(course, time_weight, tolerance);
  GateTimes times;
  times.planned = gates->plan();
  if (times.planned > 0.0) times.climbed = gates->climb(times.planned, rounds, random);
  times.point_mass = point_mass_time(course, random);
  return times;
}

}  // namespace tern_bench
