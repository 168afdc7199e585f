// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fleets that are larger than there is room for.
#include "tern/fleet.hpp"

#include <gtest/gtest.h>

namespace {

TEST(FleetFull, AsManyNeighboursAsThereIsRoomFor) {
  tern::FleetSpec spec;
  spec.id = 100;
  spec.incarnation = 1;
  spec.radius = 0.5;
  spec.tick = 1;
  tern::Trajectory rest{};
  rest.count = 1;
  rest.segments[0].duration = 1.0;
  tern::Fleet fleet;
  ASSERT_EQ(fleet.begin(spec, rest, 0), tern::Status::kOk);
  for (std::uint16_t id = 1; id <= tern::kMaxNeighbours; ++id) ASSERT_EQ(fleet.add(id, 0), tern::Status::kOk);
  EXPECT_EQ(fleet.add(99, 0), tern::Status::kNeighboursFull);
  EXPECT_EQ(fleet.add(1, 0), tern::Status::kOk) << "it is a member already";
  EXPECT_EQ(fleet.neighbours(), tern::kMaxNeighbours);
}

tern::FleetSpec in_range_of(std::uint16_t id) {
  tern::FleetSpec spec;
  spec.id = id;
  spec.incarnation = 1;
  spec.radius = 0.5;
  spec.tick = 100'000'000;
  spec.range.join = 10.0;
  spec.range.heard = 1000.0;
  spec.range.speed = 1.0;
  spec.range.within = 1'000'000'000;
  spec.range.lease = 5'000'000'000;
  return spec;
}

/// A vehicle at rest, and others on a line, as far away as the test says.
class FleetFullOfBeacons : public testing::Test {
 protected:
  FleetFullOfBeacons() { EXPECT_EQ(fleet_.begin(in_range_of(1000), rest_at(0.0), 0), tern::Status::kOk); }
  static tern::Trajectory rest_at(double x) {
    tern::Trajectory rest{};
    rest.count = 1;
    rest.origin = {x, 0.0, 0.0};
    rest.segments[0].duration = 1.0;
    return rest;
  }
  void advance() {
    now_ += 100'000'000;
    tern::Work work(10000);
    fleet_.advance(now_, work);
  }
  void hear(std::uint16_t id, double x) {
    static tern::Fleet other;
    ASSERT_EQ(other.begin(in_range_of(id), rest_at(x), now_), tern::Status::kOk);
    std::uint8_t packet[tern::kFleetBeaconRoom];
    const std::int32_t size = other.write(packet, tern::kFleetBeaconRoom);
    ASSERT_GT(size, 0);
    fleet_.receive(packet, size, now_);
  }
  /// A plan that stays here for a second.
  tern::FleetReport announce() {
    EXPECT_EQ(fleet_.announce(rest_at(0.0), now_ + 100'000'000, now_), tern::Status::kOk);
    tern::Work work(10000);
    fleet_.advance(now_, work);
    return fleet_.report();
  }
  tern::Fleet fleet_;
  std::int64_t now_ = 0;
};

TEST_F(FleetFullOfBeacons, WhoIsLeftOutIsFartherThanPlansLead) {
  const auto hear_all = [this](double farthest) {
    for (int k = 0; k < 20; ++k) {
      advance();
      for (int id = 1; id <= tern::kMaxBeacons; ++id) hear(static_cast<std::uint16_t>(id), 20.0 + id);
      if (farthest > 0.0) hear(500, farthest);
    }
  };
  hear_all(0.0);
  EXPECT_TRUE(announce().cleared);
  hear_all(100.0);  // it is left out, and may come from beyond the others
  EXPECT_TRUE(announce().cleared);
  for (int id = 1; id <= tern::kMaxBeacons; ++id) hear(static_cast<std::uint16_t>(600 + id), 2.5);
  EXPECT_TRUE(announce().cleared) << "all others are clear of it";
  hear(700, 2.6);  // now one that is so near is left out
  EXPECT_EQ(announce().announcement, tern::Announcement::kDropped);
  EXPECT_EQ(fleet_.report().blocked, tern::FleetBlock::kUnheard);
}

TEST_F(FleetFullOfBeacons, TheNearestOnesAreMembers) {
  const auto hear_for = [this](int ticks, int from) {
    for (int k = 0; k < ticks; ++k) {
      for (int id = from; id <= tern::kMaxNeighbours + 1; ++id) hear(static_cast<std::uint16_t>(id), 2.0 * id);
      advance();
    }
  };
  const auto is_member = [this](int id) {
    bool is = false;
    for (int k = 0; k < fleet_.neighbours(); ++k) is = is || fleet_.neighbour(k).id == id;
    return is;
  };
  hear_for(5, 2);
  EXPECT_EQ(fleet_.neighbours(), tern::kMaxNeighbours);
  EXPECT_TRUE(is_member(tern::kMaxNeighbours + 1));
  hear_for(5, 1);  // one that is nearer takes the place of the farthest one, which was promised nothing yet
  EXPECT_EQ(fleet_.neighbours(), tern::kMaxNeighbours);
  EXPECT_TRUE(is_member(1));
  EXPECT_FALSE(is_member(tern::kMaxNeighbours + 1));
}

}  // namespace
