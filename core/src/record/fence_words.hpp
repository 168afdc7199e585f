// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fences in a record, and counts that a record can hold.
#ifndef TERN_RECORD_FENCE_WORDS_HPP
#define TERN_RECORD_FENCE_WORDS_HPP

#include <cstdint>

#include "record/fields.hpp"
#include "record/words.hpp"
#include "tern/config.hpp"
#include "tern/fence.hpp"

namespace tern {

inline bool is_count(std::int32_t count, std::int32_t most, const void* items) {
  return count >= 0 && count <= most && (count == 0 || items != nullptr);
}

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
    words(fences[f].kind);
    words(fences[f].count);
    for (std::int32_t p = 0; p < fences[f].count; ++p) list_plane(words, fences[f].planes[p]);
  }
}

}  // namespace tern

#endif
