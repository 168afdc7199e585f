// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Giving way before the flight, and operators who do so until all are accepted.
#include "host/intent/replan.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "host/intent/intent_operator.hpp"
#include "host/intent/intent_store.hpp"
#include "support/random.hpp"

namespace {

using tern_host::Proposal;
using tern_host::Remedy;
using tern_host::Scenario;
using tern_host::UtmEntity;
using tern_host::Zone;
using tern_test::Random;

const tern_host::LocalFrame kField({{47.0, 8.0}, 400.0});
const tern_host::Instant kNine = *tern_host::parse_instant("2026-03-02T09:00:00Z");

tern_host::ReplanSettings settings() {
  tern_host::ReplanSettings s;
  s.tube.epoch = kNine;
  s.tube.looseness = 5.0;
  s.tube.longest = 20.0;
  s.tube.clock_error = 0.5;
  s.longest_delay = 600.0;
  return s;
}

Scenario flight(const std::string& start, const std::string& goal) {
  return tern_host::parse_scenario("boundary -400 -400 0 400 400 120\nstart " + start + "\ngoal " + goal +
                                       "\nresolution 5\nradius 1\ntracking_margin 0.5\nv_max 10\na_max 3\n",
                                   "flight");
}

/// A wall of air from south to north, at x = 0.
UtmEntity wall(double south, double north, double low, double high, double from, double until) {
  UtmEntity e;
  e.id = "wall";
  Zone zone;
  zone.edges = tern_host::EdgeRule::kGeodesic;
  zone.areas.emplace_back();
  for (const auto& [x, y] : {std::pair{-10.0, south}, {10.0, south}, {10.0, north}, {-10.0, north}}) {
    zone.areas[0].ring.push_back(kField.point({x, y}));
  }
  zone.lower = {low, tern_host::HeightReference::kEllipsoid};
  zone.upper = {high, tern_host::HeightReference::kEllipsoid};
  const auto at = [](double s) { return kNine + static_cast<tern_host::Instant>(s * 1e9); };
  zone.times.push_back({at(from), at(until), {}});
  e.volumes.push_back(zone);
  return e;
}

std::vector<Proposal> propose(const Scenario& scenario, const std::vector<UtmEntity>& others, int priority = 0) {
  tern_host::Session session;
  UtmEntity like;
  like.id = "own";
  like.priority = priority;
  return proposals_of(session, scenario, like, others, kField, settings());
}

TEST(Replan, LeavesAFreePlanAsItIs) {
  const std::vector<Proposal> all = propose(flight("-300 0 50", "300 0 50"), {wall(-100, 100, 400, 500, 500, 600)});
  ASSERT_EQ(all.size(), 1u);
  EXPECT_TRUE(all[0].free);
  EXPECT_EQ(best_of(all), &all[0]);
}

TEST(Replan, WaitsWhereThatIsShortest) {
  // Closed from one end of the boundary to the other, at all heights, for 60 s.
  const std::vector<Proposal> all = propose(flight("-300 0 50", "300 0 50"), {wall(-500, 500, 300, 600, 0, 60)});
  const Proposal* const best = best_of(all);
  ASSERT_NE(best, nullptr);
  EXPECT_EQ(best->remedy, Remedy::kDelay);
  // It begins so late that the first volume that meets the wall begins after the wall has ended.
  EXPECT_GT(best->result.scenario.start_time, 10.0);
  EXPECT_LT(best->result.scenario.start_time, 60.6);
  EXPECT_NEAR(best->arrival - best->result.scenario.start_time, all[0].arrival, 1e-9) << "it is the same flight";
}

TEST(Replan, WaitsForItsOwnFencesToo) {
  // The start is closed by a fence of the scenario's own when the wall has ended, until 200 s.
  Scenario scenario = flight("-300 0 50", "300 0 50");
  tern_host::FenceRecord pad;
  tern::Halfspace planes[tern::kBoxPlanes];
  tern::box_planes({{-310, -10, 40}, {-290, 10, 60}}, planes);
  pad.planes.assign(planes, planes + tern::kBoxPlanes);
  pad.fence.kind = tern::FenceKind::kKeepOut;
  pad.fence.from = 20 * tern_host::kSecond;
  pad.fence.until = 200 * tern_host::kSecond;
  scenario.fences.push_back(pad);
  const std::vector<Proposal> all = propose(scenario, {wall(-500, 500, 300, 600, 0, 120)});
  EXPECT_TRUE(all[1].free) << proposals_text(all);
  EXPECT_NEAR(all[1].result.scenario.start_time, 200.0, 0.01);
}

TEST(Replan, ChangesTheLevelWhereThatIsShortest) {
  const std::vector<Proposal> all = propose(flight("-300 0 50", "300 0 50"), {wall(-500, 500, 440, 460, 0, 500)});
  const Proposal* const best = best_of(all);
  ASSERT_NE(best, nullptr) << proposals_text(all);
  EXPECT_EQ(best->remedy, Remedy::kLevel);
  EXPECT_EQ(best->result.scenario.start_time, 0.0);
  EXPECT_LT(best->arrival, all[0].arrival + 30.0);
}

TEST(Replan, GoesAroundWhereThatIsShortest) {
  const std::vector<Proposal> all = propose(flight("-300 0 50", "300 0 50"), {wall(-100, 20, 300, 600, 0, 500)});
  const Proposal* const best = best_of(all);
  ASSERT_NE(best, nullptr) << proposals_text(all);
  EXPECT_TRUE(best->remedy == Remedy::kDetour || best->remedy == Remedy::kLevel);
  EXPECT_TRUE(all[3].free) << proposals_text(all);
  EXPECT_EQ(best->arrival, std::min(all[2].arrival, all[3].arrival));
  EXPECT_LT(best->arrival, all[0].arrival + 30.0);
}

TEST(Replan, GoesAroundLaterWhereThatIsShortest) {
  // The start is closed for a minute, and the straight way for long.
  UtmEntity whole = wall(-500, 500, 300, 600, 0, 60);
  whole.id = "whole";
  const std::vector<Proposal> all = propose(flight("0 -300 50", "0 300 50"), {whole, wall(-100, 20, 300, 600, 0, 550)});
  const Proposal* const best = best_of(all);
  ASSERT_NE(best, nullptr) << proposals_text(all);
  EXPECT_TRUE(best->remedy == Remedy::kDetour || best->remedy == Remedy::kLevel);
  EXPECT_GT(best->result.scenario.start_time, 10.0);
  EXPECT_LT(best->result.scenario.start_time, 90.0);
  EXPECT_TRUE(all[1].free) << "a delay alone would do as well";
  EXPECT_GT(all[1].arrival, best->arrival + 300.0);
}

TEST(Replan, SaysThatNothingHelps) {
  // A wall without end in time, from the ground to beyond the boundary.
  const std::vector<Proposal> all = propose(flight("-300 0 50", "300 0 50"), {wall(-500, 500, 300, 600, 0, 5000)});
  ASSERT_EQ(all.size(), 4u);
  EXPECT_EQ(best_of(all), nullptr);
  EXPECT_NE(all[1].why_not.find("more than 600 s later, because of wall"), std::string::npos);
  EXPECT_NE(all[2].why_not.find("there is no plan"), std::string::npos);
  EXPECT_NE(proposals_text(all).find("detour: not free"), std::string::npos);
}

TEST(Replan, GoesFirstWithAHigherPriority) {
  const std::vector<Proposal> all = propose(flight("-300 0 50", "300 0 50"), {wall(-500, 500, 300, 600, 0, 5000)}, 1);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_TRUE(all[0].free);
}

TEST(IntentStore, WantsAllOvnsThatMatter) {
  tern_host::IntentStore store(kField);
  UtmEntity first = wall(-100, 100, 400, 500, 0, 60);
  const tern_host::StoreAnswer written = store.put(first, {});
  ASSERT_TRUE(written.accepted);
  EXPECT_GE(written.ovn.size(), 16u) << "as F3548 wants it";
  UtmEntity second = wall(0, 200, 400, 500, 30, 90);
  second.id = "second";
  tern_host::StoreAnswer answer = store.put(second, {});
  EXPECT_FALSE(answer.accepted);
  ASSERT_EQ(answer.missing.size(), 1u);
  EXPECT_EQ(answer.missing[0].ovn, written.ovn);
  EXPECT_TRUE(store.put(second, {written.ovn}).accepted);
  UtmEntity elsewhere = wall(300, 350, 400, 500, 30, 90);
  elsewhere.id = "elsewhere";
  EXPECT_TRUE(store.put(elsewhere, {}).accepted) << "nothing there matters";

  EXPECT_TRUE(store.put(first, key_of(store.relevant(first))).is_outdated) << "it does not say what it overwrites";
  first.ovn = written.ovn;
  const tern_host::StoreAnswer again = store.put(first, key_of(store.relevant(first)));
  ASSERT_TRUE(again.accepted);
  EXPECT_NE(again.ovn, written.ovn);
  second.ovn = store.relevant(first)[0].ovn;
  answer = store.put(second, {written.ovn});
  EXPECT_FALSE(answer.accepted) << "the first is another version by now";
}

tern_host::IntentOperator one(const std::string& id, const std::string& start, const std::string& goal) {
  UtmEntity like;
  like.id = id;
  return {flight(start, goal), like, kField, settings()};
}

TEST(Operators, ReplanUntilAllAreAccepted) {
  tern_host::IntentStore store(kField);
  std::vector<tern_host::IntentOperator> operators;
  operators.push_back(one("a", "-300 0 50", "300 0 50"));
  operators.push_back(one("b", "0 -300 50", "0 300 50"));
  operators.push_back(one("c", "250 -200 50", "-250 200 50"));
  std::string log;
  EXPECT_TRUE(plan_until_accepted(operators, store, 6, log)) << log;
  EXPECT_EQ(log.find("round 1, flight: as asked"), 0u) << log;
  EXPECT_NE(log.find("refused, 1 that it did not know"), std::string::npos) << log;
  EXPECT_EQ(operators[0].remedy(), Remedy::kNone) << "it came first";
  EXPECT_NE(operators[1].remedy(), Remedy::kNone);
  EXPECT_NE(operators[2].remedy(), Remedy::kNone);
  for (const tern_host::IntentOperator& mine : operators) {
    for (const tern_host::IntentOperator& theirs : operators) {
      EXPECT_TRUE(conflicts_of(mine.written(), {theirs.written()}, kField).empty());
    }
  }
}

TEST(Operators, RandomFlightsNeverMeet) {
  Random random(110);
  const int cases = tern_test::scaled(5);
  for (int c = 0; c < cases; ++c) {
    tern_host::IntentStore store(kField);
    std::vector<UtmEntity> accepted;
    for (int i = 0; i < 4; ++i) {
      const auto place = [&random] {
        return std::to_string(random.integer(-350, 350)) + " " + std::to_string(random.integer(-350, 350)) + " " +
               std::to_string(random.integer(20, 100));
      };
      const std::string start = place(), goal = place();
      tern_host::IntentOperator next = one(std::to_string(i), start, goal);
      bool done = false;
      for (int round = 0; round < 5 && !done; ++round) done = next.try_once(store);
      if (done) accepted.push_back(next.written());
    }
    EXPECT_GE(accepted.size(), 2u);
    for (std::size_t i = 0; i < accepted.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        EXPECT_TRUE(conflicts_of(accepted[i], {accepted[j]}, kField).empty()) << "case " << c;
      }
    }
  }
}

}  // namespace
