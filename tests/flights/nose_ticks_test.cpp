// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The nose in flight however ticks come: yaw, rate and acceleration are looked at every millisecond, with ticks that
// are skipped, late, early or doubled, and with wishes, goals, stops and threats at any time.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/flight_room.hpp"
#include "support/random.hpp"

namespace {

using namespace tern;
using tern_test::FlightRoom;
using tern_test::Random;

constexpr std::int64_t kLook = 1000000;

/// Ticks of a vehicle's computer: of each pattern, nanoseconds from one to the next.
enum class Ticks { kRegular, kSkipped, kJittery, kSlow, kDoubled, kBursts, kCount };

std::int64_t next_gap(Ticks pattern, std::int64_t tick, int number, Random& random) {
  switch (pattern) {
    case Ticks::kSkipped:
      return tick * (random.chance(0.1) ? random.integer(2, 20) : 1);
    case Ticks::kJittery:
      return tick + random.integer(-4000000, 4000000);
    case Ticks::kSlow:
      return tick * random.integer(8, 30);
    case Ticks::kDoubled:
      return random.chance(0.3) ? 0 : tick;
    case Ticks::kBursts:
      return number % 5 == 0 ? 12 * tick : 1 + tick / 20;
    default:
      return tick;
  }
}

/// Holds the nose to its limits, and to turn by what they allow from one look to the next.
class NoseLooks {
 public:
  NoseLooks(const Flight& flight, double rate, double acceleration)
      : flight_(flight), rate_(rate), acceleration_(acceleration), last_(flight.yaw(0)) {}

  void look(std::int64_t t) {
    const YawSample now = flight_.yaw(t);
    const double step = 1e-9 * static_cast<double>(t - time_);
    ASSERT_LE(std::abs(now.yaw.rate), rate_ + 1e-9) << t;
    ASSERT_LE(std::abs(now.acceleration), acceleration_ + 1e-6) << t;
    ASSERT_LE(std::abs(now.yaw.rate - last_.yaw.rate), acceleration_ * step + 1e-9) << t;
    const double mean = 0.5 * (now.yaw.rate + last_.yaw.rate);
    ASSERT_LE(std::abs(now.angle - last_.angle - mean * step), 0.25 * acceleration_ * step * step + 1e-9) << t;
    ASSERT_NEAR(now.yaw.cosine, std::cos(now.angle), 1e-9) << t;
    ASSERT_NEAR(now.yaw.sine, std::sin(now.angle), 1e-9) << t;
    turned_ += std::abs(now.angle - last_.angle);
    last_ = now;
    time_ = t;
  }
  void look_until(std::int64_t t) {
    while (time_ + kLook < t && !testing::Test::HasFatalFailure()) look(time_ + kLook);
    look(t);
  }
  /// Nothing has moved: at one instant, before and after a tick or a takeover.
  void stays(const YawSample& now, std::int64_t t) {
    ASSERT_NEAR(now.angle, last_.angle, 1e-9) << t;
    ASSERT_NEAR(now.yaw.rate, last_.yaw.rate, 1e-9) << t;
    ASSERT_NEAR(now.acceleration, last_.acceleration, 1e-6 * acceleration_) << t;
  }
  void tick_at(FlightRoom& room, std::int64_t t) {
    look_until(t);
    const YawSample ahead = flight_.yaw(t + room.spec.tick);
    ASSERT_EQ(room.flight.tick(t, room.report), Status::kOk);
    stays(flight_.yaw(t), t);
    look(t);
    // What is planned up to the next tick stays as well.
    ASSERT_NEAR(ahead.angle, flight_.yaw(t + room.spec.tick).angle, 1e-9) << t;
    check_takeover(room.state());
  }
  double turned() const { return turned_; }

 private:
  void check_takeover(const FlightState& state) {
    if (!state.nose.has_waiting || state.nose.waiting.begin <= time_) return;
    const YawSample before = flight_.yaw(state.nose.waiting.begin - 1);
    const YawSample after = flight_.yaw(state.nose.waiting.begin);
    ASSERT_NEAR(before.angle, after.angle, 1e-9 * rate_ + 1e-9);
    ASSERT_NEAR(before.yaw.rate, after.yaw.rate, 1e-9 * acceleration_ + 1e-9);
    // In a nanosecond an acceleration may go a long way only where the rate is at its limit.
    const bool at_limit = std::abs(after.yaw.rate) > 0.99 * rate_;
    if (at_limit) return;
    ASSERT_NEAR(before.acceleration, after.acceleration, 1e-4 * acceleration_);
  }

  const Flight& flight_;
  double rate_;
  double acceleration_;
  YawSample last_;
  std::int64_t time_ = 0;
  double turned_ = 0.0;
};

struct Headings {
  std::vector<Heading> list;
};

FlightYaw any_wish(Random& random, double acceleration, Headings& kept) {
  const auto heading = [&random] {
    const double angle = random.real(-M_PI, M_PI);
    return Heading{std::cos(angle), std::sin(angle)};
  };
  FlightYaw yaw{};
  yaw.mode = static_cast<FlightYawMode>(random.integer(0, 4));
  yaw.acceleration_max = acceleration;
  yaw.field_of_view = random.chance(0.5) ? 1.5 : 0.0;
  yaw.start = heading();
  yaw.heading = heading();
  yaw.point = {random.real(-4.0, 4.0), random.real(-4.0, 4.0), 1.0};
  for (Heading& h : kept.list) h = heading();
  yaw.headings = kept.list.data();
  yaw.heading_count = static_cast<std::int32_t>(kept.list.size());
  return yaw;
}

void set_any_goal(FlightRoom& room, Random& random) {
  Via points[3];
  for (Via& point : points) point.position = {random.real(-8.0, 8.0), random.real(-8.0, 8.0), 1.0};
  ASSERT_EQ(room.flight.set_mission(points, random.integer(1, 3), ViaPolicy::kSkip), Status::kOk);
}

/// Something appears on the way.
void threaten(FlightRoom& room, const Vec3& at, const Vec3& v) {
  const Vec3 p{at.x + 0.9 * v.x, at.y + 0.9 * v.y, at.z};
  const double away = std::hypot(p.x - at.x, p.y - at.y);
  if (away < 1.0 || room.map().busy()) return;
  room.mark({{p.x - 0.1, p.y - 0.1, 0.0}, {p.x + 0.1, p.y + 0.1, 2.0}});
}

FlightSpec any_spec(Random& random) {
  FlightSpec spec = FlightRoom::flight_spec(static_cast<std::uint32_t>(random.integer(256, 4000)));
  spec.yaw_rate = random.real(1.0, 12.0);
  return spec;
}

void fly(std::uint64_t seed) {
  Random random(seed);
  FlightRoom room(any_spec(random));
  const double acceleration = random.real(2.0, 100.0);
  const auto pattern = static_cast<Ticks>(seed % static_cast<std::uint64_t>(Ticks::kCount));
  Headings kept{std::vector<Heading>(3)};
  ASSERT_EQ(room.flight.set_yaw(any_wish(random, acceleration, kept)), Status::kOk);
  NoseLooks nose(room.flight, room.spec.yaw_rate, acceleration);
  std::int64_t t = 0;
  for (int k = 0; t < 25000000000 && !testing::Test::HasFatalFailure(); ++k) {
    nose.tick_at(room, t);
    if (k == 0 || random.chance(0.01)) set_any_goal(room, random);
    if (random.chance(0.02)) room.flight.set_yaw(any_wish(random, acceleration, kept));
    if (random.chance(0.002)) room.flight.stop();
    const Sample now = room.flight.command(t).sample;
    if (random.chance(0.002)) threaten(room, now.position, now.velocity);
    t += next_gap(pattern, room.spec.tick, k, random);
  }
  EXPECT_GT(nose.turned(), 1.0) << seed;
}

TEST(FlightNoseTicks, NoStepHoweverTicksCome) {
  for (int k = 0; k < tern_test::scaled(24) && !testing::Test::HasFatalFailure(); ++k) {
    SCOPED_TRACE(k);
    fly(5100 + static_cast<std::uint64_t>(k));
  }
}

/// A third of a turn further each time: a nose that turns the shorter way goes round and round.
TEST(FlightNoseTicks, AngleCountsWholeTurns) {
  FlightSpec spec = FlightRoom::flight_spec();
  spec.yaw_rate = 10.0;
  FlightRoom room(spec);
  FlightYaw yaw{};
  yaw.mode = FlightYawMode::kFixed;
  yaw.acceleration_max = 100.0;
  yaw.start = yaw.heading = {-1.0, 0.0};
  ASSERT_EQ(room.flight.set_yaw(yaw), Status::kOk);
  NoseLooks nose(room.flight, spec.yaw_rate, yaw.acceleration_max);
  const double first = room.flight.yaw(0).angle;
  std::int64_t t = 0;
  constexpr int kThirds = 30;
  for (int k = 1; k <= kThirds && !testing::Test::HasFatalFailure(); ++k) {
    const double angle = M_PI + k * 2.0 * M_PI / 3.0;
    yaw.heading = {std::cos(angle), std::sin(angle)};
    ASSERT_EQ(room.flight.set_yaw(yaw), Status::kOk);
    for (int i = 0; i < 150; ++i, t += spec.tick) nose.tick_at(room, t);
  }
  EXPECT_NEAR(std::abs(first), M_PI, 1e-12);
  EXPECT_NEAR(room.flight.yaw(t).angle - first, kThirds * 2.0 * M_PI / 3.0, 0.2);  // a short plan ends a little off
}

/// A point that moves is told at every tick; pending plans go on all the same.
TEST(FlightNoseTicks, WishThatChangesAtEveryTickIsFollowed) {
  FlightRoom room;
  FlightYaw yaw{};
  yaw.mode = FlightYawMode::kTowardsPoint;
  yaw.acceleration_max = 5.0;
  yaw.start = {1.0, 0.0};
  std::int64_t t = 0;
  double angle = 0.0;
  for (int k = 0; k < 1500; ++k, t += room.spec.tick) {
    angle = 0.003 * k;
    yaw.point = {room.start.x + 5.0 * std::cos(angle), room.start.y + 5.0 * std::sin(angle), 0.0};
    ASSERT_EQ(room.flight.set_yaw(yaw), Status::kOk);
    ASSERT_EQ(room.flight.tick(t, room.report), Status::kOk);
  }
  EXPECT_NEAR(room.flight.yaw(t).angle, angle, 0.5);
}

/// However far ticks are apart, as long as they come evenly.
TEST(FlightNoseTicks, SlowTicksTurnTheNose) {
  for (const int every : {2, 10, 100, 900}) {
    FlightRoom room;
    FlightYaw yaw{};
    yaw.mode = FlightYawMode::kFixed;
    yaw.acceleration_max = 5.0;
    yaw.start = {1.0, 0.0};
    yaw.heading = {0.0, 1.0};
    ASSERT_EQ(room.flight.set_yaw(yaw), Status::kOk);
    std::int64_t t = 0;
    for (int k = 0; k < 40 || t < 6000000000; ++k, t += every * room.spec.tick) {
      ASSERT_EQ(room.flight.tick(t, room.report), Status::kOk);
    }
    EXPECT_NEAR(room.flight.yaw(t).angle, 0.5 * M_PI, 0.01) << every;
  }
}

}  // namespace
