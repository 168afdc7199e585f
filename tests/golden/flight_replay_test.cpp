// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Contract F5: a flight that was recorded, frames and ticks, replays to the same commands, bit for bit; and the same
// flight has one hash on every target.
#include <gtest/gtest.h>

#include <memory>
#include <utility>
#include <vector>

#include "golden/flight_run.hpp"
#include "golden/golden_hash.hpp"

namespace {

using namespace tern_golden;

using SmallMemory = FlightMemory<40000, 80000>;

struct Recording {
  std::vector<std::pair<int, FlightFrame>> frames;
};

/// Takes frames and keeps them.
struct Recorder {
  PillarCamera camera;
  Recording& recording;
  void take(int tick, const FlightSetting& s, const tern::Vec3& eye, const Heading& heading, FlightFrame& frame) {
    camera.take(tick, s, eye, heading, frame);
    recording.frames.emplace_back(tick, frame);
  }
};

/// Gives the frames of a recording, whatever the world is like.
struct Player {
  const Recording& recording;
  std::size_t next = 0;
  void take(int tick, const FlightSetting&, const tern::Vec3&, const Heading&, FlightFrame& frame) {
    ASSERT_LT(next, recording.frames.size());
    ASSERT_EQ(recording.frames[next].first, tick);
    frame = recording.frames[next++].second;
  }
};

const auto kNoCount = [] { return std::uint64_t{0}; };

TEST(FlightReplay, ARecordedFlightReplaysToTheSameCommands) {
  const auto memory = std::make_unique<SmallMemory>();
  Recording recording;
  Recorder recorder{{}, recording};
  const auto see = [](const tern::FlightReport&, const tern::FlightReport& report, std::uint64_t) {
    EXPECT_LE(report.work, kSmallFlight.work_per_tick);
  };
  const FlightTotals flown = fly(kSmallFlight, *memory, recorder, recorder.camera.world, kNoCount, see);
  ASSERT_EQ(flown.started, tern::Status::kOk);
  EXPECT_GT(flown.committed, 10u);
  EXPECT_GT(flown.arrived, 0);
  EXPECT_GT(flown.threatened, 0);
  EXPECT_GT(recording.frames.size(), 100u);
  EXPECT_EQ(flown.hash, kGoldenFlightHash);
  Player player{recording};
  PillarWorld nothing;
  const FlightTotals replayed = fly(kSmallFlight, *memory, player, nothing, kNoCount, see);
  EXPECT_EQ(player.next, recording.frames.size());
  EXPECT_EQ(replayed.hash, flown.hash);
}

}  // namespace
