// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Finds the fault in a caller's tracks. Plans and proofs both use this check, so they give the same answer.
#ifndef TERN_BASE_TRACK_FAULT_HPP
#define TERN_BASE_TRACK_FAULT_HPP

#include <cstdint>

#include "tern/status.hpp"
#include "tern/track.hpp"

namespace tern {

/// kOk, or why the tracks are refused and the index of the track at fault: kNoTrack if the list itself is at fault.
struct TrackFault {
  Status status;
  std::int32_t track;
};

/// Checks `count` tracks. Returns kOk, kNonFiniteInput, kTracksFull, kTrackPiecesFull or kInvalidArgument:
/// tern/track.hpp says what a track may be.
TrackFault find_track_fault(const Track* list, std::int32_t count) noexcept;

}  // namespace tern

#endif
