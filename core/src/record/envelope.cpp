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

/// FNV-1a, 64 bits.
std::uint64_t checksum(const std::uint8_t* bytes, std::size_t count) {
  std::uint64_t hash = 0xCBF2'9CE4'8422'2325u;
  for (std::size_t k = 0; k < count; ++k) hash = (hash ^ bytes[k]) * 0x100'0000'01B3u;
  return hash;
}

}  // namespace

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

Status check_envelope(RecordKind kind, const std::uint8_t* bytes, std::size_t count,
                      std::uint64_t& configuration) noexcept {
  WordReader words(bytes, count);
  if (words.left() < kEnvelopeWords || words.word() != kRecordTag) return Status::kRecordDamaged;
  if (words.word() != kRecordVersion) return Status::kRecordVersion;
  const bool is_kind = words.word() == static_cast<std::uint64_t>(kind);
  const std::uint64_t length = words.word();
  configuration = words.word();
  if (!is_kind || count % kWordBytes != 0 || length != count / kWordBytes) return Status::kRecordDamaged;
  WordReader last(bytes + count - kWordBytes, kWordBytes);
  return last.word() == checksum(bytes, count - kWordBytes) ? Status::kOk : Status::kRecordDamaged;
}

WordReader content_of(const std::uint8_t* bytes, std::size_t count) noexcept {
  return {bytes + kWordBytes * kHeadWords, count - kWordBytes * kEnvelopeWords};
}

}  // namespace tern
