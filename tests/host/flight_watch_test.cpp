// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What holds flights to their invariants must notice where one does not hold.
#include "host/flight/flight_watch.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "host/flight/full_knowledge.hpp"
#include "support/watched_room.hpp"

namespace {

using tern_test::says;

constexpr std::int64_t kTick = 10000000;

/// A flight in the room, and a watch that may be told something else.
struct Watched : tern_test::WatchedRoom {
  Watched() : memory(new tern::Workspace), planner(memory.get(), sizeof *memory) {
    spec = tern::flight_spec(limits_of(world.settings));
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

  tern::FlightSpec spec{};
  std::vector<std::uint64_t> words;
  std::unique_ptr<tern::Workspace> memory;
  tern::Planner planner;
  tern::Flight flight;
  std::int64_t now = 0;
  std::uint64_t commits = 0;  ///< that the watch saw
  /// A command at time t, as it is after the tick at `now`.
  std::function<tern::Sample(tern::Sample, std::int64_t t, std::int64_t now)> alter;
  std::function<void(tern::FlightReport&)> alter_report;
  std::function<void()> after_tick;
};

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
      if (committed >= 1 && t >= now + late * kTick / 10) sample.position.y += 1e-10;
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

}  // namespace
