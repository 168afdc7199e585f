// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_REPLAY_HPP
#define TERN_HOST_REPLAY_HPP

#include <memory>
#include <string>

#include "tern/record.hpp"

namespace tern_host {

/// A recorded query, planned again.
struct Replay {
  std::unique_ptr<tern::PlanRecord> record;
  tern::Status status = tern::Status::kOk;  ///< the new answer
  tern::Trajectory plan{};                  ///< likewise
  std::string difference;                   ///< the first one between both answers; empty where all bits are equal
};

/// Throws std::runtime_error, with the reason, for bytes that are no record that this build can plan.
Replay replay(const std::string& bytes);

}  // namespace tern_host

#endif
