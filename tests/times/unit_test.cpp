// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "times/time_unit.hpp"

namespace tern_test {
namespace {

using tern::Chain;
using tern::Corridor;
using tern::Limits;

class TimeUnit : public testing::Test {
 protected:
  TimeUnit() : corridor_(new Corridor{}), chain_(new Chain{}) {}
  /// `count` legs of `length` metres each along x.
  void legs(int count, double length) {
    for (int i = 0; i < count; ++i) {
      corridor_->polyhedra[i].from = {length * i, 0.0, 0.0};
      corridor_->polyhedra[i].to = {length * (i + 1), 0.0, 0.0};
    }
    corridor_->count = count;
  }
  double unit(double v, double a) const { return unit(Limits{{v, v, v}, {a, a, a}}); }
  double unit(const Limits& limits) const { return tern::time_unit(*chain_, *corridor_, limits); }

  std::unique_ptr<Corridor> corridor_;
  std::unique_ptr<Chain> chain_;
};

TEST_F(TimeUnit, IsOfTheLimitsOnALongWay) {
  legs(1, 100.0);
  EXPECT_NEAR(unit(2.0, 2.0), 4.0, 1e-12);  // 2^6 / 2^4
  EXPECT_NEAR(unit(1.0, 2.0), 64.0, 1e-12);
  EXPECT_NEAR(unit(2.0, 1.0), 1.0 / 16.0, 1e-12);
}

TEST_F(TimeUnit, IsOfWhatAShortWayHasRoomFor) {
  legs(1, 8.0);  // 1/2 sqrt(2 * 8) = 2 m/s
  EXPECT_NEAR(unit(2.0, 2.0), 4.0, 1e-12);
  for (const double v : {3.0, 20.0, 1000.0}) EXPECT_NEAR(unit(v, 2.0), 4.0, 1e-12) << v;
}

TEST_F(TimeUnit, IsOfWhatShortLegsHaveRoomFor) {
  legs(16, 0.5);  // sqrt(2 * 0.5) = 1 m/s, less than the 2 m/s of the whole way
  EXPECT_NEAR(unit(20.0, 2.0), 64.0, 1e-9);
}

TEST_F(TimeUnit, AgilityIsTheMeanLegOverTheWayToFullSpeedAndBack) {
  legs(4, 6.0);  // from rest to 2 m/s and back to rest takes 2 m at 2 m/s^2
  const auto agility = [&](double v, double a) {
    return tern::agility(*chain_, *corridor_, Limits{{v, v, v}, {a, a, a}});
  };
  EXPECT_NEAR(agility(2.0, 2.0), 3.0, 1e-12);
  EXPECT_NEAR(agility(2.0, 10.0), 15.0, 1e-12);
  EXPECT_NEAR(agility(1.0, 2.0), 12.0, 1e-12);
  // Where the way has room for less than the limit, a fourth of the whole way counts, or the mean leg.
  EXPECT_NEAR(agility(20.0, 2.0), 1.0, 1e-12);
}

TEST_F(TimeUnit, ALimitAcrossTheWayHasNoSay) {
  legs(1, 100.0);
  EXPECT_EQ(unit(Limits{{2.0, 2.0, 2.0}, {2.0, 2.0, 2.0}}), unit(Limits{{2.0, 9.0, 9.0}, {2.0, 9.0, 9.0}}));
}

TEST_F(TimeUnit, AMovingEndCountsAsTheWayToStop) {
  legs(1, 0.0);
  chain_->start.d[1] = {2.0, 0.0, 0.0};  // stops within 1 m: 1/2 sqrt(2 * 1) = 0.707 m/s, to the fourth 1/4
  EXPECT_NEAR(unit(5.0, 2.0), 256.0, 1e-9);
  chain_->goal.d[1] = {0.0, 2.0, 0.0};  // 2 m together, to the fourth 1
  EXPECT_NEAR(unit(5.0, 2.0), 64.0, 1e-9);
}

TEST_F(TimeUnit, NoWayAtAllHasAUnit) {
  legs(1, 0.0);
  EXPECT_NEAR(unit(5.0, 2.0), 64.0 / 1e-4, 1e-6);  // 0.1 m/s: 2 m/s^2 for 0.05 s
}

}  // namespace
}  // namespace tern_test
