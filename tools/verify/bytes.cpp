// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "verify/bytes.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>
#include <locale>
#include <sstream>

namespace tern_verify {
namespace {

bool is_not_finite(std::string word) {
  if (word[0] == '+' || word[0] == '-') word.erase(0, 1);
  for (char& c : word) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return word == "nan" || word == "inf" || word == "infinity";
}

}  // namespace

std::vector<std::string> Bytes::words() {
  if (at_end()) refuse("the file is cut off");
  const std::size_t end = std::min(bytes_.find('\n', at_), bytes_.size());
  std::istringstream line(bytes_.substr(at_, end - at_));
  at_ = std::min(end + 1, bytes_.size());
  return {std::istream_iterator<std::string>(line), {}};
}

double value_of(const std::string& bytes, char type) {
  std::uint64_t bits = 0;
  for (std::size_t i = bytes.size(); i-- > 0;) bits = bits << 8 | static_cast<std::uint8_t>(bytes[i]);
  if (type == 'F' && bytes.size() == 4) {
    const auto half = static_cast<std::uint32_t>(bits);
    float value = 0;
    std::memcpy(&value, &half, sizeof value);
    return value;
  }
  if (type == 'F') {
    double value = 0;
    std::memcpy(&value, &bits, sizeof value);
    return value;
  }
  if (type == 'U') return static_cast<double>(bits);
  const std::size_t unused = 64 - 8 * bytes.size();
  return static_cast<double>(static_cast<std::int64_t>(bits << unused) >> unused);
}

double word_value(const std::string& word, const Bytes& bytes) {
  if (is_not_finite(word)) return std::numeric_limits<double>::quiet_NaN();
  std::istringstream stream(word);
  stream.imbue(std::locale::classic());
  double value = 0.0;
  stream >> value;
  if (stream.fail() || !stream.eof() || !std::isfinite(value)) bytes.refuse("'" + word + "' is no number");
  return value;
}

}  // namespace tern_verify
