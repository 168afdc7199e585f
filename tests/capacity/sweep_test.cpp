// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The k-th capacity fails, for every k: each question of the core whether a capacity or a budget is used up is answered
// with yes, one run after the other. Whatever fails, the answer is a status that says so, or a good plan without it;
// the output is as promised; and the next call answers as if nothing had happened.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "capacity/cases_asked.hpp"
#include "capacity/hook.hpp"
#include "capacity/subject.hpp"

namespace tern_capacity {
namespace {

using tern::Status;

constexpr Failing kBoth[] = {Failing::kOnce, Failing::kForGood};

/// FILE:LINE, as in core/src.
std::string name_of(const Site& site) {
  const std::string file = site.file == nullptr ? "core/src/nowhere" : site.file;
  return file.substr(file.rfind("core/src/") + 9) + ":" + std::to_string(site.line);
}

class Sweep {
 public:
  /// Questions of a run, and the outcome that others are compared with.
  explicit Sweep(Subject& subject) : subject_(subject) {
    subject.renew();
    begin();
    usual_ = subject.run();
    end();
    asked_ = asked();
    for (int k = 0; k < site_count(); ++k) {
      if (site(k).asked > 0) sites_.push_back(site(k));
    }
    EXPECT_EQ(usual_.wrong, "");
  }

  const Outcome& usual() const { return usual_; }
  std::uint64_t asked_of_all() const { return asked_; }
  const std::vector<Site>& sites() const { return sites_; }

  /// One question is answered with yes; `failed` gets its place.
  void fail(std::uint64_t number, Failing how, std::set<std::string>& failed) {
    subject_.renew();
    begin(number, how);
    const Outcome outcome = subject_.run();
    const std::string place = name_of(failed_site());
    const std::uint64_t now_asked = asked();
    end();
    ASSERT_GE(now_asked, number) << "until then, both runs are the same";
    failed.insert(place);
    const std::string which = place + ", question " + std::to_string(number) + " of " + std::to_string(asked_);
    EXPECT_EQ(outcome.wrong, "") << which;
    EXPECT_TRUE(outcome.status == Status::kOk || outcome.status == usual_.status || subject_.allows(outcome.status))
        << which << ": " << tern::status_name(outcome.status) << " for " << tern::status_name(usual_.status);
    const Outcome next = subject_.run();
    EXPECT_EQ(next.status, usual_.status) << which << ": the next call";
    EXPECT_EQ(next.bits == usual_.bits, true) << which << ": the next call";
  }

 private:
  Subject& subject_;
  Outcome usual_;
  std::uint64_t asked_ = 0;
  std::vector<Site> sites_;
};

/// Every place of the sources that asks.
std::set<std::string> places() {
  std::set<std::string> found;
  const std::string root = std::string(TERN_SOURCE_DIR) + "/core/src/";
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
    const std::string path = entry.path().string();
    if (!entry.is_regular_file() || path == root + "base/capacity.hpp") continue;
    std::ifstream file(path);
    std::string line;
    for (int number = 1; std::getline(file, line); ++number) {
      if (line.find("is_full(") != std::string::npos) found.insert(name_of({path.c_str(), number, 0, 0, 0}));
    }
  }
  return found;
}

/// The first question of each place of a subject that is new; on a host the last one, too, and both ways to fail.
void fail_new_places(Subject& subject, std::set<std::string>& failed) {
  Sweep sweep(subject);
  for (const Site& site : sweep.sites()) {
    if (failed.count(name_of(site)) != 0) continue;
    sweep.fail(site.first, Failing::kOnce, failed);
    if (TERN_TEST_SCALE < 1) continue;
    sweep.fail(site.first, Failing::kForGood, failed);
    for (const Failing how : kBoth) sweep.fail(site.last, how, failed);
  }
}

/// Those that did not fail.
std::string left_of(const std::set<std::string>& failed) {
  std::string list;
  for (const std::string& place : places()) {
    if (failed.count(place) == 0) list += place + " ";
  }
  return list;
}

TEST(CapacitySweep, EveryPlaceThatAsksFails) {
  constexpr std::uint64_t kMostRequests = 2000;
  std::set<std::string> failed;
  for (const auto& subject : other_subjects()) fail_new_places(*subject, failed);
  for (const auto& subject : flight_subjects()) fail_new_places(*subject, failed);
  for (std::uint64_t seed = 0; seed < kMostRequests && failed.size() < places().size(); ++seed) {
    fail_new_places(*plan_subject(seed), failed);
  }
  EXPECT_EQ(left_of(failed), "");
  RecordProperty("number", static_cast<int>(places().size()));
}

TEST(CapacitySweep, EveryQuestionOfOtherCallsFails) {
  std::set<std::string> failed;
  int runs = 0;
  for (const auto& subject : other_subjects()) {
    Sweep sweep(*subject);
    EXPECT_GT(sweep.asked_of_all(), 0u);
    EXPECT_EQ(sweep.usual().status, Status::kOk);
    for (std::uint64_t number = 1; number <= sweep.asked_of_all(); ++number) {
      for (const Failing how : kBoth) sweep.fail(number, how, failed);
      runs += 2;
    }
  }
  RecordProperty("number", runs);
}

TEST(CapacitySweep, EveryQuestionOfAPlanFails) {
  constexpr std::uint64_t kMostQuestions = 1200;
  std::set<std::string> failed;
  int runs = 0;
  const int cases = tern_capacity::cases(120);
  for (int seed = 0; seed < cases; ++seed) {
    const auto subject = plan_subject(static_cast<std::uint64_t>(seed));
    Sweep sweep(*subject);
    if (sweep.asked_of_all() > kMostQuestions) continue;
    for (std::uint64_t number = 1; number <= sweep.asked_of_all(); ++number) {
      for (const Failing how : kBoth) sweep.fail(number, how, failed);
      runs += 2;
    }
  }
  EXPECT_GT(runs, 100 * cases);
  RecordProperty("number", runs);
}

}  // namespace
}  // namespace tern_capacity
