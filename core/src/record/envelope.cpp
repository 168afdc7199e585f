// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "record/envelope.hpp"

#include "tern/config.hpp"
#include "tern/record.hpp"
#include "tern/self_test.hpp"

namespace tern {
namespace {

/// "ternrec" and a zero, the first letter lowest.
constexpr std::uint64_t kRecordTag = 0x0063'6572'6E72'6574u;
constexpr std::size_t kLengthWord = 3;

/// The number of words that a record's head must have. The head of a flight's record has 0.
std::uint64_t length_in_head(RecordKind kind, std::size_t words) {
  return kind == RecordKind::kFlight ? 0 : words;
}

/// False for a flight's record that does not have the number of its words before the checksum.
bool length_at_end(RecordKind kind, const std::uint8_t* bytes, std::size_t words) {
  if (kind != RecordKind::kFlight) return true;
  if (words < kEnvelopeWords + 1) return false;
  WordReader at(bytes + kWordBytes * (words - kLengthFromEnd), kWordBytes);
  return at.word() == words;
}

}  // namespace

std::uint64_t checksum(const std::uint8_t* bytes, std::size_t count, std::uint64_t before) noexcept {
  std::uint64_t hash = before;
  for (std::size_t k = 0; k < count; ++k) hash = (hash ^ bytes[k]) * 0x100'0000'01B3u;
  return hash;
}

void open_envelope(RecordKind kind, WordWriter& words) noexcept {
  words.word(kRecordTag);
  words.word(kRecordVersion);
  words.word(static_cast<std::uint64_t>(kind));
  words.word(0);
  words.word(kConfigurationHash);
}

Status close_envelope(const std::uint8_t* bytes, WordWriter& words, std::size_t& used) noexcept {
  const std::size_t content = words.count();
  words.replace(kLengthWord, content + 1);
  if (words.full()) return Status::kRecordFull;
  words.word(checksum(bytes, kWordBytes * content));
  if (words.full()) return Status::kRecordFull;
  used = kWordBytes * words.count();
  return Status::kOk;
}

std::uint64_t record_kind(const std::uint8_t* bytes, std::size_t count) noexcept {
  WordReader words(bytes, count);
  if (words.left() < kEnvelopeWords || words.word() != kRecordTag) return 0;
  words.word();
  return words.word();
}

Status check_envelope(RecordKind kind, const std::uint8_t* bytes, std::size_t count,
                      std::uint64_t& configuration) noexcept {
  WordReader words(bytes, count);
  if (words.left() < kEnvelopeWords || words.word() != kRecordTag) return Status::kRecordDamaged;
  if (words.word() != kRecordVersion) return Status::kRecordVersion;
  const bool is_kind = words.word() == static_cast<std::uint64_t>(kind);
  const std::uint64_t length = words.word();
  configuration = words.word();
  const std::size_t all = count / kWordBytes;
  if (!is_kind || count % kWordBytes != 0 || length != length_in_head(kind, all)) return Status::kRecordDamaged;
  if (!length_at_end(kind, bytes, all)) return Status::kRecordDamaged;
  WordReader last(bytes + count - kWordBytes, kWordBytes);
  return last.word() == checksum(bytes, count - kWordBytes) ? Status::kOk : Status::kRecordDamaged;
}

WordReader content_of(const std::uint8_t* bytes, std::size_t count) noexcept {
  return {bytes + kWordBytes * kHeadWords, count - kWordBytes * kEnvelopeWords};
}

}  // namespace tern
