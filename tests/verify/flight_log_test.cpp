// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What in a flight's log must fit together: commits and commands, figures and track, its world and the one given.
#include "straight_flight.hpp"

namespace tern_verify {
namespace {

/// The same flight's world, as a file.
constexpr const char* kWorld =
    "boundary 0 0 0 10 6 3\nblock 4 0 0 5 2 3\ncylinder 5 4 0 3 0.5\nstart 1 3 1\ngoal 9 3 1\ncell 0.2\n"
    "tracking_margin 0.125\npose_margin 0.125\nv_max 2\na_max 2\ntick_hz 4\n";

std::string refusal_of(const Json& json) {
  try {
    prove(parse_flight(json.dump(), "log"));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

void expect_refusal(const Json& json, const std::string& reason) {
  EXPECT_NE(refusal_of(json).find(reason), std::string::npos) << refusal_of(json);
}

/// A commit of rest at the goal, and one that would take over from it elsewhere.
Json with_a_waiting_commit() {
  Json json = log();
  json["commits"].push_back(commit(2.0));
  json["commits"][2]["begin_ns"] = 3000000000;
  json["commits"].push_back(commit(2.5));
  json["plans"]["committed"] = 4;
  return json;
}

TEST(FlightLog, WhatWasWithdrawnWasNotFlown) {
  // The third one would begin at the start again, in mid-flight. The fourth one goes on along the second.
  Json json = with_a_waiting_commit();
  expect_refusal(json, "commit 4 was committed while the one before waited");
  json["commits"][2]["withdrawn_ns"] = 2250000000;
  const Claims claims = claims_of(json);
  EXPECT_EQ(verdict_of(claims, "flown: commands"), Verdict::kProven);
  EXPECT_EQ(verdict_of(claims, "takeover position"), Verdict::kRefuted) << "it was to take over, all the same";
  json["commits"][2]["begin_ns"] = 0;
  expect_refusal(json, "commit 3 was withdrawn while it did not wait");
}

TEST(FlightLog, AWithdrawnCommitThatWouldHaveFitted) {
  Json json = with_a_waiting_commit();
  json["commits"][2] = commit(2.0);
  json["commits"][2]["begin_ns"] = 8750000000;  // from rest at the goal
  json["commits"][2]["origin"][0] = 9.0;
  for (Json& point : json["commits"][2]["segments"][0]["relative_points"]) point[0] = 0.0;
  json["commits"][2]["withdrawn_ns"] = 2500000000;
  EXPECT_EQ(verdict_of(claims_of(json)), Verdict::kProven);
}

TEST(FlightLog, ATakenBackThatIsSaidToHaveFlown) {
  Json json = log();
  // Commands that go on along the first commit, while the log says that the second one, which waits, was withdrawn.
  json["commits"][1]["begin_ns"] = 2000000000;
  json["commits"][1]["withdrawn_ns"] = 1500000000;
  EXPECT_EQ(verdict_of(claims_of(json), "flown: commands"), Verdict::kProven);
  json["commits"][1].erase("withdrawn_ns");
  EXPECT_EQ(verdict_of(claims_of(json), "flown: commands"), Verdict::kRefuted);
}

TEST(FlightLog, CommandsOffTheCommits) {
  Json json = log();
  json["track"]["commanded"][7][1] = 3.0000001;
  EXPECT_EQ(verdict_of(claims_of(json), "flown: commands"), Verdict::kRefuted);
}

TEST(FlightLog, AFlightThatDoesNotBeginAtItsStart) {
  Json json = log();
  json["start"][2] = 1.0000001;
  EXPECT_EQ(verdict_of(claims_of(json), "takeover position"), Verdict::kRefuted);
}

TEST(FlightLog, AFlightThatDoesNotReachItsGoal) {
  Json json = log();
  json["goal"][1] = json["mission"][0]["position"][1] = 3.0000001;
  EXPECT_EQ(verdict_of(claims_of(json), "goal position"), Verdict::kRefuted);
  json["status"] = "stuck";
  EXPECT_EQ(verdict_of(claims_of(json)), Verdict::kProven);
  // Nor one that has not arrived yet.
  json = log();
  for (const char* const points : {"commanded", "believed", "true"}) json["track"][points].erase(35);
  json["time_s"] = 8.5;
  EXPECT_EQ(verdict_of(claims_of(json), "goal velocity"), Verdict::kRefuted);
}

TEST(FlightLog, LogsWithPartOfTheirCommitsAreRefused) {
  Json json = log();
  json["commits"].erase(0);
  expect_refusal(json, "it has 1 of the 2 commits that its 'plans' count");
  // The count alone does not help where a commit changes what is flown.
  json = log();
  json["commits"][1] = commit(1.0);
  json["commits"][1]["begin_ns"] = 2000000000;
  json["commits"].erase(0);
  json["plans"]["committed"] = 1;
  EXPECT_EQ(verdict_of(claims_of(json), "flown: commands"), Verdict::kRefuted);
}

TEST(FlightLog, FiguresThatTheTrackDoesNotShowAreRefused) {
  Json json = log();
  json["min_clearance"] = 0.2578126;
  expect_refusal(json, "its min_clearance is better than that of its track, 0.2578");
  json = log();
  json["tracking_error"]["max"] = 0.12;
  expect_refusal(json, "its tracking_error is better than that of its track, 0.125");
  json = log();
  json["time_s"] = 9.0;
  expect_refusal(json, "its track does not end at time_s");
  json = log();
  json["settings"]["tick_hz"] = 5.0;
  expect_refusal(json, "the ticks of its track are not tick_hz");
  json = log();
  json["track"]["true"].erase(0);
  expect_refusal(json, "does not have a point of each kind for each tick");
  json = log();
  json["mission"] = Json::array();
  expect_refusal(json, "its mission does not end at its goal");
}

TEST(FlightLog, FiguresThatAreWorseThanTheTrackCount) {
  Json json = log();
  json["min_clearance"] = 0.24;
  EXPECT_EQ(verdict_of(claims_of(json), "flown: body off the world"), Verdict::kRefuted);
  json = log();
  json["tracking_error"]["max"] = 0.13;
  EXPECT_EQ(verdict_of(claims_of(json), "flown: tracking error"), Verdict::kRefuted);
}

TEST(FlightLog, CommitsOutOfOrderAreRefused) {
  Json json = log();
  json["commits"][1]["time_ns"] = 0;
  expect_refusal(json, "commit 2 was not committed after the one before");
  json = log();
  json["commits"][1]["time_ns"] = 9000000000;
  expect_refusal(json, "commit 2 was committed before or after the flight");
}

std::string comparison(const std::string& world, const std::vector<std::string>& settings = {}) {
  Flight flight = parse_flight(log().dump(), "log");
  try {
    compare(parse_world(world, "w.txt", settings), "w.txt", flight);
  } catch (const InputError& error) {
    return error.what();
  }
  EXPECT_TRUE(assumed_of(flight).empty());
  return "";
}

TEST(FlightLog, WithoutAWorldItsOwnIsAssumed) {
  const std::vector<std::string> assumed = assumed_of(parse_flight(log().dump(), "log"));
  ASSERT_EQ(assumed.size(), 1u);
  EXPECT_NE(assumed[0].find("P25:7"), std::string::npos);
  EXPECT_EQ(comparison(kWorld), "");
}

TEST(FlightLog, TheWorldIsCompared) {
  const std::string world = kWorld;
  const auto differs = [](const std::string& text) {
    const std::string said = comparison(text);
    const std::string head = "log: it differs from w.txt in '";
    return said.rfind(head, 0) == 0 ? said.substr(head.size(), said.find("';") - head.size()) : said;
  };
  EXPECT_EQ(differs(world + "boundary 0 0 0 10 6 3.5\n"), "boundary");
  EXPECT_EQ(differs(world + "block 0 0 0 1 1 1\n"), "blocks");
  EXPECT_EQ(differs(world + "cylinder 0 0 0 1 1\n"), "cylinders");
  EXPECT_EQ(differs(world + "keepout 0 0 0 1 1 1\n"), "fences");
  EXPECT_EQ(differs(world + "start 1 3 2\n"), "start");
  EXPECT_EQ(differs(world + "via 5 3 1\n"), "points of the mission");
  EXPECT_EQ(differs(world + "body_radius 0.3\n"), "body_radius");
  EXPECT_EQ(differs(world + "pose_margin 0.1\n"), "pose_margin");
  EXPECT_EQ(differs(world + "tilt_tangent 0.5\n"), "tilt_tangent");
  EXPECT_EQ(differs(world + "tracking quadrotor\n"), "tracking");
  EXPECT_EQ(comparison(world + "body_radius 0.3\nseed 4\n", {"body_radius=0.25", "window=20,20,8"}), "");
  EXPECT_NE(comparison(world, {"boddy_radius=1"}).find("it is no setting"), std::string::npos);
  EXPECT_EQ(comparison(world + "radius 1\n"), "w.txt:12: unknown record 'radius'");
}

TEST(FlightLog, RigidBodiesSinkGently) {
  Json json = log();
  json["settings"]["a_max"] = 5.0;
  const auto bound = [&](const char* kind) {
    json["settings"]["tracking"] = kind;
    const std::vector<Bound> bounds = bounds_of(parse_flight(json.dump(), "log").world);
    const auto down = [](const Bound& b) { return b.derivative == 2 && b.axis == 2 && b.sign < 0; };
    return std::find_if(bounds.begin(), bounds.end(), down)->most;
  };
  EXPECT_EQ(bound("bounded"), 5);
  EXPECT_EQ(bound("px4"), 3);
}

TEST(FlightLog, ALogWithoutCommitsIsRefused) {
  Json json = log();
  json.erase("commits");
  EXPECT_THROW(claims_of(json), InputError);
  EXPECT_TRUE(is_flight(json.dump()));
  EXPECT_FALSE(is_flight("{}"));
}

}  // namespace
}  // namespace tern_verify
