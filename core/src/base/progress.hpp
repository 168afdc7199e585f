// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The result of a slice of a stage. Every stage is a plain structure with two functions. begin() prepares it. advance()
// spends units of a slice of work until the slice is empty or the stage has ended.
#ifndef TERN_BASE_PROGRESS_HPP
#define TERN_BASE_PROGRESS_HPP

#include <cstdint>

#include "tern/status.hpp"

namespace tern {

/// The result of advance().
enum class Progress : std::uint8_t {
  kMore,    ///< the slice is empty, and there is work left
  kDone,    ///< the result is complete
  kFailed,  ///< there is no result; the stage's `status` says why
};

/// Ends a stage: stores `status` in `kept`, and returns kDone for kOk, else kFailed.
constexpr Progress conclude(Status status, Status& kept) noexcept {
  kept = status;
  return status == Status::kOk ? Progress::kDone : Progress::kFailed;
}

}  // namespace tern

#endif
