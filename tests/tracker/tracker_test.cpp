// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The tracker: its filter beside least squares over all of a thing's history, its matching beside all matchings, and
// what it makes of people in a hall.
#include "tern_tracker/tracker.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "support/random.hpp"
#include "tracker/crowd.hpp"
#include "tracker/matching.hpp"

namespace {

using tern_onboard::Sighting;
using tern_tracker::Tracker;
using tern_tracker::TrackerSettings;

constexpr std::int64_t kTenth = 100000000;

Sighting at(double x, double y, double deviation = 0.1) {
  Sighting sighting;
  sighting.position = {x, y, 1.0};
  sighting.deviation = deviation;
  return sighting;
}

/// The most that any choice of pairs gains.
double best_gain(std::size_t row, std::size_t rows, const std::vector<tern_tracker::Pair>& pairs, unsigned taken) {
  if (row == rows) return 0.0;
  double best = best_gain(row + 1, rows, pairs, taken);
  for (const tern_tracker::Pair& pair : pairs) {
    if (pair.row != row || (taken >> pair.column & 1u) != 0) continue;
    best = std::max(best, pair.gain + best_gain(row + 1, rows, pairs, taken | 1u << pair.column));
  }
  return best;
}

TEST(TrackerMatching, GainsAsMuchAsAnyMatching) {
  tern_test::Random random(5);
  for (int k = 0; k < tern_test::scaled(2000); ++k) {
    const auto rows = static_cast<std::size_t>(random.integer(0, 6)),
               columns = static_cast<std::size_t>(random.integer(0, 6));
    std::vector<tern_tracker::Pair> pairs;
    for (std::size_t row = 0; row < rows; ++row) {
      for (std::size_t column = 0; column < columns; ++column) {
        // Whole gains make ties.
        if (random.chance(0.6)) pairs.push_back({row, column, random.chance(0.5) ? random.real(0.01, 30.0) : 7.0});
      }
    }
    const std::vector<std::size_t> matched = tern_tracker::best_matching(rows, columns, pairs);
    ASSERT_EQ(matched.size(), rows);
    double gain = 0.0;
    unsigned taken = 0;
    for (std::size_t row = 0; row < rows; ++row) {
      if (matched[row] == tern_tracker::kNoColumn) continue;
      ASSERT_EQ(taken >> matched[row] & 1u, 0u) << "a column is taken twice";
      taken |= 1u << matched[row];
      const auto is_it = [&](const tern_tracker::Pair& p) { return p.row == row && p.column == matched[row]; };
      const auto pair = std::find_if(pairs.begin(), pairs.end(), is_it);
      ASSERT_NE(pair, pairs.end());
      gain += pair->gain;
    }
    EXPECT_NEAR(gain, best_gain(0, rows, pairs, 0), 1e-5);
  }
}

/// The first place and velocity and all pushes are unknowns with deviations; so are the errors of detections. Least
/// squares over all of them gives the filter's numbers.
TEST(Tracker, ItsFilterIsLeastSquaresOverAllDetections) {
  constexpr int kScans = 7;
  constexpr double kDeviation = 0.2, kSpeed = 1.5, kPush = 3.0;  // of a person
  tern_test::Random random(3);
  for (int k = 0; k < tern_test::scaled(200); ++k) {
    Tracker tracker;
    double times[kScans] = {0.0}, places[kScans];
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(2 * kScans + 1, kScans + 1);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(2 * kScans + 1);
    // What place and velocity are, of the unknowns: place, velocity, and the pushes between scans.
    Eigen::RowVectorXd place = Eigen::RowVectorXd::Zero(kScans + 1), speed = place;
    place(0) = speed(1) = 1.0;
    Sighting told;
    for (int n = 0; n < kScans; ++n) {
      const double dt = n == 0 ? 0.0 : 0.05 * random.integer(1, 3);
      if (n > 0) times[n] = times[n - 1] + dt;
      place += dt * speed;
      if (n > 0) {
        place(n + 1) += 0.5 * dt * dt * kPush;
        speed(n + 1) += dt * kPush;
        rows(kScans + n, n + 1) = 1.0;  // a push has the deviation 1, in units of kPush
      }
      places[n] = 5.0 + 0.8 * times[n] + random.real(-0.2, 0.2);
      rows.row(n) = place / kDeviation;
      right(n) = places[n] / kDeviation;
      const auto said = tracker.scan(std::llround(1e9 * times[n]), {at(places[n], 2.0, kDeviation)});
      if (!said.empty()) told = said[0];
    }
    rows(2 * kScans, 1) = 1.0 / kSpeed;
    const Eigen::MatrixXd information = rows.transpose() * rows;
    const Eigen::VectorXd best = information.ldlt().solve(rows.transpose() * right);
    const Eigen::MatrixXd covariance = information.inverse();
    EXPECT_NEAR(told.position.x, (place * best)(0), 1e-9);
    EXPECT_NEAR(told.velocity.x, (speed * best)(0), 1e-9);
    EXPECT_NEAR(told.deviation, std::sqrt((place * covariance * place.transpose())(0)), 1e-9);
    EXPECT_NEAR(told.speed_deviation, std::sqrt((speed * covariance * speed.transpose())(0)), 1e-9);
    EXPECT_NEAR(told.velocity.y, 0.0, 1e-9);
  }
}

TEST(Tracker, ATrackIsBornWithItsSecondDetectionAndKeepsItsName) {
  Tracker tracker;
  EXPECT_TRUE(tracker.scan(0, {at(1.0, 1.0)}).empty());
  EXPECT_EQ(tracker.count(), 0u);
  auto told = tracker.scan(kTenth, {at(1.1, 1.0)});
  ASSERT_EQ(told.size(), 1u);
  const std::string name = told[0].name;
  EXPECT_EQ(told[0].stamp, kTenth);
  EXPECT_TRUE(told[0].has_velocity);
  EXPECT_EQ(tracker.count(), 1u);
  // Missed for 0.8 s, it goes on as the same; for 1.1 s, it ends.
  told = tracker.scan(9 * kTenth, {at(1.9, 1.0)});
  ASSERT_EQ(told.size(), 1u);
  EXPECT_EQ(told[0].name, name);
  EXPECT_TRUE(tracker.scan(20 * kTenth, {at(3.0, 1.0)}).empty());
  EXPECT_EQ(tracker.count(), 0u);
  EXPECT_NE(tracker.scan(21 * kTenth, {at(3.1, 1.0)}).at(0).name, name);
  EXPECT_TRUE(tracker.scan(21 * kTenth, {at(3.1, 1.0)}).empty()) << "no newer";
  EXPECT_TRUE(tracker.scan(0, {at(3.1, 1.0)}).empty()) << "the clock was set back: a track begins";
  EXPECT_EQ(tracker.scan(kTenth, {at(3.1, 1.0)}).size(), 1u);
}

TEST(Tracker, OneDetectionOfNothingIsNoTrack) {
  Tracker tracker;
  for (int k = 0; k < 20; ++k) EXPECT_TRUE(tracker.scan(4 * k * kTenth, {at(5.0, 5.0)}).empty()) << k;
  TrackerSettings at_once;
  at_once.hits = 1;
  Tracker eager(at_once);
  const auto told = eager.scan(0, {at(5.0, 5.0)});
  ASSERT_EQ(told.size(), 1u);
  EXPECT_EQ(told[0].speed_deviation, 1.5) << "half a person's speed";
}

TEST(Tracker, TwoThatPassKeepTheirNamesAndClasses) {
  Tracker tracker;
  std::string names[2];
  for (int k = 0; k < 41; ++k) {
    Sighting man = at(0.1 * k, 0.0), dog = at(4.0 - 0.1 * k, 0.7);
    dog.kind = k % 4 == 1 ? tern::TrackClass::kPerson : tern::TrackClass::kCyclist;  // not always told
    std::vector<Sighting> both{man, dog};
    if (k % 2 == 0) std::swap(both[0], both[1]);
    for (const Sighting& told : tracker.scan(k * kTenth, both)) {
      const int who = told.position.y > 0.35 ? 1 : 0;
      if (names[who].empty()) names[who] = told.name;
      EXPECT_EQ(told.name, names[who]) << k;
      if (k > 3) {
        EXPECT_EQ(told.kind, who == 1 ? tern::TrackClass::kCyclist : tern::TrackClass::kPerson) << k;
      }
    }
  }
  EXPECT_EQ(tracker.count(), 2u);
  EXPECT_NE(names[0], names[1]);
}

/// The figures of port/tracker/README.md, for 5 people, with room for other seeds.
TEST(Tracker, KnowsThePeopleInAHall) {
  tern_test::CrowdFigures sum;
  for (int seed = 1; seed <= tern_test::scaled(20); ++seed) {
    tern_test::CrowdSettings settings;
    settings.seed = static_cast<std::uint64_t>(100 + seed);
    Tracker tracker;
    sum.add(tern_test::Crowd(settings).watch(tracker));
  }
  EXPECT_GT(sum.born, 5);
  EXPECT_LT(sum.born_late, 0.1 * sum.born);
  EXPECT_LT(static_cast<double>(sum.unknown - sum.unseen), 0.02 * static_cast<double>(sum.instants));
  EXPECT_LT(sum.switches, 2.0 * sum.minutes());
  EXPECT_LT(sum.ghosts, 0.002 * sum.reports);
  EXPECT_LT(static_cast<double>(sum.outside), 0.005 * static_cast<double>(sum.held));
}

}  // namespace
