// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What is wrong in a scenario: where, and why.

#include <gtest/gtest.h>

#include <string>

#include "host/grid_layout.hpp"
#include "host/scenario.hpp"
#include "host/scenario_errors.hpp"

namespace {

using tern_host::Scenario;
using tern_host::ScenarioError;
using tern_test::error_of;
using tern_test::kMinimal;

const std::string hint = " in a scenario; `tern fly` reads flight worlds";

struct Fault {
  const char* text;
  const char* message;
};

TEST(Scenario, ErrorsNameFileLineAndReason) {
  const Fault faults[] = {
      {"boundery 0 0 0 1 1 1\n", "map.txt:1: unknown record 'boundery' in a scenario; `tern fly` reads flight worlds"},
      {"boundary 0 0 0 1 1\n", "map.txt:1: 'boundary' needs 6 numbers, found 5"},
      {"boundary 0 0 0 1 1 1 1\n", "map.txt:1: 'boundary' needs 6 numbers, found 7"},
      {"\n\nblock 0 0 0 1 1\n", "map.txt:3: 'block' needs 6 numbers, or 9 with a colour, found 5"},
      {"block 0 0 0 1 1 1 9 9\n", "map.txt:1: 'block' needs 6 numbers, or 9 with a colour, found 8"},
      {"keepout 0 0 0 1 1 1 9 9 9\n", "map.txt:1: 'keepout' needs 6 numbers, found 9"},
      {"block 0 0 0 1 1 1x\n", "map.txt:1: '1x' is not a number"},
      {"block 0 0 0 1 1 1 junk\n", "map.txt:1: 'junk' is not a number"},
      {"block 0 0 0 1 1 0x10\n", "map.txt:1: '0x10' is not a number"},
      {"block 0 0 0 1 1 1,5\n", "map.txt:1: '1,5' is not a number"},
      {"block 0 0 0 1 1 1e\n", "map.txt:1: '1e' is not a number"},
      {"block 0 0 0 1 1 .\n", "map.txt:1: '.' is not a number"},
      {"block 0 0 0 1 1 --1\n", "map.txt:1: '--1' is not a number"},
      {"block 0 0 0 1 1 nan\n", "map.txt:1: 'nan' is not a finite number"},
      {"block 0 0 0 1 1 -Infinity\n", "map.txt:1: '-Infinity' is not a finite number"},
      {"block 0 0 0 1 1 1e999\n", "map.txt:1: '1e999' is not a finite number"},
      {"block 0 2 0 1 1 1\n", "map.txt:1: 'block' has its corners the wrong way round in y: 2 > 1"},
      {"boundary 0 0 3 1 1 1\n", "map.txt:1: 'boundary' has its corners the wrong way round in z: 3 > 1"},
      {"start 1 2\n", "map.txt:1: 'start' needs 3 numbers, found 2"},
      {"goal\n", "map.txt:1: 'goal' needs 3 numbers, found 0"},
      {"resolution 1 2\n", "map.txt:1: 'resolution' needs 1 number, found 2"},
      {"a_min -1 -2\n", "map.txt:1: 'a_min' needs 1 or 3 numbers, found 2"},
      {"v_horizontal 1 2\n", "map.txt:1: 'v_horizontal' needs 1 number, found 2"},
      {"v_max 1 2\n", "map.txt:1: 'v_max' needs 1 or 3 numbers, found 2"},
      {"start 1 1 1\ngoal 1 1 1\nstart 1 1 1\n", "map.txt:3: 'start' is given twice (first in line 1)"},
      {"", "map.txt:1: the file ends without a 'boundary'"},
      {"boundary 0 0 0 1 1 1\n", "map.txt:1: the file ends without a 'start'"},
      {"boundary 0 0 0 1 1 1\nstart 0 0 0\n# end\n", "map.txt:3: the file ends without a 'goal'"},
      {"start 1 1 1\n\001\n", "map.txt:2: not a text file: byte 1"},
  };
  for (const Fault& fault : faults) EXPECT_EQ(error_of(fault.text), fault.message) << fault.text;
}

TEST(Scenario, ErrorsOfWholeScenariosNameTheRecord) {
  const Fault faults[] = {
      {"boundary 0 0 0 1 1 1\n", "map.txt:4: 'boundary' is given twice (first in line 1)"},
      {"resolution 0\n", "map.txt:4: 'resolution' must be more than 0"},
      {"resolution -0.1\n", "map.txt:4: 'resolution' must be more than 0"},
      {"radius -1\n", "map.txt:4: 'radius' must not be less than 0"},
  };
  for (const Fault& fault : faults) EXPECT_EQ(error_of(kMinimal + fault.text), fault.message) << fault.text;
}

TEST(Scenario, FencesSayWhatTheyWereMadeFor) {
  const std::string within = kMinimal + "fences_within 0 0 0 4 3 2 ";
  EXPECT_EQ(error_of(within + "0.3\nradius 0.1\ntracking_margin 0.2\n"), "") << "the sum of doubles is more than 0.3";
  EXPECT_EQ(
      error_of(within + "0.3\nradius 0.2\ntracking_margin 0.2\n"),
      "map.txt:4: the fences were made for a clearance of 0.3 m, but radius + tracking_margin is 0.4 m: zones may "
      "be missing. Make the fences again, with tern airspace --clearance 0.4");
  EXPECT_EQ(error_of(within + "0.3\n", {"radius=1.5"}).substr(0, 80),
            "map.txt:4: the fences were made for a clearance of 0.3 m, but radius + tracking_");
  EXPECT_EQ(
      error_of(kMinimal + "fences_within 0 0 0 4 3 1.5 1\n"),
      "map.txt:4: the fences were made for the boundary 0 0 0 4 3 1.5, but the boundary is 0 0 0 4 3 2: zones may "
      "be missing. Make the fences again, with tern airspace --boundary 0 0 0 4 3 2");
  EXPECT_EQ(error_of(kMinimal + "fences_within -1 -1 0 5 4 3 1\n"), "");
  EXPECT_EQ(error_of(within + "1\n" + "fences_within 0 0 0 4 3 2 1\n"),
            "map.txt:5: 'fences_within' is given twice (first in line 4)");
  EXPECT_EQ(error_of(within + "\n"), "map.txt:4: 'fences_within' needs 7 numbers, a box and a clearance, found 6");
  EXPECT_EQ(error_of(within + "-1\n"), "map.txt:4: the clearance of 'fences_within' must not be less than 0");
}

TEST(Scenario, FramesAreOnTheEarth) {
  const tern_host::Scenario scenario =
      tern_host::parse_scenario(kMinimal + "frame -47.5 8.25\nepoch 2026-03-02T09:00:00+01:00\n", "map.txt");
  EXPECT_EQ(scenario.earth.origin->latitude, -47.5);
  EXPECT_EQ(scenario.earth.origin->longitude, 8.25);
  EXPECT_FALSE(scenario.earth.height.has_value());
  EXPECT_EQ(scenario.earth.epoch, "2026-03-02T09:00:00+01:00");
  const Fault faults[] = {
      {"frame 98 8\n", "map.txt:4: the latitude 98 is beyond 90 degrees; it comes before the longitude"},
      {"frame 8 361\n", "map.txt:4: the longitude 361 is beyond 360 degrees"},
      {"frame 8\n", "map.txt:4: 'frame' needs latitude, longitude and maybe a height, found 1"},
      {"frame 1 2\nframe 1 2\n", "map.txt:5: 'frame' is given twice"},
      {"epoch 2026-03-02\n", "map.txt:4: 'epoch' must be like 2026-03-01T09:30:00Z, with a time zone"},
      {"epoch 2026-03-02T09:00:00Z\nepoch 2026-03-02T09:00:00Z\n", "map.txt:5: 'epoch' is given twice"},
  };
  for (const Fault& fault : faults) EXPECT_EQ(error_of(kMinimal + fault.text), fault.message) << fault.text;
}

TEST(Scenario, TruncatedRightBeforeTheEndIsAnError) {
  EXPECT_EQ(error_of("boundary 0 0 0 1 1 1\nstart 0 0 0\ngoal 0 0"), "map.txt:3: 'goal' needs 3 numbers, found 2");
}

TEST(Scenario, HostileWordsAreQuotedShortAndPrintable) {
  const std::string message = error_of("a\x1b[31m\n");
  EXPECT_EQ(message, "map.txt:1: not a text file: byte 27");
  EXPECT_EQ(error_of("\xff\xfd\n"), "map.txt:1: unknown record '\?\?'" + hint);
  EXPECT_EQ(error_of(std::string(1000, 'k')), "map.txt:1: unknown record '" + std::string(40, 'k') + "...'" + hint);
  EXPECT_EQ(error_of(std::string("goal\0 1 1 1\n", 12)), "map.txt:1: not a text file: byte 0");
}

TEST(Scenario, LinesBlocksAndFilesAreBounded) {
  EXPECT_EQ(error_of(kMinimal + "#" + std::string(tern_host::kMaxLineBytes, 'x')),
            "map.txt:4: the line is longer than 4096 bytes");
  std::string many = kMinimal;
  for (std::size_t i = 0; i <= tern_host::kMaxStrips; ++i) many += "block 0 0 0 1 1 1\n";
  EXPECT_EQ(error_of(many), "map.txt:200004: more than 200000 blocks");
  EXPECT_EQ(error_of(std::string(tern_host::kMaxTextBytes + 1, '\n')), "map.txt: larger than 67108864 bytes");
}

TEST(Scenario, CapacitiesNameTheRecordThatExceedsThem) {
  EXPECT_EQ(error_of(kMinimal + "resolution 1e-9\n"),
            "map.txt:4: a grid of 1e-09 m voxels over the boundary has more than 2048 voxels along an "
            "axis (TERN_MAX_DIMENSION); a resolution of 0.0072 fits");
  EXPECT_EQ(error_of("start 0 0 0\ngoal 1 1 1\nboundary -1e300 0 0 1e300 1 1\n").substr(0, 10), "map.txt:3:");
  const std::string cells = error_of("boundary 0 0 0 100 100 100\nstart 0 0 0\ngoal 1 1 1\n");
  EXPECT_NE(cells.find("map.txt:1: a grid of"), std::string::npos);
  EXPECT_NE(cells.find("TERN_MAX_CELLS"), std::string::npos);
}

TEST(Scenario, OverridesAreCheckedLikeRecords) {
  EXPECT_EQ(error_of(kMinimal, {"radius"}), "--set radius: expected key=value");
  EXPECT_EQ(error_of(kMinimal, {"=1"}), "--set =1: expected key=value");
  EXPECT_EQ(error_of(kMinimal, {"colour=1"}), "--set colour=1: unknown or not a setting: 'colour'");
  EXPECT_EQ(error_of(kMinimal, {"boundary=0,0,0,1,1,1"}),
            "--set boundary=0,0,0,1,1,1: unknown or not a setting: 'boundary'");
  EXPECT_EQ(error_of(kMinimal, {"goal=1,2"}), "--set goal=1,2: 'goal' needs 3 numbers, found 2");
  EXPECT_EQ(error_of(kMinimal, {"radius=inf"}), "--set radius=inf: 'inf' is not a finite number");
  EXPECT_EQ(error_of(kMinimal, {"resolution=0"}), "--set resolution=0: 'resolution' must be more than 0");
  EXPECT_EQ(error_of(kMinimal, {"resolution=1e-9"}).substr(0, 23), "--set resolution=1e-9: ");
}

TEST(Scenario, FilesThatCannotBeReadSayWhy) {
  const auto error = [](const char* path) {
    try {
      tern_host::read_scenario(path);
    } catch (const ScenarioError& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_EQ(error("/nonexistent/map.txt"), "/nonexistent/map.txt: cannot be opened: No such file or directory");
  EXPECT_EQ(error("/"), "/: cannot be read: Is a directory");
}

}  // namespace
