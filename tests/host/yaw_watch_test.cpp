// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The watch of the yaw must notice a nose that turns faster than it may, or jumps.
#include "host/flight/yaw_watch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "host/flight/flight_world.hpp"

namespace {

/// A nose that turns by this law from the tick at 0.1 s on, watched for 0.3 s at 60 ticks a second.
std::string watched_yaw(const tern_host::YawWatch::Yaw& yaw) {
  const tern_host::FlightSettings settings;
  constexpr std::int64_t kSixtieth = 16666667;
  tern_host::YawWatch watch(settings, kSixtieth, yaw);
  for (std::int64_t t = 0; t < 18 * kSixtieth; t += kSixtieth) watch.look(t);
  return watch.broken();
}

/// At the limit of its rate and of its acceleration, and one part in a thousand beyond.
tern::YawSample turning(std::int64_t t, double rate, double acceleration) {
  const tern_host::FlightSettings settings;
  const double s = 1e-9 * static_cast<double>(t);
  const double limit = settings.yaw_rate;
  const double ramp = limit / settings.yaw_acceleration;
  const double u = std::min(s, ramp);
  const double angle = 0.5 * settings.yaw_acceleration * u * u + limit * (s - u);
  tern::YawSample sample{};
  sample.angle = angle;
  sample.yaw.rate = rate * settings.yaw_acceleration * u;
  sample.acceleration = s < ramp ? acceleration * settings.yaw_acceleration : 0.0;
  return sample;
}

TEST(YawWatch, TellsAYawAtItsLimitsFromOneBeyondThem) {
  EXPECT_EQ(watched_yaw([](std::int64_t t) { return turning(t, 1.0, 1.0); }), "");
  EXPECT_NE(watched_yaw([](std::int64_t t) { return turning(t, 1.0, 1.001); }).find("beyond its limits"),
            std::string::npos);
  EXPECT_NE(watched_yaw([](std::int64_t t) { return turning(t, 1.001, 1.0); }).find("a step"), std::string::npos);
  // A whole turn is a step, too: the angle counts turns.
  EXPECT_NE(watched_yaw([](std::int64_t t) {
              tern::YawSample sample = turning(t, 1.0, 1.0);
              if (t > 200000000) sample.angle += 2.0 * M_PI;
              return sample;
            }).find("a step"),
            std::string::npos);
  EXPECT_NE(watched_yaw([](std::int64_t t) {
              tern::YawSample sample = turning(t, 1.0, 1.0);
              if (t > 200000000) sample.angle += 1e-3;
              return sample;
            }).find("a step"),
            std::string::npos);
}

}  // namespace
