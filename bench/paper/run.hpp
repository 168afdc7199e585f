// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What every experiment is given, and where it leaves what it found.
#ifndef TERN_BENCH_PAPER_RUN_HPP
#define TERN_BENCH_PAPER_RUN_HPP

#include <string>
#include <vector>

#include "host/scenario.hpp"

namespace tern_bench {

struct Run {
  bool quick = false;  ///< few seeds and short times: shows that everything works, not what it is worth
  std::string folder;  ///< tables and pictures go here
};

/// How many of something: all of them, or enough to see that it works.
inline int pick(const Run& run, int full, int quick) {
  return run.quick ? quick : full;
}

/// One of the paper's six maps, 1 .. 6. Throws tern_host::ScenarioError.
tern_host::Scenario paper_map(int number);

/// A line on standard error about how far an experiment is.
void progress(const std::string& message);

/// A table, written as CSV when it is complete; the machine stands in a comment above it.
class Table {
 public:
  /// `columns`: names with commas between them.
  explicit Table(const std::string& columns);

  /// Values in the order of the columns, as text. Throws std::logic_error where there are more or fewer.
  void row(const std::vector<std::string>& values);

  /// Writes folder/name. Throws std::runtime_error.
  void write(const Run& run, const std::string& name) const;

 private:
  std::size_t columns_;
  std::string text_;
};

}  // namespace tern_bench

#endif
