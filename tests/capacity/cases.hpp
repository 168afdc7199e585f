// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Every capacity and budget, with a case that needs as much as there is and one that needs more.
#ifndef TERN_TESTS_CAPACITY_CASES_HPP
#define TERN_TESTS_CAPACITY_CASES_HPP

#include <functional>
#include <initializer_list>
#include <ostream>
#include <string>
#include <vector>

#include "tern/status.hpp"

namespace tern_capacity {

/// The answer of a case where another capacity or another field is at fault: no call gives it.
constexpr tern::Status kNotThis = tern::Status::kRunning;

struct Exceeded {
  std::string name;     ///< of the macro of config.hpp, or of what the caller gives
  tern::Status status;  ///< the answer beyond it; kOk where less is made then
  /// Up to the capacity: true where it is enough.
  std::function<bool()> enough;
  /// Beyond it: the answer, or kNotThis.
  std::function<tern::Status()> beyond;
};

/// For GoogleTest.
inline void PrintTo(const Exceeded& exceeded, std::ostream* out) {
  *out << exceeded.name;
}

inline std::vector<Exceeded> joined(std::initializer_list<std::vector<Exceeded>> lists) {
  std::vector<Exceeded> all;
  for (const std::vector<Exceeded>& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

std::vector<Exceeded> stage_capacities();   ///< of the planner's stages
std::vector<Exceeded> caller_capacities();  ///< of what the caller gives

inline std::vector<Exceeded> exceeded_capacities() {
  return joined({stage_capacities(), caller_capacities()});
}

}  // namespace tern_capacity

#endif
