// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Plans as bytes: the layout, byte by byte; that a vehicle is in the tube that its message describes, whatever the
// clock does; and that no bytes are read that are no plan.
#include "fleet/plan_bytes.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <vector>

#include "fleet/plans.hpp"

namespace {

using namespace tern_test;
using tern::kMaxPlanBytes;
using tern::kMaxSegments;
using tern::Track;
using tern::TrackPiece;
using tern::Trajectory;

struct Message {
  std::uint8_t bytes[kMaxPlanBytes] = {};
  std::int32_t size = 0;
};

Message written(const Trajectory& plan, std::int64_t takeover) {
  Message message;
  message.size = tern::write_plan(plan, {7, 3, 5, takeover}, message.bytes);
  return message;
}

struct Tube {
  Tube(const Message& message, std::int64_t clock_error) {
    tern::read_plan(message.bytes, message.size, clock_error, pieces, track);
  }
  tern::Vec3 at(std::int64_t now) const {
    return place_at(pieces, track.piece_count, 1e-9 * static_cast<double>(now - track.measured));
  }

  TrackPiece pieces[kMaxSegments + 1] = {};
  Track track;
};

TEST(FleetPlanBytes, LayoutOfAPlan) {
  Trajectory plan = straight({1.0, 2.0, 3.0}, {1.5, 2.0, 2.0}, 1000, 4.0);
  const Message message = written(plan, 0x0102030405060708);
  ASSERT_EQ(message.size, 54 + 8 + 8 * 6);
  // Version 1, kind 1; id, incarnation, number, takeover, begin.
  std::vector<std::uint8_t> expected = {0x11, 7, 0, 3, 0, 0, 0, 5, 0, 0, 0, 8, 7, 6, 5, 4, 3, 2, 1};
  for (const std::uint8_t byte : {0xE8, 0x03, 0, 0, 0, 0, 0, 0}) expected.push_back(byte);
  EXPECT_EQ(std::vector<std::uint8_t>(message.bytes, message.bytes + 27), expected);
  // The origin, the exponent of the unit, 2^-14 m, and one segment.
  double origin[3];
  std::memcpy(origin, message.bytes + 27, sizeof origin);
  EXPECT_EQ(origin[0], 1.0);
  EXPECT_EQ(origin[2], 3.0);
  EXPECT_EQ(static_cast<std::int8_t>(message.bytes[51]), -14);
  EXPECT_EQ(message.bytes[52], 1);
  double duration = 0.0;
  std::memcpy(&duration, message.bytes + 54, sizeof duration);
  EXPECT_EQ(duration, 4.0);
  // The last point: 0.5, 0 and -1 m in units of 2^-14 m are 8192, 0 and -16384.
  const std::vector<std::uint8_t> last = {0x00, 0x20, 0, 0, 0x00, 0xC0};
  EXPECT_EQ(std::vector<std::uint8_t>(message.bytes + message.size - 6, message.bytes + message.size), last);
}

TEST(FleetPlanBytes, TenSegmentsTake560Bytes) {
  EXPECT_EQ(tern::plan_bytes(10), 560);
  if (kMaxSegments < 10) return;
  Random random(1);
  EXPECT_EQ(written(wild(random, 10, 20.0), 1000 * kSecond).size, 560);
}

TEST(FleetPlanBytes, NameComesBack) {
  const Message message = written(straight({}, {1, 1, 1}, -5, 2.0), 77);
  const tern::PlanName name = tern::read_name(message.bytes, message.size);
  EXPECT_EQ(name.id, 7);
  EXPECT_EQ(name.incarnation, 3u);
  EXPECT_EQ(name.number, 5u);
  EXPECT_EQ(name.takeover, 77);
}

// The true place is within the tube's error at every time, also if the sender's clock is ahead or behind by all that it
// may be, before the beginning and after the end.
TEST(FleetPlanBytes, TheVehicleIsInItsTube) {
  Random random(2);
  double most = 0.0;
  for (int turn = 0; turn < scaled(300); ++turn) {
    const Trajectory plan = wild(random, random.integer(1, kMaxSegments), random.real(0.1, 60.0));
    const std::int64_t clock_error = random.chance(0.3) ? 0 : random.integer(1, 50'000'000);
    const Message message = written(plan, plan.begin + random.integer(0, 1'000'000'000));
    ASSERT_TRUE(tern::is_plan(message.bytes, message.size));
    const Tube tube(message, clock_error);
    double all = 0.0;
    for (int s = 0; s < plan.count; ++s) all += plan.segments[s].duration;
    for (int sample = 0; sample < 200; ++sample) {
      const auto now = plan.begin + static_cast<std::int64_t>(1e9 * random.real(-1.0, all + 1.0));
      const std::int64_t off = random.chance(0.5) ? clock_error : -clock_error;
      const double apart = between(place_at(plan, now + off), tube.at(now));
      ASSERT_LE(apart, tube.track.error) << "turn " << turn;
      most = std::max(most, apart / tube.track.error);
    }
  }
  EXPECT_GT(most, 0.3) << "a tube that wide says nothing";
}

TEST(FleetPlanBytes, ErrorIsHalfADiagonalOfTheUnitAndTheClocksShare) {
  // 20 m at 16-bit points: units of 2^-10 m, 0.85 mm. The curve's hodograph has 7 * 20 / 10 m/s at most.
  const Message message = written(straight({}, {20, 0, 0}, 0, 10.0), 0);
  EXPECT_NEAR(Tube(message, 0).track.error, 0.00085, 0.00001);
  EXPECT_NEAR(Tube(message, 10'000'000).track.error, 0.00085 + 0.14, 0.0001);
  EXPECT_EQ(Tube(message, 10'000'000).track.measured, -10'000'000);
}

TEST(FleetPlanBytes, RefusesWhatCannotBeFlown) {
  const Trajectory good = straight({}, {1, 0, 0}, 100, 2.0);
  EXPECT_GT(written(good, 100).size, 0);
  EXPECT_EQ(written(good, 99).size, 0) << "taken over before it begins";
  Trajectory plan = good;
  plan.count = 0;
  EXPECT_EQ(written(plan, 100).size, 0);
  plan = good;
  plan.segments[0].points[6].x = 0.9;
  EXPECT_EQ(written(plan, 100).size, 0) << "ends in motion";
  plan = good;
  plan.segments[0].points[3].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(written(plan, 100).size, 0);
  plan = good;
  plan.segments[0].duration = 0.0;
  EXPECT_EQ(written(plan, 100).size, 0);
  plan = good;
  plan.origin.x = 1e10;
  EXPECT_EQ(written(plan, 100).size, 0);
  plan = straight({}, {200e3, 0, 0}, 100, 2.0);
  EXPECT_EQ(written(plan, 100).size, 0) << "beyond 32767 units of 4 m";
  if (kMaxSegments < 2) return;
  plan = good;
  plan.count = 2;
  plan.segments[1] = straight({}, {1, 0, 0}, 0, 1.0).segments[0];
  EXPECT_EQ(written(plan, 100).size, 0) << "a jump of a metre";
}

TEST(FleetPlanBytes, RefusesAlteredLengths) {
  Random random(3);
  const Message message = written(wild(random, kMaxSegments, 5.0), 2000 * kSecond);
  for (std::int32_t size = 0; size < message.size; ++size) EXPECT_FALSE(tern::is_plan(message.bytes, size));
  Message other = message;
  other.bytes[52] = static_cast<std::uint8_t>(kMaxSegments + 1);
  EXPECT_FALSE(tern::is_plan(other.bytes, tern::plan_bytes(kMaxSegments + 1)));
  other = message;
  other.bytes[0] = 0x21;
  EXPECT_FALSE(tern::is_plan(other.bytes, other.size)) << "another version";
}

// Whatever passes is_plan() can be read, and gives a tube of numbers.
TEST(FleetPlanBytes, ReadsNothingThatIsNoPlan) {
  Random random(4);
  int passed = 0;
  for (int turn = 0; turn < scaled(20000); ++turn) {
    Message message = written(wild(random, random.integer(1, kMaxSegments), 5.0), 2000 * kSecond);
    for (int k = random.integer(1, 4); k > 0; --k) {
      message.bytes[random.integer(0, message.size - 1)] = static_cast<std::uint8_t>(random.integer(0, 255));
    }
    if (!tern::is_plan(message.bytes, message.size)) continue;
    ++passed;
    const Tube tube(message, 1'000'000);
    EXPECT_TRUE(std::isfinite(tube.track.error));
    for (int p = 0; p < tube.track.piece_count; ++p) {
      EXPECT_GT(tube.pieces[p].duration, 0.0);
      for (const tern::Vec3& point : tube.pieces[p].points) EXPECT_TRUE(std::isfinite(point.x + point.y + point.z));
    }
  }
  EXPECT_GT(passed, 0);
}

}  // namespace
