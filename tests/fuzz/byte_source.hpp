// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_TESTS_FUZZ_BYTE_SOURCE_HPP
#define TERN_TESTS_FUZZ_BYTE_SOURCE_HPP

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "tern/vec3.hpp"

namespace tern_fuzz {

/// Numbers from bytes, zeros where these have run out.
class ByteSource {
 public:
  ByteSource(const std::uint8_t* data, std::size_t size) : at_(data), left_(size) {}

  std::size_t left() const { return left_; }

  int byte() {
    if (left_ == 0) return 0;
    --left_;
    return *at_++;
  }

  /// 0 .. count - 1
  int below(int count) { return byte() % count; }

  /// A number between two, in steps of 1/255; in one of 16 cases any bits at all.
  double number(double low, double high) {
    const int choice = byte();
    if (choice % 16 == 15) return any();
    return low + (high - low) * (byte() / 255.0);
  }

  tern::Vec3 vector(double low, double high) {
    const double x = number(low, high);
    const double y = number(low, high);
    return {x, y, number(low, high)};
  }

  double any() {
    std::uint8_t bytes[sizeof(double)];
    for (std::uint8_t& b : bytes) b = static_cast<std::uint8_t>(byte());
    double value = 0.0;
    std::memcpy(&value, bytes, sizeof value);
    return value;
  }

 private:
  const std::uint8_t* at_;
  std::size_t left_;
};

}  // namespace tern_fuzz

#endif
