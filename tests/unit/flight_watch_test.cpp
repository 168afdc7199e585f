// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What holds flights to their invariants must notice where one does not hold.
#include "host/flight/flight_watch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "host/flight/frame_watch.hpp"
#include "host/flight/full_knowledge.hpp"
#include "host/flight/yaw_watch.hpp"

namespace {

using tern_host::DepthFrame;
using tern_host::FlightWorld;
using tern_host::FrameWatch;

constexpr std::int64_t kTick = 10000000;

/// A room with a flight in it that knows all of it, and a watch that may be told something else.
struct Watched {
  Watched() : memory(new tern::Workspace), planner(memory.get(), sizeof *memory) {
    world.boundary = {{-2.0, -5.0, 0.0}, {12.0, 5.0, 4.0}};
    world.start = {0.0, 0.0, 1.5};
    world.goal = {8.0, 0.0, 1.5};
    spec = tern::flight_spec(limits_of(world.settings));
    map_spec = tern::map_spec({-4.0, -7.0, -1.0}, 0.2, {128, 70, 30}, radius_of(world.settings));
    map_words.resize(tern::map_words(map_spec));
    EXPECT_EQ(map.bind(map_spec, map_words.data(), map_words.size()), tern::Status::kOk);
    map.assume_free({4.0, 0.0, 2.0}, 30.0);
    words.resize(tern::flight_words(map_spec.dims));
    EXPECT_EQ(flight.start(spec, map, planner, words.data(), words.size(), world.start, 0), tern::Status::kOk);
    flight.set_goal(world.goal);
  }

  /// What the watch says of a second of this flight.
  std::string watch() {
    tern_host::FlightWatch watch(world, spec, map, flight);
    tern::FlightReport report{};
    for (std::int64_t t = 0; t < 100 * kTick; t += kTick) {
      flight.tick(t, report);
      watch.look(t, report);
    }
    EXPECT_GT(watch.counts().commits, 0u);
    return watch.broken();
  }

  FlightWorld world;
  tern::FlightSpec spec{};
  tern::MapSpec map_spec{};
  std::vector<std::uint64_t> map_words, words;
  std::unique_ptr<tern::Workspace> memory;
  tern::Planner planner;
  tern::RollingMap map;
  tern::Flight flight;
};

TEST(FlightWatch, IsContentWithASoundFlight) {
  EXPECT_EQ(Watched().watch(), "");
}

TEST(FlightWatch, NoticesLimits) {
  Watched w;
  w.spec.limits.v_horizontal = 1.0;
  EXPECT_NE(w.watch().find("invariant 2"), std::string::npos);
}

TEST(FlightWatch, NoticesWork) {
  Watched w;
  w.spec.work_per_tick = 200;
  EXPECT_NE(w.watch().find("invariant 7"), std::string::npos);
}

/// A thing in the true world that the map calls free.
TEST(FlightWatch, NoticesWhatTheMapDoesNotShow) {
  Watched w;
  w.world.cylinders.push_back({4.0, 0.3, 0.0, 4.0, 0.1});
  EXPECT_NE(w.watch().find("too near to the true world"), std::string::npos);
}

/// A fence that the flight was not told of.
TEST(FlightWatch, NoticesFences) {
  Watched w;
  tern_host::add_fence({"keepout", "3", "0.3", "0", "4", "1", "4"}, {"", 0}, w.world.fences);
  EXPECT_NE(w.watch().find("into a fence"), std::string::npos);
}

/// A map that turns solid behind the flight's back.
TEST(FlightWatch, NoticesPlansThroughUnprovenSpace) {
  Watched w;
  Watched solid;
  solid.map.mark_box({{3.0, -3.0, 0.0}, {4.0, 3.0, 4.0}});
  tern_host::FlightWatch watch(w.world, w.spec, solid.map, w.flight);
  tern::FlightReport report{};
  for (std::int64_t t = 0; t < 100 * kTick; t += kTick) {
    w.flight.tick(t, report);
    watch.look(t, report);
  }
  EXPECT_NE(watch.broken().find("too near to unproven space"), std::string::npos) << watch.broken();
}

/// A flight that is ticked behind the watch's back commits what it does not report.
TEST(FlightWatch, NoticesCommandsThatChangeWithoutACommit) {
  Watched w;
  tern_host::FlightWatch watch(w.world, w.spec, w.map, w.flight);
  tern::FlightReport report{};
  for (std::int64_t t = 0; t < 100 * kTick; t += kTick) {
    w.flight.tick(t, report);
    report.committed = 0;
    watch.look(t, report);
  }
  EXPECT_NE(watch.broken().find("without a commit"), std::string::npos) << watch.broken();
}

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
  sample.angle = std::remainder(angle, 2.0 * M_PI);
  sample.yaw.rate = rate * settings.yaw_acceleration * u;
  sample.acceleration = s < ramp ? acceleration * settings.yaw_acceleration : 0.0;
  return sample;
}

TEST(YawWatch, TellsAYawAtItsLimitsFromOneBeyondThem) {
  EXPECT_EQ(watched_yaw([](std::int64_t t) { return turning(t, 1.0, 1.0); }), "");
  EXPECT_NE(watched_yaw([](std::int64_t t) { return turning(t, 1.0, 1.001); }).find("beyond its limits"),
            std::string::npos);
  EXPECT_NE(watched_yaw([](std::int64_t t) { return turning(t, 1.001, 1.0); }).find("a step"), std::string::npos);
  EXPECT_NE(watched_yaw([](std::int64_t t) {
              tern::YawSample sample = turning(t, 1.0, 1.0);
              if (t > 200000000) sample.angle += 1e-3;
              return sample;
            }).find("a step"),
            std::string::npos);
}

/// One frame of a room, entered into a map that knows nothing, or all; the watch is shown `then` in its place.
std::string after_frame(Watched& w, bool known, const DepthFrame& shown, const DepthFrame& then) {
  FrameWatch watch(w.world, w.map_spec, w.map);
  for (int k = 0; k < 20; ++k) {
    w.map.bind(w.map_spec, w.map_words.data(), w.map_words.size());
    if (known) w.map.assume_free({4.0, 0.0, 2.0}, 30.0);
    watch.before(shown);
    EXPECT_EQ(w.map.begin_frame(shown.view, shown.pose, k), tern::Status::kRunning);
    while (w.map.step(100000) == tern::Status::kRunning) {
    }
    watch.after(then);
  }
  EXPECT_GT(watch.seen() + watch.hits(), 0u);
  return watch.broken();
}

DepthFrame frame_of(const FlightWorld& world) {
  tern_host::Noise noise(1);
  return take_frame(world, world.start, 0.0, 0, noise);
}

void scale(DepthFrame& frame, float by) {
  for (float& depth : frame.depths) depth *= by;
}

TEST(FrameWatch, IsContentWithASoundMap) {
  Watched w;
  const DepthFrame frame = frame_of(w.world);
  EXPECT_EQ(after_frame(w, false, frame, frame), "");
}

TEST(FrameWatch, NoticesVoxelsThatWereNotSeenWhole) {
  Watched w;
  const DepthFrame frame = frame_of(w.world);
  DepthFrame nearer = frame_of(w.world);
  scale(nearer, 0.5f);
  EXPECT_NE(after_frame(w, false, frame, nearer).find("not seen whole"), std::string::npos);
}

TEST(FrameWatch, NoticesHitsThatStayFree) {
  Watched w;
  DepthFrame farther = frame_of(w.world);
  scale(farther, 1.6f);
  const DepthFrame frame = frame_of(w.world);
  EXPECT_NE(after_frame(w, true, farther, frame).find("was hit and is free"), std::string::npos);
}

}  // namespace
