// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Requests that the planner refused once. Each has an answer; most of the replans have it with the previous plan.
#include <gtest/gtest.h>

#include <memory>

#include "attack/attack_case.hpp"
#include "attack/runner.hpp"

namespace tern_attack {
namespace {

struct Hard {
  std::uint64_t seed;
  std::uint64_t number;
};

TEST(HardReplans, HaveAnAnswer) {
  constexpr Hard kHard[] = {
      {2026, 45745},   {2026, 54805},   {2026, 91175},  {2026, 107337},  {2026, 107964},  {2026, 111095},
      {2026, 111313},  {2026, 132320},  {2026, 164891}, {2026, 178160},  {2026, 200181},  {2026, 210330},
      {2026, 210405},  {2026, 213012},  {2026, 234425}, {2026, 239986},  {2026, 253267},  {2026, 256337},
      {2026, 267824},  {2026, 270855},  {2026, 276010}, {1, 3625},       {4, 23263},      {4, 24577},
      {4, 38661},      {5, 11548},      {5, 85824},     {2026, 583035},  {2027, 104153},  {2027, 251588},
      {2027, 469424},  {2027, 564764},  {2027, 729443}, {2027, 822562},  {2027, 951497},  {2028, 81445},
      {2028, 214283},  {2029, 98409},   {2031, 371596}, {2031, 118544},  {7001, 90430},   {10001, 242261},
      {10001, 387635}, {12001, 655255}, {13001, 6585},  {13001, 20791},  {13001, 35866},  {13001, 39828},
      {13002, 6203},   {13002, 9577},   {13002, 76980}, {14001, 574395}, {14001, 581151}, {14001, 741281},
      {21003, 22324},  {23001, 467157}, {63001, 59074}};
  const auto bench = std::make_unique<Bench>();
  Tallies tallies{};
  for (const Hard& hard : kHard) {
    Findings findings;
    run_case(*bench, hard.seed, hard.number, false, tallies.data(), findings);
    EXPECT_TRUE(findings.empty()) << hard.seed << ' ' << hard.number;
  }
  std::uint64_t followed = 0;
  for (const Tally& tally : tallies) followed += tally.followed;
  EXPECT_GT(followed, 0u);
}

}  // namespace
}  // namespace tern_attack
