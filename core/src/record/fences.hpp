// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fences in the records of plans and flights, written and read.
#ifndef TERN_RECORD_FENCES_HPP
#define TERN_RECORD_FENCES_HPP

#include <cstddef>
#include <cstdint>

#include "record/fields.hpp"
#include "record/words.hpp"
#include "tern/config.hpp"
#include "tern/fence.hpp"

namespace tern {

/// All fields but the half-spaces, whose count and whose fields follow.
template <typename Words, typename AnyFence>
void list_fence(Words& words, AnyFence& fence) {
  words(fence.kind);
  words(fence.from);
  words(fence.until);
  words(fence.clock_error);
}
constexpr std::size_t kFenceFields = 4;

/// The most fields of all fences.
constexpr std::size_t kFencesFields = 1 + (kFenceFields + 1) * static_cast<std::size_t>(kMaxFences) +
                                      kPlaneFields * static_cast<std::size_t>(kMaxFencePlanes);

inline bool fences_fit(const Fence* fences, std::int32_t count) {
  if (!is_count(count, kMaxFences, fences)) return false;
  std::int32_t planes = 0;
  for (std::int32_t f = 0; f < count; ++f) {
    if (!is_count(fences[f].count, kMaxFencePlanes - planes, fences[f].planes)) return false;
    planes += fences[f].count;
  }
  return true;
}

inline void write_fences(const Fence* fences, std::int32_t count, WordWriter& words) {
  words(count);
  for (std::int32_t f = 0; f < count; ++f) {
    list_fence(words, fences[f]);
    words(fences[f].count);
    for (std::int32_t p = 0; p < fences[f].count; ++p) list_plane(words, fences[f].planes[p]);
  }
}

/// Reads the fences that write_fences wrote, into arrays of kMaxFences and kMaxFencePlanes. The fences point into
/// `planes`.
inline Status read_fences(WordReader& words, Fence* fences, Halfspace* planes, std::int32_t& count) {
  Halfspace* next = planes;
  Status status = read_count(words, kMaxFences, Status::kFencesFull, count);
  for (std::int32_t f = 0; status == Status::kOk && f < count; ++f) {
    list_fence(words, fences[f]);
    const auto left = static_cast<std::int32_t>(planes + kMaxFencePlanes - next);
    status = read_count(words, left, Status::kFencePlanesFull, fences[f].count);
    if (status != Status::kOk) break;
    fences[f].planes = next;
    for (std::int32_t p = 0; p < fences[f].count; ++p) list_plane(words, *next++);
  }
  return status;
}

}  // namespace tern

#endif
