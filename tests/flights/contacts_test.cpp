// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Something appears in the tube, too near to brake for or not. The contact is no faster than after an immediate brake,
// and the report says when it comes and how fast it is.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "support/flights.hpp"
#include "support/reference_brake.hpp"

namespace {

using namespace tern;
using tern_test::fast;
using tern_test::FlightSettings;
using tern_test::Flown;
using tern_test::Random;
using tern_test::ReferenceBrake;
using tern_test::Scene;
using tern_test::size;

constexpr double kStep = 0.001;  ///< of samples, seconds
/// With so few units a tick, the first brake is flown that is judged, and not the best of them.
constexpr std::uint32_t kFewUnits = 1000;
constexpr double kFasterWithFewUnits = 0.06;  ///< m/s
constexpr double kFaster = 0.02;              ///< m/s, than the reference, whose brakes and samples are others

/// The first instant that is nearer to what the map holds than the radius. Speed 0: there is none.
struct Met {
  std::int64_t time = 0;
  double speed = 0.0;
  bool is_contact() const { return speed > 0.0; }
};

/// The voxels that are not known to be free at one time. The window may slide later, and shows nothing meanwhile.
class Solid {
 public:
  explicit Solid(const Flown& flown) : grid_(flown.owned.map.safe().spec()), radius_(flown.settings.radius) {
    EXPECT_TRUE(flown.owned.map.safe().bound());
    for (int z = 0; z < grid_.dims.z; ++z) {
      for (int y = 0; y < grid_.dims.y; ++y) {
        for (int x = 0; x < grid_.dims.x; ++x) solid_.push_back(flown.owned.map.safe().obstacle({x, y, z}));
      }
    }
  }
  /// Nearer than the radius.
  bool touches(const Vec3& p) const {
    const double q[3] = {(p.x - grid_.origin.x) / grid_.cell, (p.y - grid_.origin.y) / grid_.cell,
                         (p.z - grid_.origin.z) / grid_.cell};
    const double most = (radius_ - 1e-6) / grid_.cell;
    for (int z = first(q[2], most); z <= last(q[2], most, grid_.dims.z); ++z) {
      for (int y = first(q[1], most); y <= last(q[1], most, grid_.dims.y); ++y) {
        for (int x = first(q[0], most); x <= last(q[0], most, grid_.dims.x); ++x) {
          const std::size_t number = static_cast<std::size_t>((z * grid_.dims.y + y) * grid_.dims.x + x);
          if (solid_[number] && size({gap(q[0], x), gap(q[1], y), gap(q[2], z)}) < most) return true;
        }
      }
    }
    return false;
  }

 private:
  static int first(double q, double most) { return std::max(0, static_cast<int>(std::floor(q - most))); }
  static int last(double q, double most, int dims) {
    return std::min(dims - 1, static_cast<int>(std::floor(q + most)));
  }
  static double gap(double q, int voxel) { return std::max({voxel - q, q - voxel - 1.0, 0.0}); }

  GridSpec grid_;
  double radius_;
  std::vector<bool> solid_;
};

/// Ticks from a threat to its brake: three, and more where their work is too little for a brake.
int lead_of(std::uint32_t work_per_tick) {
  return std::max(3, 1 + static_cast<int>(std::ceil(900.0 / (0.75 * work_per_tick))));
}

/// What is flown from now on until a brake may begin, before a tick changes it.
struct Ahead {
  std::int64_t time;
  std::vector<Sample> samples;

  Ahead(const Flown& flown, int ticks) : time(flown.time) {
    for (std::int64_t t = time; t <= time + ticks * flown.spec.tick; t += 1000000) {
      samples.push_back(flown.flight.command(t).sample);
    }
  }
};

/// If all of that is flown, and then the best of the reference's brakes.
Met immediate_brake(const Solid& solid, const Limits& limits, const Ahead& ahead) {
  std::int64_t time = ahead.time;
  for (const Sample& s : ahead.samples) {
    if (solid.touches(s.position)) return {time, size(s.velocity)};
    time += 1000000;
  }
  time -= 1000000;
  Met best{0, 1e9};
  for (const ReferenceBrake& brake : tern_test::reference_brakes(ahead.samples.back(), limits)) {
    Met met;
    for (double t = 0.0; t < brake.duration() && !met.is_contact(); t += kStep) {
      const Sample s = brake.at(t);
      if (solid.touches(s.position)) met = {time + static_cast<std::int64_t>(1e9 * t), size(s.velocity)};
    }
    if (met.speed < best.speed) best = met;
  }
  return best;
}

/// The same of the commands up to the next tick.
Met contact_before_tick(const Solid& solid, const Flown& flown) {
  for (std::int64_t t = flown.time; t < flown.time + flown.spec.tick; t += 1000000) {
    const Sample s = flown.flight.command(t).sample;
    if (solid.touches(s.position)) return {t, size(s.velocity)};
  }
  return {};
}

struct Count {
  int threats = 0;
  int hard = 0;    ///< where even an immediate brake touches something
  int missed = 0;  ///< brakes that were not ready before the skipped ticks
};

std::string story(int k, const Flown& flown, const Met& met, const Met& brake, const FlightReport& said) {
  char text[300];
  std::snprintf(text, sizeof text,
                "case %d, jerk %.0f, %u units: %.3f m/s at %.3f s; by an immediate brake %.3f at %.3f; reported %.3f "
                "at %.3f, mode %d",
                k, flown.settings.jerk, flown.spec.work_per_tick, met.speed, 1e-9 * static_cast<double>(met.time),
                brake.speed, 1e-9 * static_cast<double>(brake.time), said.contact_speed,
                1e-9 * static_cast<double>(said.contact_time), static_cast<int>(said.mode));
  return text;
}

/// On with the map as it is, until the contact or to rest. The tick of the threat is past.
void fly_into(int k, Flown& flown, const Ahead& ahead, Count& count) {
  flown.frames = false;
  const Solid solid(flown);
  const Met brake = immediate_brake(solid, flown.spec.limits, ahead);
  if (brake.is_contact() && brake.time < ahead.time + flown.spec.tick) return;  // there is nothing left to do
  const std::uint32_t dropped = flown.report.dropped;
  FlightReport said = flown.report;
  Met met = contact_before_tick(solid, flown);
  for (int t = 0; t < 400 && !met.is_contact() && !testing::Test::HasFatalFailure(); ++t) {
    flown.tick();
    said = flown.report;
    met = contact_before_tick(solid, flown);
  }
  ++count.threats;
  count.hard += brake.is_contact() ? 1 : 0;
  count.missed += flown.report.dropped > dropped ? 1 : 0;
  const double faster = flown.spec.work_per_tick < kFewUnits ? kFasterWithFewUnits : kFaster;
  EXPECT_LE(met.speed, brake.speed + faster) << story(k, flown, met, brake, said);
  if (!met.is_contact()) return;
  EXPECT_EQ(said.mode, FlightMode::kThreat) << story(k, flown, met, brake, said);
  EXPECT_NEAR(said.contact_speed, met.speed, kFaster) << story(k, flown, met, brake, said);
  EXPECT_NEAR(1e-9 * static_cast<double>(said.contact_time - met.time), 0.0, 2.0 * kStep)
      << story(k, flown, met, brake, said);
}

/// Ticks until a threat is found. True where one was; `ahead` is what was flown before that tick.
bool find_threat(Flown& flown, Ahead& ahead) {
  const int lead = lead_of(flown.spec.work_per_tick);
  for (int t = 0; t < 100 && !testing::Test::HasFatalFailure(); ++t) {
    ahead = Ahead(flown, lead);
    flown.tick();
    if (flown.report.mode == FlightMode::kThreat) return true;
  }
  return false;
}

/// On the way along x, so long that all speeds occur.
void take_off(Flown& flown, Random& random) {
  flown.flight.set_goal({40.0, random.real(-3.0, 3.0), 1.5});
  const std::int64_t before = flown.time + 20000000000;
  while (flown.time < before && size(flown.flight.command(flown.time).sample.velocity) < 0.1) flown.tick();
  flown.fly(random.real(0.3, 2.0));
  flown.may_touch = true;
}

/// A cylinder appears before the camera. From the tick of the threat on, ticks are skipped: as if the tick after those
/// were the first.
void meet(int k, const FlightSettings& settings, int skipped, Count& count) {
  Random random(static_cast<std::uint64_t>(1200 + k));
  FlightSettings chosen = settings;
  chosen.v = random.real(2.0, 8.0);
  Flown flown(Scene{}, chosen);
  take_off(flown, random);
  const Vec3 p = flown.position();
  const Vec3 v = flown.flight.command(flown.time).sample.velocity;
  const double ahead = random.real(0.8, 4.0) / size(v);
  flown.scene.cylinders.push_back({p.x + ahead * v.x, p.y + ahead * v.y + random.real(-0.3, 0.3), 0.3, 5.0});
  Ahead flies(flown, 0);
  if (!find_threat(flown, flies)) return;
  EXPECT_GE(flown.report.contact_time, flown.time - flown.spec.tick);
  flown.skip(skipped);
  if (skipped > 0) flies = Ahead(flown, lead_of(settings.work_per_tick));
  fly_into(k, flown, flies, count);
}

/// Voxels become solid, in a box or a wall that is near, wide or far, and nothing is seen from then on.
void block(int k, const FlightSettings& settings, Count& count) {
  Random random(static_cast<std::uint64_t>(1600 + k));
  FlightSettings chosen = settings;
  chosen.v = random.real(2.0, 8.0);
  chosen.assumed = 12.0;
  chosen.window = {192, 64, 16};
  Flown flown(Scene{}, chosen);
  take_off(flown, random);
  const Vec3 p = flown.position();
  const Vec3 v = flown.flight.command(flown.time).sample.velocity;
  if (size(v) < 0.3) return;
  const double ahead = random.real(0.6, 4.0) / size(v);
  const Vec3 at{p.x + ahead * v.x, p.y + ahead * v.y + random.real(-0.5, 0.5), 1.5};
  const double wide = k % 3 == 0 ? 3.0 : random.real(0.1, 0.5);
  while (flown.owned.map.busy() || !flown.owned.map.safe().bound()) flown.tick();
  flown.frames = false;
  EXPECT_EQ(flown.owned.map.mark_box({{at.x, at.y - wide, -0.2}, {at.x + 0.3, at.y + wide, 2.5}}), Status::kOk);
  Ahead flies(flown, 0);
  if (find_threat(flown, flies)) fly_into(k, flown, flies, count);
}

TEST(FlightContacts, NoFasterThanByAnImmediateBrake) {
  for (const double jerk : {0.0, 30.0}) {
    FlightSettings settings = fast();
    settings.jerk = jerk;
    Count count;
    for (int k = 0; k < tern_test::scaled(40) && !HasFatalFailure(); ++k) meet(k, settings, 0, count);
    EXPECT_GT(count.threats, tern_test::scaled(40) / 4);
    EXPECT_GT(count.hard, tern_test::scaled(40) / 13);
  }
}

TEST(FlightContacts, NoFasterThanByAnImmediateBrakeWithLittleWork) {
  for (const double jerk : {0.0, 30.0}) {
    for (const std::uint32_t work : {256u, 400u, 1000u, 4000u}) {
      FlightSettings settings = fast();
      settings.jerk = jerk;
      settings.work_per_tick = work;
      Count count;
      const int blocks = std::max(20, tern_test::scaled(60));
      for (int k = 0; k < blocks; ++k) block(k, settings, count);
      EXPECT_GT(count.threats, blocks / 4) << work;
      EXPECT_GT(count.hard, blocks / 13) << work;
    }
  }
}

/// A brake that was ready, but too late, is tried again.
TEST(FlightContacts, TicksSkippedUnderAThreatOnlyDelayTheBrake) {
  FlightSettings settings = fast();
  settings.work_per_tick = 2000;
  Count count;
  for (int k = 0; k < tern_test::scaled(40) && !HasFatalFailure(); ++k) meet(k, settings, 3 + k % 6, count);
  EXPECT_GT(count.threats, tern_test::scaled(40) / 4);
  EXPECT_GT(count.missed, tern_test::scaled(40) / 13);
}

}  // namespace
