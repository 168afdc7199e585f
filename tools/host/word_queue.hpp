// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_WORD_QUEUE_HPP
#define TERN_HOST_WORD_QUEUE_HPP

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include "host/number.hpp"
#include "host/text_records.hpp"
#include "tern/vec3.hpp"

namespace tern_host {

/// The words of a record after its keyword, one after the other. All throw RecordError where the next word is missing,
/// or is not what was asked for; `what` names it for messages. The words must outlive the queue.
class WordQueue {
 public:
  WordQueue(const Words& words, const Place& place) : words_(words), place_(place) {}

  const std::string& record() const { return words_[0]; }
  bool empty() const { return next_ == words_.size(); }
  /// The next word, which stays. Empty at the end.
  std::string ahead() const { return empty() ? "" : words_[next_]; }

  const std::string& word(const char* what) {
    if (empty()) refuse(quote(record()) + " ends where " + what + " is missing");
    return words_[next_++];
  }
  double value(const char* what) {
    const std::string& found = word(what);
    double value = 0.0;
    if (parse_number(found, value) == NumberError::kMalformed) {
      refuse(quote(found) + " is not a number: it stands where " + what + " belongs");
    }
    return number(found, place_);
  }
  double size(const char* what) {
    const double found = value(what);
    if (!(found >= 0.0)) refuse(std::string(what) + " must not be less than 0");
    return found;
  }
  double above_zero(const char* what) {
    const double found = value(what);
    if (!(found > 0.0)) refuse(std::string(what) + " must be more than 0");
    return found;
  }
  tern::Vec3 vector(const char* what) {
    const double x = value(what);
    const double y = value(what);
    return {x, y, value(what)};
  }
  /// Of so many seconds.
  std::int64_t nanoseconds(const char* what) {
    constexpr double kMostSeconds = 9e9;  // further away, nanoseconds do not fit
    const double seconds = value(what);
    if (!(std::fabs(seconds) <= kMostSeconds)) refuse(std::string(what) + " is too far away");
    return std::llround(seconds * 1e9);
  }
  [[noreturn]] void refuse(const std::string& reason) const { throw RecordError(place_, reason); }

 private:
  const Words& words_;
  const Place& place_;
  std::size_t next_ = 1;
};

}  // namespace tern_host

#endif
