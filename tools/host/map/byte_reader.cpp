// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/map/byte_reader.hpp"

#include <algorithm>
#include <cstring>

namespace tern_host {
namespace {

/// Two's complement of so many bytes.
double signed_number(std::uint64_t bits, std::size_t size) {
  const std::uint64_t sign = std::uint64_t{1} << (8 * size - 1);
  return static_cast<double>(static_cast<std::int64_t>((bits ^ sign) - sign));
}

template <typename Number, typename Bits>
double floating_number(Bits bits) {
  Number value{};
  std::memcpy(&value, &bits, sizeof value);
  return static_cast<double>(value);
}

}  // namespace

void ByteReader::need(std::size_t count) const {
  if (count > left()) {
    throw RecordError(place_, "the file is cut off after " + std::to_string(bytes_.size()) + " bytes: copy it again");
  }
}

std::string ByteReader::line() {
  ++lines_;
  if (at_end()) throw RecordError(line_place(), "the file is cut off here: copy it again");
  const std::size_t end = std::min(bytes_.find('\n', at_), bytes_.size());
  if (end - at_ > kMaxLineBytes) {
    throw RecordError(line_place(), "the line is longer than " + std::to_string(kMaxLineBytes) + " bytes");
  }
  std::string text = bytes_.substr(at_, end - at_);
  at_ = end < bytes_.size() ? end + 1 : end;
  if (!text.empty() && text.back() == '\r') text.pop_back();
  return text;
}

bool ByteReader::skip_line() {
  ++lines_;
  if (at_end()) throw RecordError(line_place(), "the file is cut off here: copy it again");
  const std::size_t end = std::min(bytes_.find('\n', at_), bytes_.size());
  const std::size_t begin = at_;
  at_ = end < bytes_.size() ? end + 1 : end;
  return bytes_.find_first_not_of(" \t\r", begin) < end;
}

std::uint8_t ByteReader::byte() {
  need(1);
  return static_cast<std::uint8_t>(bytes_[at_++]);
}

void ByteReader::skip(std::size_t count) {
  need(count);
  at_ += count;
}

const char* ByteReader::peek(std::size_t count) const {
  need(count);
  return bytes_.data() + at_;
}

double ByteReader::number(char type, std::size_t size, ByteOrder order) {
  const double value = number_at(peek(size), type, size, order);
  at_ += size;
  return value;
}

double number_at(const char* bytes, char type, std::size_t size, ByteOrder order) {
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t shift = order == ByteOrder::kLittle ? i : size - 1 - i;
    bits |= std::uint64_t{static_cast<std::uint8_t>(bytes[i])} << (8 * shift);
  }
  if (type == 'F' && size == 4) return floating_number<float>(static_cast<std::uint32_t>(bits));
  if (type == 'F') return floating_number<double>(bits);
  return type == 'I' ? signed_number(bits, size) : static_cast<double>(bits);
}

}  // namespace tern_host
