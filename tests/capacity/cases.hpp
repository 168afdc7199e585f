// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Every capacity and budget, with a case that needs as much as there is and one that needs more.
#ifndef TERN_TESTS_CAPACITY_CASES_HPP
#define TERN_TESTS_CAPACITY_CASES_HPP

#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "tern/status.hpp"

namespace tern_capacity {

struct Exceeded {
  std::string name;     ///< of the macro of config.hpp, or of what the caller gives
  tern::Status status;  ///< the answer beyond it; kOk where less is made then
  /// Up to the capacity: true where it is enough.
  std::function<bool()> enough;
  /// Beyond it: the answer. kRunning, which is none, if another capacity or another field is at fault.
  std::function<tern::Status()> beyond;
};

/// For GoogleTest.
inline void PrintTo(const Exceeded& exceeded, std::ostream* out) {
  *out << exceeded.name;
}

std::vector<Exceeded> exceeded_capacities();

}  // namespace tern_capacity

#endif
