// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/track_record.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <string>

#include "host/plan_file.hpp"
#include "host/scenario.hpp"
#include "host/session.hpp"

namespace {

using tern_host::Scenario;

const std::string kAmongRoom = "boundary 0 0 0 12 8 3\nradius 0.3\nstart 1 4 1.5\ngoal 11 4 1.5\n";

Scenario parse(const std::string& records) {
  return tern_host::parse_scenario(kAmongRoom + records, "room.txt");
}

void expect_error(const std::string& records, const std::string& part) {
  try {
    parse(records);
    ADD_FAILURE() << records << " is read";
  } catch (const tern_host::ScenarioError& error) {
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("room.txt:5"), std::string::npos) << error.what();
  }
}

TEST(TrackRecord, ReadsAllWords) {
  const Scenario scenario = parse(
      "track car box 1 2 3 reach 4 until 107.5 stays velocity 5 6 7 error 0.1 0.2 0.3 from 99.25 at 8 9 10\n"
      "track man cylinder 0.3 1.8 at 1 2 3\nstart_time 100\nrest_clear 2.5\n");
  ASSERT_EQ(scenario.tracks.size(), 2u);
  EXPECT_EQ(scenario.start_time, 100.0);
  EXPECT_EQ(scenario.rest_clear, 2.5);
  const std::vector<tern::Track> tracks = tern_host::tracks_of(scenario.tracks);
  const tern::Track& car = tracks[0];
  EXPECT_EQ(car.shape, tern::TrackShape::kBox);
  EXPECT_EQ(car.half.y, 2.0);
  EXPECT_EQ(car.measured, 99250000000);
  EXPECT_EQ(car.until, 107500000000);
  EXPECT_EQ(car.end, tern::TrackEnd::kStays);
  EXPECT_EQ(car.position.z, 10.0);
  EXPECT_EQ(car.velocity.x, 5.0);
  EXPECT_EQ(car.error, 0.1);
  EXPECT_EQ(car.error_speed, 0.2);
  EXPECT_EQ(car.error_growth, 0.3);
  EXPECT_EQ(car.reach, 4.0);
  EXPECT_EQ(car.piece_count, 0);
  EXPECT_EQ(tracks[1].measured, 100000000000);
  EXPECT_EQ(tracks[1].radius, 0.3);
  EXPECT_EQ(tracks[1].half.z, 0.9);
  EXPECT_EQ(tracks[1].end, tern::TrackEnd::kGoesOn);
}

std::string piece(const std::string& id, double duration, double x) {
  std::string line = "track_piece " + id + " " + std::to_string(duration);
  for (int k = 0; k < 8; ++k) line += " " + std::to_string(x + k) + " 2 1";
  return line + "\n";
}

TEST(TrackRecord, ReadsPiecesAndTimedKeepOuts) {
  const Scenario scenario = parse("track drone ball 0.4\n" + piece("drone", 2.0, 0.0) + piece("drone", 1.0, 7.0) +
                                  "keepout 4 2 0 5 8 3 during 2 9\n");
  const std::vector<tern::Track> tracks = tern_host::tracks_of(scenario.tracks);
  ASSERT_EQ(tracks.size(), 2u);
  ASSERT_EQ(tracks[0].piece_count, 2);
  EXPECT_EQ(tracks[0].pieces[1].duration, 1.0);
  EXPECT_EQ(tracks[0].pieces[1].points[2].x, 9.0);
  EXPECT_TRUE(scenario.tracks[1].is_fence);
  EXPECT_EQ(tracks[1].measured, 2000000000);
  EXPECT_EQ(tracks[1].until, 9000000000);
  EXPECT_EQ(tracks[1].end, tern::TrackEnd::kGone);
  EXPECT_EQ(tracks[1].position.y, 5.0);
  EXPECT_NEAR(tracks[1].half.x, 0.5, 1e-15);
  EXPECT_GE(tracks[1].half.x, 0.5);
  EXPECT_TRUE(scenario.blocks.empty());
}

TEST(TrackRecord, SaysWhatIsWrong) {
  expect_error("track a cone 1 at 1 2 3\n", "'ball', a 'cylinder' or a 'box'");
  expect_error("track a ball -1 at 1 2 3\n", "less than 0");
  expect_error("track a ball 1 at 1 2\n", "missing");
  expect_error("track a ball 1 near 1 2 3\n", "unknown word");
  expect_error("track a ball 1 at 1 2 3 until 5 flies\n", "'gone', 'stays'");
  expect_error("track a ball 1 at 1 2 3 from 6 until 5 gone\n", "ends before");
  expect_error("track a ball 1 at 1 2 3 from 1e11\n", "too far away");
  expect_error("track a ball 1\n", "needs either");
  expect_error("track a ball 1 at 1 2 3 plan b.json\n", "needs either 'at', pieces or a 'plan', and has more than one");
  expect_error("track a ball 1 error 0.1 plan b.json\n", "'plan' is not a number: it stands where e1, the second of");
  expect_error("track a ball 1 at 1 2 3 until 6\n", "where what holds after 'until' ('gone', 'stays' or 'reach') is");
  expect_error("track a ball 1 at 1 2 3 until 6 error 1 1 1\n", "'gone', 'stays' or 'reach'; found 'error'");
  expect_error("track a ball 1 at 1 2 3 speed 6\n", "'speed' of a track, which takes at, velocity, error");
  expect_error("track a ball 1 at 1e13 2 3\n", "track");
  expect_error("track a ball 1 at 1 2 3 at 1 2 4\n", "'at' stands twice in track 'a'");
  expect_error("track a ball 1 at 1 2 3 error 0 0 0 from 1 error 1 0 0\n", "'error' stands twice");
  expect_error("track a ball 1 at 1 2 3 until 5 reach\n", "has no 'reach v'");
  expect_error("track_piece a 1 2 3\n", "24 numbers");
  expect_error(piece("a", 1.0, 2.0), "no 'track'");
  expect_error("keepin 0 0 0 9 9 9 during 1\n", "2 times, or 3 with an error");
  expect_error("keepin 0 0 0 9 9 9 during 1 1\n", "or at once");
  expect_error("keepin 0 0 0 9 9 9 during 1 5e9\n", "too far away");
  expect_error("keepin 0 0 0 9 9 9 during 1 2 -1\n", "must not be less than 0");
  expect_error("keepout 0 0 0 9 9 9 during 2 1\n", "ends before");
  EXPECT_THROW(parse("track a ball 1 at 1 2 3\ntrack a ball 1 at 1 2 3\n"), tern_host::ScenarioError);
  EXPECT_THROW(parse("track a ball 1\n" + piece("a", 0.0, 1.0)), tern_host::ScenarioError);
}

/// A plan among things that move, its file, and another plan among that one.
TEST(TrackRecord, APlanFileIsATrack) {
  tern_host::Session session(tern_host::platform_clock());
  const tern_host::PlanResult first = session.plan(parse("track man ball 0.3 at 6 0 1.5 velocity 0 1 0\n"));
  ASSERT_TRUE(first.ok());
  const std::string file = tern_host::plan_json(first);
  EXPECT_NE(file.find("\"rest_clear_until\": null"), std::string::npos);
  EXPECT_NE(file.find("\"waits\""), std::string::npos);
  const std::string folder = testing::TempDir();
  std::ofstream(folder + "first.json") << file;
  std::ofstream(folder + "second.txt")
      << "boundary 0 0 0 12 8 3\nradius 0.3\nstart 11 4 1.5\ngoal 1 4 1.5\ntrack first ball 0.3 plan first.json\n";
  const Scenario scenario = tern_host::read_scenario(folder + "second.txt");
  ASSERT_EQ(scenario.tracks.size(), 1u);
  EXPECT_EQ(static_cast<int>(scenario.tracks[0].pieces.size()), first.trajectory.count);
  EXPECT_EQ(scenario.tracks[0].track.position.x, first.trajectory.origin.x);
  const tern_host::PlanResult second = session.plan(scenario);
  EXPECT_EQ(second.report.status, tern::Status::kOk);
}

/// The place is that of the record, whatever is wrong with the file.
TEST(TrackRecord, NamesThePlaceOfAPlanThatIsNone) {
  const std::string folder = testing::TempDir();
  std::ofstream(folder + "to_none.txt") << "boundary 0 0 0 12 8 3\nstart 11 4 1.5\ngoal 1 4 1.5\n"
                                           "track first ball 0.3 plan none.json\n";
  const auto reason = [&] {
    try {
      tern_host::read_scenario(folder + "to_none.txt");
    } catch (const tern_host::ScenarioError& error) {
      EXPECT_EQ(error.place().line, 4);
      return error.reason();
    }
    return std::string("nothing");
  };
  EXPECT_EQ(reason().find("the plan of track 'first': " + folder + "none.json: cannot be opened"), 0u) << reason();
  std::ofstream(folder + "none.json") << R"({"status": "no_path"})";
  EXPECT_EQ(reason(), "'none.json' has no plan: its 'status' is 'no_path'");
  std::ofstream(folder + "none.json") << "{}";
  EXPECT_NE(reason().find("is no plan file"), std::string::npos);
  std::remove((folder + "none.json").c_str());
}

/// What is in the way for good, and what covers the goal for a while.
TEST(TrackRecord, PlanFilesSayWhatIsInTheWay) {
  tern_host::Session session(tern_host::platform_clock());
  const std::string blocked = tern_host::plan_json(session.plan(parse("track wall box 0.2 9 9 at 6 4 1.5\n")));
  EXPECT_NE(blocked.find("\"status\": \"no_clear_time\""), std::string::npos);
  EXPECT_NE(blocked.find("\"track\": \"wall\""), std::string::npos);
  EXPECT_NE(blocked.find("track: wall"), std::string::npos);
  const std::string covered = tern_host::plan_json(session.plan(parse("keepout 9 0 0 12 8 3 during 0 200\n")));
  EXPECT_NE(covered.find("\"status\": \"goal_covered\""), std::string::npos);
  EXPECT_NE(covered.find("\"goal_free\": 200.0"), std::string::npos);
  EXPECT_NE(covered.find("the goal is free after 200.0"), std::string::npos);
  const std::string lake = tern_host::plan_json(session.plan(
      parse("keepout 0 0 0 4 8 3 during 5 12.5 zone Port\nkeepout 0 0 0 4 8 3 during -100 9 zone Lake\n")));
  EXPECT_NE(
      lake.find("track: keepout 2 (Lake), 0 s after the beginning; it is closed until 9.000 s of the clock; the "
                "start is in it: it is free at 12.500 s of the clock. Begin then (start_time 12.5), or elsewhere"),
      std::string::npos)
      << lake;
  const std::string open = tern_host::plan_json(session.plan(parse("keepout 5 0 0 6 8 3 during 1 1e9\n")));
  EXPECT_NE(open.find("; it is closed without end: choose another start or goal, or leave it out if you may fly there"),
            std::string::npos)
      << open;
  const std::string closed = tern_host::plan_json(session.plan(parse("keepin 0 0 0 5 8 3 during -1 500\n")));
  EXPECT_NE(closed.find("\"fence\": 0"), std::string::npos);
}

}  // namespace
