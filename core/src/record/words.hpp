// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A record's words, written and read: eight bytes each, the lowest first. A function that lists the fields of a
// structure serves for both: words(field) writes the field to a WordWriter, or reads it from a WordReader.
#ifndef TERN_RECORD_WORDS_HPP
#define TERN_RECORD_WORDS_HPP

#include <cstddef>
#include <cstdint>

#include "base/capacity.hpp"
#include "tern/status.hpp"
#include "tern/vec3.hpp"

namespace tern {

constexpr std::size_t kWordBytes = 8;

/// Writes fields as words to a Sink, which derives from this.
template <typename Sink>
class FieldWriter {
 public:
  void operator()(double value) {
    std::uint64_t bits = 0;
    __builtin_memcpy(&bits, &value, sizeof bits);
    put(bits);
  }
  void operator()(const Vec3& v) {
    (*this)(v.x);
    (*this)(v.y);
    (*this)(v.z);
  }
  /// Whole numbers, truth values and enumerators. Negative ones keep their sign.
  template <typename Whole>
  void operator()(const Whole& value) {
    put(static_cast<std::uint64_t>(static_cast<std::int64_t>(value)));
  }

 private:
  void put(std::uint64_t word) { static_cast<Sink*>(this)->word(word); }
};

class WordWriter : public FieldWriter<WordWriter> {
 public:
  WordWriter(std::uint8_t* bytes, std::size_t room) : bytes_(bytes), room_(room / kWordBytes) {}

  void word(std::uint64_t value) {
    if (count_ < room_) {
      for (std::size_t k = 0; k < kWordBytes; ++k) {
        bytes_[kWordBytes * count_ + k] = static_cast<std::uint8_t>(value >> (8 * k));
      }
    }
    ++count_;
  }
  /// Replaces a word that was written.
  void replace(std::size_t index, std::uint64_t value) {
    WordWriter at(bytes_ + kWordBytes * index, index < room_ ? kWordBytes : 0);
    at.word(value);
  }

  std::size_t count() const { return count_; }
  bool full() const { return is_full(count_ > room_); }

 private:
  std::uint8_t* bytes_;
  std::size_t room_;
  std::size_t count_ = 0;  ///< words written, those beyond the room included
};

class WordReader {
 public:
  WordReader(const std::uint8_t* bytes, std::size_t count) : bytes_(bytes), room_(count / kWordBytes) {}

  /// The next word; 0 beyond the end.
  std::uint64_t word() {
    std::uint64_t value = 0;
    if (count_ < room_) {
      for (std::size_t k = 0; k < kWordBytes; ++k) {
        value |= static_cast<std::uint64_t>(bytes_[kWordBytes * count_ + k]) << (8 * k);
      }
    }
    ++count_;
    return value;
  }

  void operator()(double& value) {
    const std::uint64_t bits = word();
    __builtin_memcpy(&value, &bits, sizeof value);
  }
  void operator()(Vec3& v) {
    (*this)(v.x);
    (*this)(v.y);
    (*this)(v.z);
  }
  void operator()(bool& value) { value = word() != 0; }
  template <typename Whole>
  void operator()(Whole& value) {
    value = static_cast<Whole>(word());
  }

  std::size_t count() const { return count_; }
  std::size_t left() const { return count_ < room_ ? room_ - count_ : 0; }
  bool past_end() const { return count_ > room_; }

 private:
  const std::uint8_t* bytes_;
  std::size_t room_;
  std::size_t count_ = 0;  ///< words read, those beyond the end included
};

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
