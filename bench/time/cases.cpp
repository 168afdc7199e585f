// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "time/cases.hpp"

#include <algorithm>
#include <cmath>

namespace tern_bench {
namespace {

using tern::Vec3;

constexpr double kTurn = 6.283185307179586;
constexpr Vec3 kStart{2.0, 8.0, 3.0};
constexpr Vec3 kGoal{30.0, 8.0, 3.0};
constexpr int kSamples = 2000;

double apart(const Vec3& a, const Vec3& b) {
  return std::hypot(std::hypot(a.x - b.x, a.y - b.y), a.z - b.z);
}

/// The distance of a place from a ball and its error at a time, s.
double gap_at(const tern::Track& ball, const Vec3& place, double time) {
  const Vec3 centre{ball.position.x + time * ball.velocity.x, ball.position.y + time * ball.velocity.y,
                    ball.position.z + time * ball.velocity.z};
  return apart(place, centre) - ball.radius - (ball.error + time * ball.error_speed);
}

/// At a third and at two thirds of the way, and aside.
void add_vias(Reals& reals, TimeCase& made) {
  for (int i = 0; i < 2; ++i) {
    made.vias[i] = tern::Via{};
    made.vias[i].position = {10.0 + 10.0 * i + reals(-2.0, 2.0), reals(3.0, 13.0), reals(1.5, 4.5)};
    made.vias[i].tolerance = 0.3;
  }
  made.vias[1].stop = true;
  made.vias[1].dwell = 1.0;
  made.request.vias = made.vias;
  made.request.via_count = 2;
}

}  // namespace

void build(const TimeFamily& family, Reals& reals, TimeCase& made) {
  const tern::GridSpec spec{{0, 0, 0}, 0.2, {160, 80, 30}, {{0, 0, 0}, {32, 16, 6}}, 0.3, 0};
  made.words.assign(tern::grid_words(spec.dims), 0);
  made.grid.bind(spec, made.words.data(), made.words.size());
  for (int i = 0; i < family.pillars; ++i) {
    const double x = reals(3.5, 28.5);
    const double y = reals(0.0, 16.0);
    made.grid.mark_cylinder({{x, y, 0.0}, reals(0.2, 0.4), 6.0});
  }
  made.grid.inflate();
  made.request = tern::Request{};
  made.request.start.position = kStart;
  made.request.start.velocity = {family.speed, 0.0, 0.0};
  made.request.goal.position = kGoal;
  made.request.limits.v_max = {2.5, 2.5, 1.5};
  made.request.limits.a_max = {4.0, 4.0, 3.0};
  made.request.rest_clear = 1.0;
  made.tracks.clear();
  if (family.has_vias) add_vias(reals, made);
}

void add_things(int count, const tern::Trajectory& alone, Reals& reals, TimeCase& made) {
  const double lasts = tern::duration(alone);
  const double radius = made.grid.spec().radius;
  while (static_cast<int>(made.tracks.size()) < count) {
    const bool is_aimed = made.tracks.size() % 4 == 0;
    const double when = reals(0.5, 1.3 * lasts);
    Vec3 at{reals(0.0, 32.0), reals(0.0, 16.0), reals(0.0, 6.0)};
    if (is_aimed) {
      const Vec3 on = tern::evaluate(alone, std::min(when, lasts)).position;
      at = {on.x + reals(-0.3, 0.3), on.y + reals(-0.3, 0.3), on.z + reals(-0.3, 0.3)};
    }
    const double heading = reals(0.0, kTurn);
    const double speed = reals(0.5, 1.8);
    tern::Track ball;
    ball.velocity = {speed * std::cos(heading), speed * std::sin(heading), reals(-0.3, 0.3)};
    ball.position = {at.x - when * ball.velocity.x, at.y - when * ball.velocity.y, at.z - when * ball.velocity.z};
    ball.radius = 0.3;
    ball.error = 0.05;
    ball.error_speed = 0.02;
    ball.until = 60'000'000'000;
    ball.end = tern::TrackEnd::kGone;
    bool is_near = false;
    for (double time = 0.0; time < 1.0; time += 0.1) {
      const Vec3 place{kStart.x + time * made.request.start.velocity.x, kStart.y, kStart.z};
      is_near = is_near || gap_at(ball, place, time) < radius + 0.4;
    }
    if (!is_near) made.tracks.push_back(ball);
  }
  made.request.tracks = made.tracks.data();
  made.request.track_count = count;
}

double too_near_by(const TimeCase& made, const tern::Trajectory& plan) {
  double worst = -HUGE_VAL;
  const double end = std::min(tern::duration(plan) + made.request.rest_clear, 60.0);
  for (int k = 0; k <= kSamples; ++k) {
    const double time = end * k / kSamples;
    const Vec3 place = tern::evaluate(plan, std::min(time, tern::duration(plan))).position;
    for (const tern::Track& ball : made.tracks) {
      worst = std::max(worst, made.grid.spec().radius - gap_at(ball, place, time));
    }
  }
  return worst;
}

}  // namespace tern_bench
