// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Short flights of the program tern_companion with the simulated autopilot, over UDP on this computer, in lockstep. The
// world is a forest; what the program makes of it is judged in the true one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "autopilot/companion_flight.hpp"
#include "companion/companion.hpp"

namespace tern_autopilot {
namespace {

using namespace tern_companion;

class CompanionFlies : public testing::Test {
 protected:
  /// 14 m of a forest, as far as the second row of trees.
  explicit CompanionFlies(bool is_px4 = true) {
    world_.goal = {-16.0, 1.0, 1.5};
    world_.settings.time_limit = 40.0;
    flight_.program = TERN_TEST_COMPANION;
    flight_.autopilot.is_px4 = is_px4;
  }
  /// Flies; `then` is called from each step on.
  FlightOutcome fly_with(const std::function<void(double, const FlightHands&)>& then = {}) {
    flight_.pilot = [then](double t, const FlightHands& hands) {
      plain_pilot(t, hands);
      if (then) then(t, hands);
    };
    return fly(world_, flight_);
  }
  void expect_reached(const FlightOutcome& outcome) const {
    EXPECT_FALSE(outcome.touched) << outcome.said;
    EXPECT_GT(outcome.clearance, 0.2);
    EXPECT_EQ(outcome.exit_status, 0) << outcome.said;
    EXPECT_LT(outcome.from_goal, 0.3);
    EXPECT_LT(outcome.speed_at_end, 0.2);
    EXPECT_EQ(outcome.counts.refused, 0u);
  }
  static bool says(const FlightOutcome& outcome, const std::string& words) {
    return outcome.said.find(words) != std::string::npos;
  }
  static double speed(const FlightHands& hands) { return tern_onboard::length(hands.autopilot.vehicle().velocity()); }

  tern_host::FlightWorld world_ = tern_host::read_flight_world("P49@2:3", companion_world_settings());
  CompanionFlight flight_;
};

class CompanionFliesArdupilot : public CompanionFlies {
 protected:
  CompanionFliesArdupilot() : CompanionFlies(false) {}
};

TEST_F(CompanionFlies, Px4StreamsBeforeTheSwitchAndArrives) {
  const FlightOutcome outcome = fly_with([](double t, const FlightHands& hands) {
    if (t < 1.9) {
      EXPECT_FALSE(hands.autopilot.follows());
    }
  });
  expect_reached(outcome);
  EXPECT_GT(outcome.counts.setpoints, outcome.counts.followed + 40) << "a second of them before the switch";
  EXPECT_EQ(outcome.counts.failsafes, 0u);
  EXPECT_LT(outcome.counts.longest_gap, 0.0301);
  EXPECT_LT(outcome.counts.largest_step, 0.05) << "positions go on as the velocities say";
  EXPECT_GE(outcome.counts.heartbeats, static_cast<std::uint64_t>(outcome.time) - 1);
  EXPECT_TRUE(says(outcome, "to the first setpoint that rests on it"));
}

TEST_F(CompanionFliesArdupilot, SendsNothingOutsideGuidedAndArrives) {
  const FlightOutcome outcome = fly_with();
  expect_reached(outcome);
  EXPECT_EQ(outcome.counts.setpoints, outcome.counts.followed);
  EXPECT_LT(outcome.counts.largest_step, 0.05);
}

TEST_F(CompanionFlies, AsksForTheModeItself) {
  flight_.arguments = {"--switch-mode"};
  flight_.pilot = [](double t, const FlightHands& hands) {
    hands.autopilot.set_armed(t >= 0.5);
    hands.autopilot.set_in_air(t >= 1.0);
  };
  expect_reached(fly(world_, flight_));
}

TEST_F(CompanionFlies, WaitsOnTheGroundAndDisarmedEvenInOffboard) {
  flight_.pilot = [](double t, const FlightHands& hands) {
    hands.autopilot.set_armed(t >= 4.0);
    hands.autopilot.set_in_air(t >= 6.0);
    if (t >= 2.0) hands.autopilot.switch_to_companion();
    if (t < 6.0) {
      EXPECT_LT(speed(hands), 0.05);
    }
  };
  const FlightOutcome outcome = fly(world_, flight_);
  expect_reached(outcome);
  EXPECT_TRUE(says(outcome, "waits to be armed") && says(outcome, "waits for take-off")) << outcome.said;
}

TEST_F(CompanionFlies, ComesToRestOnALostLinkAndGoesOnAfterIt) {
  const FlightOutcome outcome = fly_with([](double t, const FlightHands& hands) {
    hands.autopilot.set_silent(t > 6.0 && t < 14.0);
    if (t > 5.9 && t < 6.0) {
      EXPECT_GT(speed(hands), 0.5);
    }
    if (t > 11.0 && t < 14.0) {
      EXPECT_LT(speed(hands), 0.1);
    }
  });
  expect_reached(outcome);
  EXPECT_TRUE(says(outcome, "the link is lost: comes to rest"));
  EXPECT_GT(outcome.time, 14.0);
}

/// A drone hovers at the goal, and reports itself from another system of the link until the 20th second.
TEST_F(CompanionFlies, WaitsUntilADroneHasLeftItsGoal) {
  flight_.arguments = {"--own-error", "0.5", "--geoid", "0", "--set", "thing_memory=3"};
  const tern::Vec3 goal = world_.goal;
  const FlightOutcome outcome = fly_with([goal](double t, const FlightHands& hands) {
    if (std::lround(100.0 * t) % 50 != 0) return;
    Sender autopilot{1, kAutopilotComponent, 0}, drone{2, kAutopilotComponent, 0};
    hands.companion.send(pack(autopilot, GpsGlobalOrigin{0, 80000000, 400000, 0}));
    UtmGlobalPosition report;
    constexpr double kOfMetre = 1e7 / (6371000.0 * 3.14159265358979323846 / 180.0);  // at the equator
    report.latitude = static_cast<std::int32_t>(std::lround(kOfMetre * goal.y));
    report.longitude = 80000000 + static_cast<std::int32_t>(std::lround(kOfMetre * goal.x));
    report.altitude = 400000 + static_cast<std::int32_t>(std::lround(1000.0 * goal.z));
    report.horizontal_deviation = report.vertical_deviation = 100;
    report.speed_deviation = 1;
    report.flags = kUtmPlace | kUtmAltitude | kUtmSpeed | kUtmClimb;
    if (t < 20.0) hands.companion.send(pack(drone, report));
    hands.companion.send(pack(autopilot, report));  // the vehicle's own
  });
  expect_reached(outcome);
  EXPECT_GT(outcome.time, 22.0);
}

TEST_F(CompanionFlies, SeesWithTwoCameras) {
  flight_.sensors = "cameras";
  expect_reached(fly_with());
}

TEST_F(CompanionFlies, SeesWithACameraAndALidar) {
  flight_.sensors = "both";
  const FlightOutcome outcome = fly_with();
  expect_reached(outcome);
  EXPECT_FALSE(says(outcome, "refused")) << outcome.said;
}

TEST_F(CompanionFlies, GivesTheVehicleBackAndTakesItAgain) {
  std::uint64_t before = 0;
  const FlightOutcome outcome = fly_with([&before](double t, const FlightHands& hands) {
    if (t > 6.0 && t < 10.0) hands.autopilot.switch_to_pilot();
    if (t > 6.5 && t < 6.6) before = hands.autopilot.counts().followed;
    if (t > 6.6 && t < 10.0) {
      EXPECT_EQ(hands.autopilot.counts().followed, before);
    }
  });
  expect_reached(outcome);
  EXPECT_TRUE(says(outcome, "the flight ends"));
}

TEST_F(CompanionFliesArdupilot, IsSilentOnceDisarmed) {
  world_.settings.time_limit = 12.0;
  std::uint64_t sent = 0;
  const FlightOutcome outcome = fly_with([&sent](double t, const FlightHands& hands) {
    if (t <= 6.0) return;
    hands.autopilot.set_armed(false);
    // It hears of that with the next heartbeat.
    if (t < 7.2) sent = hands.autopilot.counts().setpoints;
    EXPECT_EQ(hands.autopilot.counts().setpoints, sent);
  });
  EXPECT_FALSE(outcome.touched);
  EXPECT_TRUE(says(outcome, "flies\nwaits to be armed") || says(outcome, "waits to be armed"));
}

TEST_F(CompanionFlies, GoesOnAroundAResetOfTheEstimate) {
  world_.settings.pose_jump = {1.0, 6.0};
  const FlightOutcome outcome = fly_with([](double t, const FlightHands& hands) {
    if (t > 3.0) {
      EXPECT_LT(speed(hands), 2.6) << "it does not chase the jump";
    }
  });
  EXPECT_TRUE(says(outcome, "jump")) << outcome.said;
  expect_reached(outcome);
}

TEST_F(CompanionFlies, StaysInWhatItHasSeenWithoutFramesAndGoesOnWithThem) {
  double farthest = -100.0;
  const FlightOutcome outcome = fly_with([&farthest](double t, const FlightHands& hands) {
    hands.camera_works = t < 5.0 || t > 12.0;
    if (t < 12.0) farthest = std::max(farthest, hands.autopilot.vehicle().position().x);
  });
  expect_reached(outcome);
  EXPECT_GT(outcome.time, 12.0);
  EXPECT_LT(farthest, world_.goal.x - 1.0);
  EXPECT_TRUE(says(outcome, "no frames of depth come")) << outcome.said;
  EXPECT_TRUE(says(outcome, "frames of depth come again"));
}

TEST_F(CompanionFlies, HoldsTheVehicleOnceItHasStrayed) {
  world_.settings.time_limit = 14.0;
  world_.settings.tracking_margin = 0.05;  // the vehicle is further off than that
  flight_.arguments = {"--set", "stray=0.1"};
  const FlightOutcome outcome = fly_with([](double t, const FlightHands& hands) {
    if (t > 10.0) {
      EXPECT_LT(speed(hands), 0.1);
    }
  });
  EXPECT_TRUE(says(outcome, "more than stray")) << outcome.said;
  EXPECT_TRUE(says(outcome, "leave the mode and come back"));
  EXPECT_FALSE(outcome.touched);
  EXPECT_EQ(outcome.exit_status, -1);
}

TEST_F(CompanionFlies, ComesToRestAndEndsWhenInterrupted) {
  const FlightOutcome outcome = fly_with([](double t, const FlightHands& hands) {
    if (t > 6.0 && t < 6.015) hands.companion.interrupt();
  });
  EXPECT_EQ(outcome.exit_status, 1);
  EXPECT_FALSE(outcome.touched);
  EXPECT_LT(outcome.speed_at_end, 0.1);
  EXPECT_GT(outcome.from_goal, 1.0);
}

TEST_F(CompanionFlies, FliesToWhereAGroundStationSays) {
  flight_.goal_by_link = true;
  world_.settings.time_limit = 16.0;
  const FlightOutcome outcome = fly_with([this](double t, const FlightHands& hands) {
    if (t < 5.0 || t > 5.015) return;
    EXPECT_LT(speed(hands), 0.1);
    Sender ground{255, 190, 0};
    CommandInt command;
    command.command = kDoReposition;
    command.target_system = 1;
    command.target_component = kCompanionComponent;
    command.frame = kLocalNed;
    command.x = static_cast<std::int32_t>(1e4 * world_.goal.y);
    command.y = static_cast<std::int32_t>(1e4 * world_.goal.x);
    command.z = static_cast<float>(-world_.goal.z);
    hands.companion.send(pack(ground, command));
  });
  EXPECT_FALSE(outcome.touched);
  EXPECT_TRUE(says(outcome, "waits for a goal"));
  EXPECT_LT(outcome.from_goal, 0.3) << outcome.said;
  EXPECT_EQ(outcome.exit_status, -1) << "it goes on holding the vehicle";
}

/// Trees stand still, so the flight is the same.
TEST_F(CompanionFlies, TracksNothingAmongTrees) {
  const FlightOutcome without = fly_with();
  flight_.arguments = {"--set", "clusters=person"};
  const FlightOutcome with = fly_with();
  EXPECT_TRUE(says(with, "what the sensors see move is tracked, as of class person")) << with.said;
  EXPECT_FALSE(says(without, "is tracked"));
  EXPECT_EQ(with.length, without.length);
  expect_reached(with);
}

TEST_F(CompanionFlies, EqualFlightsAreEqual) {
  const FlightOutcome first = fly_with(), second = fly_with();
  EXPECT_EQ(first.length, second.length);
  EXPECT_EQ(first.said, second.said);
}

TEST(CompanionProgram, SaysWhyItHearsNobody) {
  std::vector<std::string> said;
  const auto companion = std::make_unique<Companion>(
      CompanionSettings{}, Companion::Outputs{[](const auto&) {}, [&said](const auto& text) { said.push_back(text); }});
  // HEARTBEAT of MAVLink 1.
  const std::uint8_t bytes[] = {0xfe, 9, 1, 7, 0xbf, 0, 0, 0, 6, 0, 0x12, 8, 0x81, 4, 3, 0x65, 0xc3};
  for (int k = 0; k < 3; ++k) EXPECT_FALSE(companion->read(bytes, sizeof bytes, k));
  ASSERT_EQ(said.size(), 1u);
  EXPECT_NE(said[0].find("MAVLink 1"), std::string::npos);
}

TEST(CompanionProgram, RefusesWordsItCannotRead) {
  const auto run = [](const std::string& words) {
    return std::system((std::string(TERN_TEST_COMPANION " ") + words + " >/dev/null 2>&1").c_str());
  };
  for (const char* words :
       {"--link tcp:1", "--goal 1,2", "--set cell", "--set cell=many", "--set color=1", "--set clusters=boat",
        "--mission /no/such/file", "--parameters /no/such/file", "--unknown"}) {
    EXPECT_EQ(run(words), 2 << 8) << words;
  }
  EXPECT_EQ(run("--list-parameters"), 0);
}

}  // namespace
}  // namespace tern_autopilot
