// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The bytes of a fleet's messages, written and read: numbers of one to eight bytes, the lowest byte first. One list of
// fields, called with a writer or a reader, does both.
#ifndef TERN_FLEET_BYTES_HPP
#define TERN_FLEET_BYTES_HPP

#include <cstdint>

namespace tern {

/// Writes numbers one after the other. The caller makes sure that there is room.
class ByteWriter {
 public:
  explicit ByteWriter(std::uint8_t* bytes) noexcept : bytes_(bytes) {}

  template <typename Whole>
  void put(Whole value) noexcept {
    const auto bits = static_cast<std::uint64_t>(value);
    for (unsigned k = 0; k < sizeof(Whole); ++k) bytes_[size_++] = static_cast<std::uint8_t>(bits >> (8 * k));
  }
  void put(double value) noexcept {
    std::uint64_t bits = 0;
    __builtin_memcpy(&bits, &value, sizeof bits);
    put(bits);
  }
  template <typename... Fields>
  void operator()(const Fields&... fields) noexcept {
    (put(fields), ...);
  }

  std::int32_t size() const noexcept { return size_; }

 private:
  std::uint8_t* bytes_;
  std::int32_t size_ = 0;
};

/// Reads numbers one after the other; zeros beyond the end.
class ByteReader {
 public:
  ByteReader(const std::uint8_t* bytes, std::int32_t size) noexcept : bytes_(bytes), size_(size) {}

  template <typename Whole>
  void get(Whole& value) noexcept {
    std::uint64_t bits = 0;
    for (unsigned k = 0; k < sizeof(Whole); ++k) bits |= static_cast<std::uint64_t>(next()) << (8 * k);
    value = static_cast<Whole>(bits);
  }
  void get(double& value) noexcept {
    std::uint64_t bits = 0;
    get(bits);
    __builtin_memcpy(&value, &bits, sizeof value);
  }
  template <typename... Fields>
  void operator()(Fields&... fields) noexcept {
    (get(fields), ...);
  }
  void skip(std::int32_t count) noexcept { at_ += count; }

 private:
  std::uint8_t next() noexcept {
    const std::int32_t at = at_++;
    return at < size_ ? bytes_[at] : std::uint8_t{0};
  }

  const std::uint8_t* bytes_;
  std::int32_t size_;
  std::int32_t at_ = 0;
};

/// CRC-32 as of Ethernet and zlib: polynomial 0xEDB88320, reflected, begun with and added to all ones.
std::uint32_t crc32(const std::uint8_t* bytes, std::int32_t size) noexcept;

}  // namespace tern

#endif
