// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/text_records.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>

#include "host/number.hpp"

namespace tern_host {
namespace {

constexpr std::size_t kQuotedBytes = 40;
/// How some editors begin a file in UTF-8, and how files in UTF-16 begin.
const std::string kByteOrderMark = "\xEF\xBB\xBF";
const std::string kUtf16Marks[] = {"\xFF\xFE", "\xFE\xFF"};

/// What Git leaves in place of a file that Git LFS keeps.
const std::string kLfsPointer = "version https://git-lfs.github.com/spec/";

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}

void check_line(const std::string& line, const Place& place) {
  if (line.size() > kMaxLineBytes) {
    throw RecordError(place, "the line is longer than " + std::to_string(kMaxLineBytes) + " bytes");
  }
  for (const char c : line) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte < 0x20 && !is_blank(c)) || byte == 0x7F) {
      throw RecordError(place, "not a text file: byte " + std::to_string(byte));
    }
  }
}

void check_size(const std::string& text, std::size_t most, const Place& place) {
  if (text.size() > most) throw RecordError(place, "larger than " + std::to_string(most) + " bytes");
}

/// Where the text begins: past a byte order mark.
std::size_t first_byte(const std::string& text, const Place& place) {
  for (const std::string& mark : kUtf16Marks) {
    if (text.compare(0, mark.size(), mark) == 0) throw RecordError(place, "encoded in UTF-16: save it as UTF-8");
  }
  return text.compare(0, kByteOrderMark.size(), kByteOrderMark) == 0 ? kByteOrderMark.size() : 0;
}

}  // namespace

RecordError::RecordError(const Place& place, const std::string& reason)
    : std::runtime_error(place.file + (place.line > 0 ? ":" + std::to_string(place.line) : "") + ": " + reason),
      place_(place),
      reason_(reason) {}

std::string read_text(const std::string& path) {
  return read_bytes(path, kMaxTextBytes);
}

std::string read_bytes(const std::string& path, std::size_t most) {
  const Place place{path, 0};
  const auto close = [](std::FILE* file) { std::fclose(file); };
  const std::unique_ptr<std::FILE, decltype(close)> file(std::fopen(path.c_str(), "rb"), close);
  if (file == nullptr) throw RecordError(place, std::string("cannot be opened: ") + std::strerror(errno));
  std::string text;
  char buffer[65536];
  std::size_t got = 0;
  while ((got = std::fread(buffer, 1, sizeof buffer, file.get())) > 0) {
    text.append(buffer, got);
    check_size(text, most, place);
  }
  if (std::ferror(file.get()) != 0) throw RecordError(place, std::string("cannot be read: ") + std::strerror(errno));
  if (text.compare(0, kLfsPointer.size(), kLfsPointer) == 0) {
    throw RecordError(place, "a Git LFS pointer, not the file itself: run `git lfs pull` where it was cloned");
  }
  return text;
}

Words split_words(const std::string& text, bool commas) {
  Words words;
  std::string word;
  for (const char c : text) {
    if (!is_blank(c) && !(commas && c == ',')) {
      word += c;
    } else if (!word.empty()) {
      words.push_back(word);
      word.clear();
    }
  }
  if (!word.empty()) words.push_back(word);
  return words;
}

Place for_each_record(const std::string& text, const std::string& name,
                      const std::function<void(const Words&, const Place&)>& add) {
  check_size(text, kMaxTextBytes, {name, 0});
  Place place{name, 1};
  for (std::size_t begin = first_byte(text, place); begin < text.size(); ++place.line) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = text.substr(begin, end - begin);
    check_line(line, place);
    const Words words = split_words(line.substr(0, line.find('#')), false);
    if (!words.empty()) add(words, place);
    begin = end + 1;
  }
  return {name, std::max(1, place.line - 1)};
}

std::string quote(const std::string& word) {
  std::string out = "'";
  for (const char c : word.substr(0, kQuotedBytes)) out += c >= 0x20 && c < 0x7F ? c : '?';
  return out + (word.size() > kQuotedBytes ? "...'" : "'");
}

double number(const std::string& word, const Place& place) {
  double value = 0.0;
  switch (parse_number(word, value)) {
    case NumberError::kNone:
      break;
    case NumberError::kMalformed:
      throw RecordError(place, quote(word) + " is not a number");
    case NumberError::kNotFinite:
      throw RecordError(place, quote(word) + " is not a finite number");
  }
  return value;
}

std::uint64_t whole_number(const std::string& word, double most, const Place& place) {
  const double value = number(word, place);
  if (!(value >= 0.0 && value <= most && std::floor(value) == value)) {
    throw RecordError(place, quote(word) + " is not a whole number up to " + brief(most));
  }
  return static_cast<std::uint64_t>(value);
}

std::vector<double> numbers(const Words& words, const Place& place) {
  std::vector<double> values;
  for (std::size_t i = 1; i < words.size(); ++i) values.push_back(number(words[i], place));
  return values;
}

tern::Vec3 vector(const Words& words, const Place& place) {
  const std::vector<double> values = numbers(words, place);
  if (values.size() != 3) throw_count(words.front(), "3 numbers", values.size(), place);
  return {values[0], values[1], values[2]};
}

std::string record_line(const std::string& key, const std::vector<double>& values, const std::string& end) {
  std::string line = key;
  for (const double value : values) line += " " + fixed(value, 4);
  return line + end + "\n";
}

void throw_count(const std::string& key, const std::string& wanted, std::size_t found, const Place& place) {
  throw RecordError(place, "'" + key + "' needs " + wanted + ", found " + std::to_string(found));
}

}  // namespace tern_host
