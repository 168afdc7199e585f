// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Text files of records: one a line, a keyword and what follows, `#` starts a comment. Errors name file and line.
#ifndef TERN_HOST_TEXT_RECORDS_HPP
#define TERN_HOST_TEXT_RECORDS_HPP

#include <cstddef>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "tern/vec3.hpp"

namespace tern_host {

/// Larger input is refused before it is parsed.
constexpr std::size_t kMaxTextBytes = std::size_t{64} * 1024 * 1024;
constexpr std::size_t kMaxLineBytes = 4096;

/// Where a value was written. `line` counts from 1; 0 for what has no lines, such as an option.
struct Place {
  std::string file;
  int line = 0;
};

/// What is wrong with a text and where; what() reads "file:line: reason".
class RecordError : public std::runtime_error {
 public:
  RecordError(const Place& place, const std::string& reason);

  const Place& place() const noexcept { return place_; }
  const std::string& reason() const noexcept { return reason_; }

 private:
  Place place_;
  std::string reason_;
};

/// A record's keyword and what follows; never empty.
using Words = std::vector<std::string>;

/// The whole file, at most kMaxTextBytes. Throws RecordError.
std::string read_text(const std::string& path);

/// The whole file, at most `most` bytes of any kind. Throws RecordError; of a Git LFS pointer, too.
std::string read_bytes(const std::string& path, std::size_t most);

/// The words of one line, between blanks and, where told, commas.
Words split_words(const std::string& text, bool commas);

/// Hands each record to `add` with its place; returns the place of the last line. Throws RecordError where the text is
/// too large, has a line of more than kMaxLineBytes or a byte that no text has. A byte order mark of UTF-8 is skipped.
Place for_each_record(const std::string& text, const std::string& name,
                      const std::function<void(const Words&, const Place&)>& add);

/// A word of the file for a message: hostile bytes and lengths must not reach the terminal.
std::string quote(const std::string& word);

/// A finite number, or a RecordError.
double number(const std::string& word, const Place& place);

/// A whole number from 0 to `most`, or a RecordError.
std::uint64_t whole_number(const std::string& word, double most, const Place& place);

/// All words after the keyword as numbers.
std::vector<double> numbers(const Words& words, const Place& place);

/// Exactly three numbers after the keyword.
tern::Vec3 vector(const Words& words, const Place& place);

/// A record's line: the keyword, the values with four decimals, and `end`.
std::string record_line(const std::string& key, const std::vector<double>& values, const std::string& end = "");

/// Throws: `key` does not have as many numbers as it needs.
[[noreturn]] void throw_count(const std::string& key, const std::string& wanted, std::size_t found, const Place& place);

}  // namespace tern_host

#endif
