// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A flight that says nothing of what comes into its way, or something that is not so, must be found out.
#include "host/flight/threat_watch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "host/flight/full_knowledge.hpp"

namespace {

using tern::FlightMode;

constexpr std::int64_t kWatchTick = 10000000;
constexpr std::int64_t kAppears = 50 * kWatchTick;

/// A vehicle that flies along x at 2 m/s and rests after 6 m, and a wall that the map shows after half a second.
struct Wall {
  Wall() {
    world.boundary = {{-2.0, -5.0, 0.0}, {12.0, 5.0, 4.0}};
    spec = tern::flight_spec(limits_of(world.settings));
    const tern::MapSpec map_spec = tern::map_spec({-4.0, -7.0, -1.0}, 0.2, {128, 70, 30}, radius_of(world.settings));
    words.resize(tern::map_words(map_spec));
    EXPECT_EQ(map.bind(map_spec, words.data(), words.size()), tern::Status::kOk);
    map.assume_free({4.0, 0.0, 2.0}, 30.0);
  }

  /// What the watch says of two seconds, with the reports of `mode` and of contacts.
  std::string watch(const std::function<tern::FlightReport(std::int64_t)>& report, int ticks = 200) {
    const tern_host::Rooms rooms(world, map);
    const tern_host::FlownCommands commands{[](std::int64_t t) { return command(t); }, [] { return tern::Vec3{}; }};
    tern_host::ThreatWatch watch(world.settings, spec, map, rooms, commands, meets);
    for (std::int64_t t = 0; t < ticks * kWatchTick && watch.broken().empty(); t += kWatchTick) {
      if (t == kAppears) map.mark_box({{5.0, -2.0, 0.0}, {6.5, 2.0, 4.0}});
      watch.look(t, report(t));
    }
    return watch.broken();
  }

  /// Nothing moves, unless a test says so.
  tern_host::Meets meets = [](const tern::Vec3&, std::int64_t) { return false; };

  static tern::Sample command(std::int64_t t) {
    const double s = std::clamp(1e-9 * static_cast<double>(t), 0.0, 3.0);
    tern::Sample sample{};
    sample.position = {2.0 * s, 0.1, 1.5};
    sample.velocity.x = t < 3000000000 ? 2.0 : 0.0;
    return sample;
  }

  /// The wall begins at x = 5, and the radius is 0.35 m.
  static tern::FlightReport honest(std::int64_t t) {
    tern::FlightReport report{};
    report.mode = FlightMode::kFly;
    if (t < kAppears) return report;
    report.mode = FlightMode::kThreat;
    report.contact_time = std::max(t, std::int64_t{2325000000});
    report.contact_speed = command(report.contact_time).velocity.x;
    return report;
  }

  tern_host::FlightWorld world;
  tern::FlightSpec spec{};
  std::vector<std::uint64_t> words;
  tern::RollingMap map;
};

testing::AssertionResult mentions(const std::string& broken, const std::string& wanted) {
  if (broken.find(wanted) != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "\"" << broken << "\" does not say \"" << wanted << '"';
}

TEST(ThreatWatch, IsContentWithAnHonestFlight) {
  EXPECT_EQ(Wall().watch(Wall::honest), "");
}

TEST(ThreatWatch, NoticesAFlightThatSaysNothing) {
  EXPECT_TRUE(mentions(Wall().watch([](std::int64_t) { return tern::FlightReport{}; }), "does not say so"));
}

/// After three seconds the vehicle rests in the wall. It need not call that a threat for ever, but must say what is in
/// the way.
TEST(ThreatWatch, LetsAFlightRestBesideWhatItSaid) {
  const auto silent_from = [](std::int64_t from, tern::BlockedBy by) {
    return Wall().watch(
        [=](std::int64_t t) {
          tern::FlightReport report{};
          report.blocked_by = by;
          return t < from ? Wall::honest(t) : report;
        },
        400);
  };
  EXPECT_EQ(silent_from(310 * kWatchTick, tern::BlockedBy::kObstacle), "");
  EXPECT_TRUE(mentions(silent_from(310 * kWatchTick, tern::BlockedBy::kNothing), "does not say so"));
  EXPECT_TRUE(mentions(silent_from(250 * kWatchTick, tern::BlockedBy::kObstacle), "does not say so"));
  EXPECT_TRUE(mentions(silent_from(kAppears, tern::BlockedBy::kObstacle), "does not say so"));
}

/// Some ticks are left to it.
TEST(ThreatWatch, LeavesTimeForAProof) {
  EXPECT_EQ(Wall().watch(
                [](std::int64_t t) { return t < kAppears + 5 * kWatchTick ? tern::FlightReport{} : Wall::honest(t); }),
            "");
  EXPECT_TRUE(mentions(Wall().watch([](std::int64_t t) {
    return t < kAppears + 12 * kWatchTick ? tern::FlightReport{} : Wall::honest(t);
  }),
                       "does not say so"));
}

TEST(ThreatWatch, NoticesAlarmsForNothing) {
  EXPECT_TRUE(mentions(Wall().watch([](std::int64_t t) { return Wall::honest(t + kAppears); }), "there is not"));
}

/// A tube reaches the way after 1.8 s, before the wall is seen and before it is met. A proof may end some microseconds
/// before, but no millisecond.
TEST(ThreatWatch, BelievesContactsWithTubes) {
  constexpr std::int64_t kMet = 1800000000;
  std::int64_t early = 0;
  const auto warn = [&early](std::int64_t t) {
    tern::FlightReport report = Wall::honest(t + kAppears);
    report.contact_time = std::max(t, kMet - early);
    report.contact_speed = Wall::command(report.contact_time).velocity.x;
    return report;
  };
  const auto with_tube = [&](std::int64_t too_early) {
    early = too_early;
    Wall wall;
    wall.meets = [](const tern::Vec3&, std::int64_t t) { return t >= kMet; };
    return wall.watch(warn);
  };
  EXPECT_TRUE(mentions(Wall().watch(warn), "there is not"));
  EXPECT_EQ(with_tube(0), "");
  EXPECT_EQ(with_tube(3000), "");
  EXPECT_TRUE(mentions(with_tube(1000000), "there is not"));
}

TEST(ThreatWatch, NoticesAWrongInstant) {
  for (const std::int64_t off : {-20000000, 1000000}) {
    EXPECT_TRUE(mentions(Wall().watch([off](std::int64_t t) {
      tern::FlightReport report = Wall::honest(t);
      if (t >= kAppears) report.contact_time += off;
      return report;
    }),
                         "but what is commanded is too near at t = 2.325"))
        << off;
  }
}

TEST(ThreatWatch, NoticesAContactThatNeverWas) {
  for (const std::int64_t ago : {kWatchTick, 40 * kWatchTick}) {
    EXPECT_TRUE(mentions(Wall().watch([ago](std::int64_t t) {
      tern::FlightReport report = Wall::honest(t);
      if (t >= kAppears + 2 * kWatchTick) report.contact_time = kAppears + 2 * kWatchTick - ago;
      return report;
    }),
                         "which is past"))
        << ago;
  }
}

TEST(ThreatWatch, NoticesAWrongSpeed) {
  EXPECT_TRUE(mentions(Wall().watch([](std::int64_t t) {
    tern::FlightReport report = Wall::honest(t);
    if (t >= kAppears) report.contact_speed = 1.9;
    return report;
  }),
                       "announced at 1.9 m/s, but at 2 is commanded"));
}

}  // namespace
