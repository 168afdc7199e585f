// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Many cases in processes of their own: a crash costs one case, a killed run goes on where it was.
#ifndef TERN_TESTS_ATTACK_RUNNER_HPP
#define TERN_TESTS_ATTACK_RUNNER_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "attack/attack_case.hpp"

namespace tern_attack {

struct Options {
  std::uint64_t seed = 1;
  std::uint64_t first = 0;  ///< index of the first case
  std::uint64_t cases = 4000;
  int family = -1;      ///< -1: all in turn
  bool things = false;  ///< plans among things that move alone
  int jobs = 0;         ///< 0: one a core
  double seconds_a_case = 60.0;
  bool quiet = false;                                   ///< no progress line
  std::string folder;                                   ///< for state and tables; empty: none are kept
  void (*before_case)(std::uint64_t number) = nullptr;  ///< called in the case's process; for tests of this runner
};

using Tallies = std::array<Tally, kFamilies>;

struct Violation {
  std::uint64_t number;
  std::string kind;
  std::string detail;
};

/// What finished blocks of cases came to.
struct Progress {
  std::set<std::uint64_t> blocks;
  Tallies tallies{};
  std::vector<Violation> violations;
  double seconds = 0.0;
};

/// Cases in one block, the unit of resuming.
constexpr std::uint64_t kBlock = 500;

/// The case that is number `index` of a run: all in turn, or those of one family.
std::uint64_t case_at(const Options& options, std::uint64_t index);
void add(const Tallies& part, Tallies& sum);
std::string violation_line(const Options& options, const Violation& violation);

/// Runs what `progress` lacks; prints a line a violation. The state file is written as blocks finish.
void run_all(const Options& options, Progress& progress);

/// State of a run under options.folder, without its ending. Loading leaves `progress` empty where there is none, or
/// where another build of the program wrote it. A run that keeps state has whole blocks only.
std::string state_path(const Options& options);
void load_state(const Options& options, Progress& progress);
void save_state(const Options& options, const Progress& progress);

/// The table by family, as text for the terminal and as markdown and CSV files beside the state.
void print_table(const Options& options, const Progress& progress);
void write_tables(const Options& options, const Progress& progress);

}  // namespace tern_attack

#endif
