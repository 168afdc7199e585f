// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The runner: a crash costs one case and is reported, a run goes on from its state, a case is the same every time.
#include "attack/runner.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <cstdio>
#include <cstring>
#include <memory>

namespace tern_attack {
namespace {

constexpr std::uint64_t kCrashing = 7;

void crash_at_seven(std::uint64_t number) {
  if (number != kCrashing) return;
  signal(SIGSEGV, SIG_DFL);  // a sanitizer's handler would only say more
  raise(SIGSEGV);
}

void stay_at_seven(std::uint64_t number) {
  if (number == kCrashing) sleep(100);
}

void crash_always(std::uint64_t) {
  _exit(3);
}

std::uint64_t cases_of(const Progress& progress) {
  std::uint64_t sum = 0;
  for (const Tally& t : progress.tallies) sum += t.cases;
  return sum;
}

std::vector<Violation> about_seven(const Progress& progress) {
  std::vector<Violation> found;
  for (const Violation& v : progress.violations) {
    if (v.kind == "crash" || v.kind == "too_long") found.push_back(v);
  }
  return found;
}

Options few_cases() {
  Options options;
  options.cases = 20;
  options.jobs = 1;
  options.quiet = true;
  return options;
}

TEST(Runner, ACrashCostsOneCase) {
  Options options = few_cases();
  options.before_case = crash_at_seven;
  Progress progress;
  run_all(options, progress);
  const std::vector<Violation> found = about_seven(progress);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].number, kCrashing);
  EXPECT_EQ(found[0].kind, "crash");
  EXPECT_EQ(cases_of(progress), options.cases - 1);
}

TEST(Runner, ACaseWithoutEndCostsOneCase) {
  Options options = few_cases();
  options.before_case = stay_at_seven;
  options.seconds_a_case = 5.0;
  Progress progress;
  run_all(options, progress);
  const std::vector<Violation> found = about_seven(progress);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind, "too_long");
  EXPECT_EQ(cases_of(progress), options.cases - 1);
}

TEST(Runner, ARunGoesOnFromItsState) {
  Options options = few_cases();
  char folder[] = "/tmp/tern_attack_XXXXXX";
  ASSERT_NE(mkdtemp(folder), nullptr);
  options.folder = folder;
  Progress first;
  run_all(options, first);
  Progress second;
  load_state(options, second);
  EXPECT_EQ(cases_of(second), options.cases);
  EXPECT_EQ(second.violations.size(), first.violations.size());
  EXPECT_EQ(std::memcmp(second.tallies.data(), first.tallies.data(), sizeof first.tallies), 0);
  options.before_case = crash_always;  // nothing is left to run
  run_all(options, second);
  EXPECT_TRUE(about_seven(second).empty());
  std::remove((state_path(options) + ".state").c_str());
  rmdir(folder);
}

TEST(Case, IsTheSameEveryTimeAndAlone) {
  const auto one = std::make_unique<Bench>();
  const auto other = std::make_unique<Bench>();
  Tallies together{};
  Tallies alone{};
  for (std::uint64_t number = 0; number < 60; ++number) {
    Findings findings;
    run_case(*one, 5, number, false, together.data(), findings);
  }
  for (std::uint64_t number = 60; number > 0; --number) {
    Findings findings;
    run_case(*other, 5, number - 1, false, alone.data(), findings);
  }
  EXPECT_EQ(std::memcmp(together.data(), alone.data(), sizeof together), 0);
}

}  // namespace
}  // namespace tern_attack
