// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Records of flights through port/onboard, flown again.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>

#include "host/flight/flight_replay.hpp"
#include "onboard/onboard_sky.hpp"
#include "tern_onboard/record_files.hpp"

namespace {

using tern_host::FlightReplay;
using tern_onboard::RecordPart;
using tern_test::kMs;
using tern_test::Sky;

/// The records of flights, by when they began.
class Records {
 public:
  void add(const std::vector<RecordPart>& parts) {
    for (const RecordPart& part : parts) {
      std::string& record = records_[part.begun];
      if (!record.empty()) record.resize(record.size() - tern_onboard::kRecordEnd);
      record.append(part.bytes.begin(), part.bytes.end());
    }
  }
  std::size_t count() const { return records_.size(); }
  std::vector<FlightReplay> replays() const {
    std::vector<FlightReplay> replays;
    for (const auto& [begun, record] : records_) replays.push_back(tern_host::replay_flight(record));
    return replays;
  }

 private:
  std::map<std::int64_t, std::string> records_;
};

std::string read(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(OnboardRecording, ReplaysAFlightInWhichMuchGoesWrong) {
  Sky sky("P25:20001");
  Records records;
  sky.onboard.record_flights();
  sky.onboard.add_known_points({{1.0, 9.0, 1.0}, {1.2, 9.0, 1.0}});
  const auto steps = [&](int count) {
    for (int k = 0; k < count; ++k) sky.step();
    records.add(sky.onboard.take_record());
  };
  ASSERT_TRUE(sky.begin().ok);
  steps(150);
  sky.jump({1.3, -0.8, 0.4});
  sky.off = {0.0, 0.0, 0.9 * sky.world.settings.tracking_margin};
  steps(100);
  sky.poses = false;
  steps(100);
  sky.poses = true;
  sky.onboard.add_known_points({{2.0, 9.0, 1.0}});
  sky.onboard.set_yaw(tern::FlightYawMode::kAlongMotion, {}, 0.0);
  steps(50);
  sky.now -= 3000 * kMs;
  steps(100);
  sky.now += 80 * kMs;  // ticks are skipped
  sky.onboard.stop();
  steps(100);
  sky.onboard.set_goal(sky.world.start, sky.now);
  steps(100);
  ASSERT_EQ(records.count(), 1u);
  const FlightReplay replay = records.replays()[0];
  EXPECT_EQ(replay.difference, "");
  EXPECT_EQ(replay.ticks, static_cast<int>(sky.onboard.status(sky.now).ticks));
  EXPECT_GT(replay.ticks, 600);
  EXPECT_GT(replay.frames, 50);
}

TEST(OnboardRecording, GivesEachFlightARecord) {
  Sky sky("P25:20001");
  sky.onboard.record_flights();
  ASSERT_TRUE(sky.begin().ok);
  for (int k = 0; k < 20; ++k) sky.step();
  sky.onboard.set_following(false);
  for (int k = 0; k < 5; ++k) sky.step();
  EXPECT_FALSE(sky.onboard.begin(sky.now).ok);
  sky.onboard.set_following(true);
  ASSERT_TRUE(sky.onboard.begin(sky.now).ok);
  for (int k = 0; k < 30; ++k) sky.step();
  Records records;
  records.add(sky.onboard.take_record());
  EXPECT_TRUE(sky.onboard.take_record().empty());
  ASSERT_EQ(records.count(), 2u);
  const std::vector<FlightReplay> replays = records.replays();
  EXPECT_EQ(replays[0].difference + replays[1].difference, "");
  EXPECT_EQ(replays[0].ticks, 20);
  EXPECT_EQ(replays[1].ticks, 30);
}

TEST(OnboardRecording, HasNoRecordOfAFlightThatIsRefused) {
  Sky sky("P25:20001", [](tern_onboard::Settings& settings) { settings.fly.ground = 0.0; });
  sky.onboard.record_flights();
  sky.position.z = 0.1;
  EXPECT_FALSE(sky.begin().ok);
  EXPECT_TRUE(sky.onboard.take_record().empty());
}

TEST(OnboardRecording, EndsWhereItsRoomIsFullAndSaysSo) {
  Sky sky("P25:20001");
  sky.onboard.record_flights(100000);
  ASSERT_TRUE(sky.begin().ok);
  for (int k = 0; k < 200; ++k) sky.step();
  Records records;
  records.add(sky.onboard.take_record());
  ASSERT_EQ(records.count(), 1u);
  const FlightReplay replay = records.replays()[0];
  EXPECT_EQ(replay.difference, "");
  EXPECT_GT(replay.ticks, 0);
  EXPECT_LT(replay.ticks, 200);
  int said = 0;
  for (const tern_onboard::Notice& notice : sky.onboard.take_notices()) {
    said += notice.text.find("the record of this flight ends here") != std::string::npos ? 1 : 0;
  }
  EXPECT_EQ(said, 1);
}

TEST(OnboardRecording, WritesFilesThatAreWholeAfterEachSave) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "tern_records";
  std::filesystem::remove_all(folder);
  Sky sky("P25:20001");
  tern_onboard::RecordFiles files(sky.onboard, folder.string());
  ASSERT_TRUE(sky.begin().ok);
  for (int ticks = 20; ticks <= 60; ticks += 20) {
    for (int k = 0; k < 20; ++k) sky.step();
    EXPECT_EQ(files.save(), "");
    const FlightReplay replay = tern_host::replay_flight(read(folder / "flight_5.000.record"));
    EXPECT_EQ(replay.difference, "");
    EXPECT_EQ(replay.ticks, ticks);
  }
  std::filesystem::remove_all(folder);
  std::ofstream(folder) << "a file";
  sky.onboard.set_following(false);
  sky.onboard.set_following(true);
  sky.now += 10 * kMs;
  ASSERT_TRUE(sky.begin().ok);
  EXPECT_NE(files.save().find("cannot be written"), std::string::npos);
  EXPECT_EQ(files.save(), "");
  EXPECT_THROW(tern_onboard::RecordFiles(sky.onboard, folder.string()), std::invalid_argument);
}

}  // namespace
