// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_VERIFY_BYTES_HPP
#define TERN_VERIFY_BYTES_HPP

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "verify/problem.hpp"

namespace tern_verify {

/// A file's content from its beginning to its end. What is not there throws InputError.
class Bytes {
 public:
  Bytes(const std::string& bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  [[noreturn]] void refuse(const std::string& reason) const {
    throw InputError(name_ + ": before byte " + std::to_string(at_) + ": " + reason);
  }
  bool at_end() const { return at_ == bytes_.size(); }
  std::size_t at() const { return at_; }

  /// So many bytes.
  std::string take(std::uint64_t count) {
    if (count > bytes_.size() - at_) refuse("the file is cut off");
    at_ += static_cast<std::size_t>(count);
    return bytes_.substr(at_ - static_cast<std::size_t>(count), static_cast<std::size_t>(count));
  }
  std::uint8_t byte() { return static_cast<std::uint8_t>(take(1)[0]); }
  /// The words of the next line.
  std::vector<std::string> words();

 private:
  const std::string& bytes_;
  const std::string& name_;
  std::size_t at_ = 0;
};

/// A number of `bytes`, the lowest first: 'F' floating point, 'I' or 'U' with or without a sign.
double value_of(const std::string& bytes, char type);

/// All of a word as a number, whatever the locale; "nan" and "inf" are such, in any case. Refuses anything else.
double word_value(const std::string& word, const Bytes& bytes);

}  // namespace tern_verify

#endif
