// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The envelope of a record's content: a head with the record's kind and length, and a checksum at the end.
#ifndef TERN_RECORD_ENVELOPE_HPP
#define TERN_RECORD_ENVELOPE_HPP

#include <cstddef>
#include <cstdint>

#include "record/words.hpp"
#include "tern/status.hpp"

namespace tern {

/// Words of the head: tag, version, kind, words in all, configuration.
constexpr std::size_t kHeadWords = 5;
/// Words besides the content.
constexpr std::size_t kEnvelopeWords = kHeadWords + 1;

/// Where the number of words is in a flight's record, in words from the end: before the checksum. A recorder that
/// streams does not know the number when it writes the head, which has a 0 instead.
constexpr std::size_t kLengthFromEnd = 2;

enum class RecordKind : std::uint64_t { kPlan = 1, kFlight = 2 };

/// FNV-1a, 64 bits, of `bytes`. `before` is the checksum of the bytes before them.
constexpr std::uint64_t kChecksumSeed = 0xCBF2'9CE4'8422'2325u;
std::uint64_t checksum(const std::uint8_t* bytes, std::size_t count, std::uint64_t before = kChecksumSeed) noexcept;

/// Writes the head. The number of words is not known yet.
void open_envelope(RecordKind kind, WordWriter& words) noexcept;
/// Completes the head and writes the checksum of `bytes`, which the words were written to. kOk or kRecordFull; `used`
/// then gets the record's bytes.
Status close_envelope(const std::uint8_t* bytes, WordWriter& words, std::size_t& used) noexcept;

/// The kind in a record's head; 0 for bytes that are no record.
std::uint64_t record_kind(const std::uint8_t* bytes, std::size_t count) noexcept;
/// Checks the head and the checksum. kOk, kRecordDamaged or kRecordVersion; `configuration` gets the configuration hash
/// in the head.
Status check_envelope(RecordKind kind, const std::uint8_t* bytes, std::size_t count,
                      std::uint64_t& configuration) noexcept;
/// The content of a record that was checked.
WordReader content_of(const std::uint8_t* bytes, std::size_t count) noexcept;

}  // namespace tern

#endif
