// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What holds flights to their invariants must notice where one does not hold.
#include "host/flight/flight_watch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
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

  /// What the watch says of a second of this flight, whose reports and commands a test may alter.
  std::string watch() {
    tern_host::FlownCommands commands = tern_host::commands_of(flight);
    if (alter) {
      commands.at = [this](std::int64_t t) { return alter(flight.command(t).sample, t, now); };
    }
    tern_host::FlightWatch watch(world, spec, map, commands);
    tern::FlightReport report{};
    for (now = 0; now < 100 * kTick; now += kTick) {
      watch.before(now);
      flight.tick(now, report);
      if (alter_report) alter_report(report);
      watch.look(now, report);
      if (after_tick) after_tick();
    }
    commits = watch.counts().commits;
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
  std::int64_t now = 0;
  std::uint64_t commits = 0;  ///< that the watch saw
  /// A command at time t, as it is after the tick at `now`.
  std::function<tern::Sample(tern::Sample, std::int64_t t, std::int64_t now)> alter;
  std::function<void(tern::FlightReport&)> alter_report;
  std::function<void()> after_tick;
};

testing::AssertionResult says(const std::string& broken, const std::string& wanted) {
  if (broken.find(wanted) != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "\"" << broken << "\" does not say \"" << wanted << '"';
}

TEST(FlightWatch, IsContentWithASoundFlight) {
  Watched w;
  EXPECT_EQ(w.watch(), "");
  EXPECT_GT(w.commits, 0u);
}

// Invariant 1: commands come from one plan, which is smooth and ends at rest.

/// A flight that is ticked behind the watch's back commits what it does not report.
TEST(FlightWatch, NoticesCommandsThatChangeWithoutACommit) {
  Watched w;
  w.alter_report = [](tern::FlightReport& report) { report.committed = 0; };
  EXPECT_TRUE(says(w.watch(), "invariant 1"));
}

/// One bit of one command, wherever in the plan, from 0.4 s on; nothing is committed from then on.
TEST(FlightWatch, NoticesOneCommandThatChangesFarAhead) {
  for (const std::int64_t changed : {60, 77, 98, 131, 160}) {
    Watched w;
    const auto commands = [&w, changed](std::int64_t t) {
      tern::Sample sample = w.flight.command(t).sample;
      if (w.now >= 40 * kTick && t == changed * kTick) sample.jerk.y += 1e-12;
      return sample;
    };
    tern_host::FlightWatch watch(w.world, w.spec, w.map, {commands, [&w] { return w.flight.rest_position(); }});
    tern::FlightReport report{};
    for (w.now = 0; w.now < 60 * kTick; w.now += kTick) {
      watch.before(w.now);
      if (w.now < 40 * kTick) w.flight.tick(w.now, report);
      watch.look(w.now, report);
    }
    EXPECT_TRUE(says(watch.broken(), "commands changed without a commit")) << changed;
  }
}

TEST(FlightWatch, NoticesNumbersThatAreNone) {
  Watched w;
  w.alter = [](tern::Sample sample, std::int64_t t, std::int64_t) {
    if (t == 30 * kTick) sample.snap.z = NAN;
    return sample;
  };
  EXPECT_TRUE(says(w.watch(), "not finite"));
}

TEST(FlightWatch, NoticesAPlanThatDoesNotEndAtRest) {
  Watched w;
  w.alter = [&w](tern::Sample sample, std::int64_t, std::int64_t) {
    const tern::Vec3 end = w.flight.rest_position();
    if (sample.position.x == end.x && end.x > 0.1) sample.velocity.x = 1e-3;
    return sample;
  };
  EXPECT_TRUE(says(w.watch(), "does not end at rest"));
}

/// For 0.2 s from 3.3 ms behind a tick on, a derivative is a little more than it was.
std::string after_step(const tern::Sample& step) {
  Watched w;
  w.alter = [&step](tern::Sample sample, std::int64_t t, std::int64_t) {
    if (t < 303300000 || t > 503300000) return sample;
    sample.position.x += step.position.x;
    sample.velocity.y += step.velocity.y;
    sample.acceleration.z += step.acceleration.z;
    sample.jerk.x += step.jerk.x;
    return sample;
  };
  return w.watch();
}

TEST(FlightWatch, NoticesStepsInThePlan) {
  EXPECT_EQ(after_step({}), "");
  tern::Sample step{};
  step.position.x = 1e-10;
  EXPECT_TRUE(says(after_step(step), "is not smooth"));
  step = {};
  step.velocity.y = 1e-8;
  EXPECT_TRUE(says(after_step(step), "is not smooth"));
  step = {};
  step.acceleration.z = 1e-5;
  EXPECT_TRUE(says(after_step(step), "is not smooth"));
  step = {};
  step.jerk.x = 0.05;
  EXPECT_TRUE(says(after_step(step), "is not smooth"));
}

// Invariant 2: what is committed is proven, and keeps the limits.

TEST(FlightWatch, NoticesLimits) {
  Watched w;
  w.spec.limits.v_horizontal = 1.0;
  EXPECT_TRUE(says(w.watch(), "invariant 2"));
}

/// Brakes under a threat need not be proven clear, but they keep the limits.
TEST(FlightWatch, NoticesLimitsUnderAThreat) {
  Watched w;
  w.spec.limits.a_horizontal = 3.0;
  w.alter_report = [](tern::FlightReport& report) { report.mode = tern::FlightMode::kThreat; };
  EXPECT_TRUE(says(w.watch(), "accelerates beyond its limit"));
}

/// A map that turns solid behind the flight's back.
TEST(FlightWatch, NoticesPlansThroughUnprovenSpace) {
  Watched w;
  Watched solid;
  solid.map.mark_box({{3.0, -3.0, 0.0}, {4.0, 3.0, 4.0}});
  tern_host::FlightWatch watch(w.world, w.spec, solid.map, tern_host::commands_of(w.flight));
  tern::FlightReport report{};
  for (std::int64_t t = 0; t < 100 * kTick; t += kTick) {
    watch.before(t);
    w.flight.tick(t, report);
    watch.look(t, report);
  }
  EXPECT_TRUE(says(watch.broken(), "too near to unproven space"));
}

/// A fence that the flight was not told of.
TEST(FlightWatch, NoticesFences) {
  Watched w;
  tern_host::add_fence({"keepout", "3", "0.3", "0", "4", "1", "4"}, {"", 0}, w.world.fences);
  EXPECT_TRUE(says(w.watch(), "into a fence"));
}

// Invariant 3: both sides of a takeover agree, at every tick up to the latest one.

TEST(FlightWatch, NoticesJointsThatJump) {
  for (const std::int64_t joint : {15, 40, 66}) {
    Watched w;
    w.alter = [joint](tern::Sample sample, std::int64_t t, std::int64_t) {
      if (t >= joint * kTick && t < 100 * kTick) sample.velocity.x += 1e-9;
      return sample;
    };
    EXPECT_TRUE(says(w.watch(), "invariant 3")) << joint;
  }
}

TEST(FlightWatch, NoticesSnapWithoutBound) {
  Watched w;
  w.alter = [](tern::Sample sample, std::int64_t t, std::int64_t) {
    if (t == 50 * kTick) sample.snap.x = 1e9;
    return sample;
  };
  EXPECT_TRUE(says(w.watch(), "invariant 3"));
}

// Invariant 4: a commit changes nothing before the next tick.

TEST(FlightWatch, NoticesCommitsThatTakeOverTooEarly) {
  for (const std::int64_t late : {0, 4, 9}) {
    Watched w;
    int committed = 0;
    w.alter_report = [&committed](tern::FlightReport& report) { committed = static_cast<int>(report.committed); };
    w.alter = [&committed, late](tern::Sample sample, std::int64_t t, std::int64_t now) {
      if (committed >= 2 && t >= now + late * kTick / 10) sample.position.y += 1e-10;
      return sample;
    };
    EXPECT_TRUE(says(w.watch(), "invariant 4")) << late;
  }
}

// Invariant 5: the window holds what is flown.

TEST(FlightWatch, NoticesAWindowThatCutsThePlan) {
  Watched w;
  Watched other;
  tern_host::FlightWatch watch(w.world, w.spec, other.map, tern_host::commands_of(w.flight));
  tern::FlightReport report{};
  for (std::int64_t t = 0; t < 100 * kTick; t += kTick) {
    watch.before(t);
    w.flight.tick(t, report);
    watch.look(t, report);
    if (t != 50 * kTick) continue;
    EXPECT_EQ(watch.broken(), "");
    other.map.follow({30.0, 0.0, 2.0});
    while (other.map.step(100000) == tern::Status::kRunning) {
    }
  }
  EXPECT_TRUE(says(watch.broken(), "invariant 5"));
}

// Invariant 6: free means seen, so that what is committed is clear of the true world. Frames have tests of their own.

/// A thing in the true world that the map calls free.
TEST(FlightWatch, NoticesWhatTheMapDoesNotShow) {
  Watched w;
  w.world.cylinders.push_back({4.0, 0.3, 0.0, 4.0, 0.1});
  EXPECT_TRUE(says(w.watch(), "too near to the true world"));
}

/// So near to the way that only some millimetres of it are too near.
TEST(FlightWatch, NoticesWhatIsTooNearForAMoment) {
  Watched w;
  const double kept = w.world.settings.body_radius + w.world.settings.tracking_margin;
  w.world.cylinders.push_back({4.0, kept + 0.1 - 2e-6, 0.0, 4.0, 0.1});
  EXPECT_TRUE(says(w.watch(), "too near to the true world"));
  Watched clear;
  clear.world.cylinders.push_back({4.0, kept + 0.1, 0.0, 4.0, 0.1});
  EXPECT_EQ(clear.watch(), "");
}

// Invariant 7: a tick's work is bounded, and reports tell no nonsense.

TEST(FlightWatch, NoticesWork) {
  Watched w;
  w.spec.work_per_tick = 200;
  EXPECT_TRUE(says(w.watch(), "invariant 7"));
}

TEST(FlightWatch, NoticesCountsThatFall) {
  Watched w;
  w.alter_report = [&w](tern::FlightReport& report) {
    if (w.now == 50 * kTick) report.asked = 0;
  };
  EXPECT_TRUE(says(w.watch(), "invariant 7"));
}

TEST(FlightWatch, NoticesContactsWithoutAThreat) {
  Watched w;
  w.alter_report = [](tern::FlightReport& report) { report.contact_speed = 1.0; };
  EXPECT_TRUE(says(w.watch(), "invariant 7"));
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

/// Frames of a room, entered one after the other into a map that knows nothing, or all; the watch is shown `then` in
/// the place of each.
struct FrameCase {
  bool known = false;
  int frames = 1;
  DepthFrame shown, then;
};

std::string after_frames(Watched& w, const FrameCase& c) {
  std::uint64_t looked_at = 0;
  std::int64_t t = 0;
  for (int k = 0; k < 20; ++k) {
    FrameWatch watch(w.world, w.map_spec, w.map);
    w.map.bind(w.map_spec, w.map_words.data(), w.map_words.size());
    if (c.known) w.map.assume_free({4.0, 0.0, 2.0}, 30.0);
    for (int frame = 0; frame < c.frames; ++frame) {
      watch.before(c.shown);
      EXPECT_EQ(w.map.begin_frame(c.shown.view, c.shown.pose, t++), tern::Status::kRunning);
      while (w.map.step(100000) == tern::Status::kRunning) {
      }
      watch.after(c.then);
    }
    looked_at += watch.seen() + watch.hits();
    if (!watch.broken().empty()) return watch.broken();
  }
  EXPECT_GT(looked_at, 0u);
  return "";
}

DepthFrame frame_of(const FlightWorld& world, double farther = 1.0) {
  tern_host::Noise noise(1);
  DepthFrame frame = take_frame(world, world.start, 0.0, 0, noise);
  for (float& depth : frame.depths) depth *= static_cast<float>(farther);
  return frame;
}

TEST(FrameWatch, IsContentWithASoundMap) {
  Watched w;
  EXPECT_EQ(after_frames(w, {false, 1, frame_of(w.world), frame_of(w.world)}), "");
}

TEST(FrameWatch, NoticesVoxelsThatWereNotSeenWhole) {
  Watched w;
  EXPECT_TRUE(says(after_frames(w, {false, 1, frame_of(w.world), frame_of(w.world, 0.5)}), "not seen whole"));
}

TEST(FrameWatch, NoticesHitsThatStayFree) {
  Watched w;
  EXPECT_TRUE(says(after_frames(w, {true, 1, frame_of(w.world, 1.6), frame_of(w.world)}), "was hit and is free"));
}

/// Where several hits make an obstacle, that many frames do, and fewer need not.
TEST(FrameWatch, CountsHits) {
  Watched w;
  w.map_spec.hits = 3;
  w.map_spec.support = 2;
  EXPECT_EQ(after_frames(w, {true, 3, frame_of(w.world), frame_of(w.world)}), "");
  EXPECT_TRUE(says(after_frames(w, {true, 3, frame_of(w.world, 1.6), frame_of(w.world)}), "was hit and is free"));
}

/// A map that needs more hits than the watch was told.
TEST(FrameWatch, NoticesAVoxelThatNeedsMoreHits) {
  Watched w;
  tern::MapSpec told = w.map_spec;
  told.hits = 2;
  w.map_spec.hits = 3;
  std::swap(told, w.map_spec);
  FrameWatch watch(w.world, w.map_spec, w.map);
  w.map.bind(told, w.map_words.data(), w.map_words.size());
  w.map.assume_free({4.0, 0.0, 2.0}, 30.0);
  const DepthFrame frame = frame_of(w.world);
  for (int k = 0; k < 2; ++k) {
    watch.before(frame);
    EXPECT_EQ(w.map.begin_frame(frame.view, frame.pose, k), tern::Status::kRunning);
    while (w.map.step(100000) == tern::Status::kRunning) {
    }
    watch.after(frame);
  }
  EXPECT_TRUE(says(watch.broken(), "was hit and is free"));
}

/// A pixel whose neighbours are all elsewhere hits nothing, and so need not.
TEST(FrameWatch, LeavesLonePixelsOut) {
  Watched w;
  w.map_spec.support = 1;
  DepthFrame lone = frame_of(w.world);
  for (std::size_t k = 0; k < lone.depths.size(); ++k) {
    lone.depths[k] = static_cast<float>(2.0 + 0.5 * static_cast<double>((k % 2 + 2 * (k / 160 % 2))));
  }
  lone.view.z32 = lone.depths.data();
  FrameWatch watch(w.world, w.map_spec, w.map);
  watch.before(lone);
  watch.after(lone);
  EXPECT_EQ(watch.hits(), 0u);
}

}  // namespace
