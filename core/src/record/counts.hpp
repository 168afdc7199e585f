// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Counts of items that a record holds.
#ifndef TERN_RECORD_COUNTS_HPP
#define TERN_RECORD_COUNTS_HPP

#include <cstdint>

#include "base/capacity.hpp"
#include "record/words.hpp"
#include "tern/status.hpp"

namespace tern {

inline bool is_count(std::int32_t count, std::int32_t most, const void* items) {
  return count >= 0 && count <= most && (count == 0 || items != nullptr);
}

/// Reads a count that is at most `most`; answers `full` if it is more. No count is trusted, because a record may have
/// been altered and given a new checksum.
inline Status read_count(WordReader& words, std::int32_t most, Status full, std::int32_t& count) {
  const std::uint64_t read = words.word();
  if (read > words.left()) return Status::kRecordDamaged;
  if (is_full(read > static_cast<std::uint64_t>(most))) return full;
  count = static_cast<std::int32_t>(read);
  return Status::kOk;
}

}  // namespace tern

#endif
