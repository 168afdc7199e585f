// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Depths in a record: runs of numbers of 16 or 32 bits, four or two to a word, the first one lowest. A run begins with
// its length times 2, plus 1 if its numbers are equal. Equal numbers follow once, others all. The last word is filled
// up with zeros.
#ifndef TERN_RECORD_DEPTH_RUNS_HPP
#define TERN_RECORD_DEPTH_RUNS_HPP

#include <cstddef>
#include <cstdint>

#include "record/words.hpp"

namespace tern {

/// The longest run.
template <typename Number>
constexpr std::size_t longest_run() {
  return (std::size_t{1} << (8 * sizeof(Number) - 1)) - 1;
}

/// The most words that `count` numbers take. A run of equal numbers has at least three, so it saves the heads of itself
/// and of a run of others before it. The head of the last run is not saved, nor is that of a run that follows one of
/// the greatest length.
template <typename Number>
constexpr std::size_t most_run_words(std::size_t count) {
  return (count + 2 + 2 * (count / longest_run<Number>())) * sizeof(Number) / kWordBytes + 1;
}

/// Packs numbers into words, the first one lowest.
template <typename Number>
class NumberWriter {
 public:
  explicit NumberWriter(WordWriter& words) : words_(words) {}
  void operator()(Number number) {
    word_ |= static_cast<std::uint64_t>(number) << (8 * sizeof(Number) * filled_);
    if (++filled_ == kWordBytes / sizeof(Number)) flush();
  }
  void flush() {
    if (filled_ > 0) words_.word(word_);
    word_ = 0;
    filled_ = 0;
  }

 private:
  WordWriter& words_;
  std::uint64_t word_ = 0;
  unsigned filled_ = 0;
};

/// Writes the numbers at(0) to at(count - 1) in runs.
template <typename Number, typename At>
class RunWriter {
 public:
  RunWriter(std::size_t count, At at) : count_(count), at_(at) {}

  void write(WordWriter& words) const {
    NumberWriter<Number> numbers(words);
    for (std::size_t begin = 0; begin < count_;) {
      const std::size_t equal = run(begin);
      const bool pays = equal >= kLeastRun;
      const std::size_t length = pays ? equal : mixed(begin);
      numbers(static_cast<Number>(2 * length + (pays ? 1 : 0)));
      for (std::size_t k = 0; k < (pays ? 1 : length); ++k) numbers(at_(begin + k));
      begin += length;
    }
    numbers.flush();
  }

 private:
  /// The least length of a run of equal numbers: a shorter one would save nothing.
  static constexpr std::size_t kLeastRun = 3;

  std::size_t end_of(std::size_t begin) const {
    return count_ - begin < longest_run<Number>() ? count_ : begin + longest_run<Number>();
  }
  /// How many numbers from `begin` on are equal.
  std::size_t run(std::size_t begin) const {
    const std::size_t end = end_of(begin);
    std::size_t at = begin + 1;
    while (at < end && at_(at) == at_(begin)) ++at;
    return at - begin;
  }
  /// How many numbers from `begin` on come before a run of equal ones.
  std::size_t mixed(std::size_t begin) const {
    const std::size_t end = end_of(begin);
    std::size_t at = begin;
    while (at < end && !(at + 2 < end && at_(at) == at_(at + 1) && at_(at) == at_(at + 2))) ++at;
    return at - begin;
  }

  std::size_t count_;
  At at_;
};

template <typename Number, typename At>
void write_runs(std::size_t count, At at, WordWriter& words) {
  RunWriter<Number, At>(count, at).write(words);
}

/// Unpacks numbers from words.
template <typename Number>
class NumberReader {
 public:
  explicit NumberReader(WordReader& words) : words_(words) {}
  Number operator()() {
    if (left_ == 0) {
      word_ = words_.word();
      left_ = kWordBytes / sizeof(Number);
    }
    const auto number = static_cast<Number>(word_);
    word_ >>= 8 * sizeof(Number);
    --left_;
    return number;
  }

 private:
  WordReader& words_;
  std::uint64_t word_ = 0;
  unsigned left_ = 0;
};

/// Reads `count` numbers to `out`. False if the runs do not fill them exactly.
template <typename Number>
bool read_runs(WordReader& words, std::size_t count, Number* out) {
  NumberReader<Number> numbers(words);
  for (std::size_t at = 0; at < count;) {
    const Number head = numbers();
    const auto length = static_cast<std::size_t>(head >> 1);
    if (length == 0 || length > count - at || words.past_end()) return false;
    const bool equal = (head & 1u) != 0;
    const Number same = equal ? numbers() : Number{0};
    for (const std::size_t end = at + length; at < end; ++at) out[at] = equal ? same : numbers();
  }
  return !words.past_end();
}

}  // namespace tern

#endif
