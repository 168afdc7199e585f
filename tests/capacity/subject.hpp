// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Calls of the core whose questions about capacities a test answers with yes, one after the other.
#ifndef TERN_TESTS_CAPACITY_SUBJECT_HPP
#define TERN_TESTS_CAPACITY_SUBJECT_HPP

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "tern/status.hpp"

namespace tern_capacity {

struct Outcome {
  tern::Status status;
  std::string bits;   ///< of all that the call gave out
  std::string wrong;  ///< what is wrong with it whatever the status; empty where nothing is
};

class Subject {
 public:
  virtual ~Subject() = default;
  /// Makes the call again, from the beginning. May end() the questions where it goes on to look at the answer.
  virtual Outcome run() = 0;
  /// Prepares what run() works in as it was at first. Without it, a run finds what the one before left.
  virtual void renew() {}
  /// True where a call that lacked room may answer so.
  virtual bool allows(tern::Status status) const;
};

std::unique_ptr<Subject> plan_subject(std::uint64_t seed);
/// Everything that is neither a plan nor a flight: maps and their frames, yaws, records, missions, proofs.
std::vector<std::unique_ptr<Subject>> other_subjects();
std::unique_ptr<Subject> fleet_subject();
/// Whole flights, with ten thousands of questions.
std::vector<std::unique_ptr<Subject>> flight_subjects();

}  // namespace tern_capacity

#endif
