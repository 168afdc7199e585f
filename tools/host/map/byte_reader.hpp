// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_MAP_BYTE_READER_HPP
#define TERN_HOST_MAP_BYTE_READER_HPP

#include <cstddef>
#include <cstdint>
#include <string>

#include "host/text_records.hpp"

namespace tern_host {

enum class ByteOrder : std::uint8_t { kLittle, kBig };

/// Reads a file's content from its beginning to its end, lines and numbers mixed. What lies beyond the end is a
/// RecordError: the file is cut off. Content and place must outlive it.
class ByteReader {
 public:
  ByteReader(const std::string& bytes, const Place& place) : bytes_(bytes), place_(place) {}

  bool at_end() const { return at_ == bytes_.size(); }
  std::size_t at() const { return at_; }
  std::size_t left() const { return bytes_.size() - at_; }
  /// The line that was read last.
  Place line_place() const { return {place_.file, lines_}; }
  /// Up to the next line feed, which is taken too; without a carriage return before it.
  std::string line();
  /// The same without its text, of any length: is anything but blanks in it?
  bool skip_line();
  std::uint8_t byte();
  void skip(std::size_t count);
  /// So many bytes from here on, which are not taken.
  const char* peek(std::size_t count) const;
  /// One number: 'F' floating point of 4 or 8 bytes; 'I' with or 'U' without a sign, of 1, 2, 4 or 8 bytes.
  double number(char type, std::size_t size, ByteOrder order);

 private:
  void need(std::size_t count) const;

  const std::string& bytes_;
  const Place& place_;
  std::size_t at_ = 0;
  int lines_ = 0;
};

/// As ByteReader::number, of the bytes at `bytes`.
double number_at(const char* bytes, char type, std::size_t size, ByteOrder order);

}  // namespace tern_host

#endif
