// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_COMPANION_CLOCK_SYNC_HPP
#define TERN_COMPANION_CLOCK_SYNC_HPP

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace tern_companion {

constexpr std::int64_t kSecond = 1000000000;  ///< ns

/// What the autopilot's clock, which counts from its boot, shows on the companion's clock. From TIMESYNC: each answer
/// says what the autopilot's clock showed between two times of the companion's. Of the last ones, that with the
/// shortest way there and back counts. Nanoseconds.
class ClockSync {
 public:
  /// An answer to the request that was sent at `sent` came at `now`; the autopilot's clock showed `theirs`.
  void answered(std::int64_t sent, std::int64_t theirs, std::int64_t now) {
    const std::int64_t way = now - sent;
    if (way < 0 || way > kLongestWay) return;
    const std::int64_t offset = sent + way / 2 - theirs;
    if (count_ > 0 && std::abs(offset - best().offset) > kJump) {
      count_ = 0;
      ++restarts_;
    }
    kept_[count_++ % kept_.size()] = {offset, way};
  }
  /// True once enough answers came.
  bool known() const { return count_ >= kEnough; }
  /// The autopilot's clock is another one than before: it was restarted or set.
  std::uint32_t restarts() const { return restarts_; }
  std::int64_t to_own(std::int64_t theirs) const { return theirs + best().offset; }
  /// The longest error of to_own(), but for drift since then.
  std::int64_t uncertainty() const { return best().way / 2; }

 private:
  struct Answer {
    std::int64_t offset, way;
  };
  static constexpr std::int64_t kLongestWay = 100000000, kJump = 200000000;
  static constexpr std::size_t kEnough = 3;

  const Answer& best() const {
    const auto end = kept_.begin() + static_cast<std::ptrdiff_t>(std::min(count_, kept_.size()));
    return *std::min_element(kept_.begin(), end, [](const Answer& a, const Answer& b) { return a.way < b.way; });
  }

  std::array<Answer, 16> kept_{};
  std::size_t count_ = 0;
  std::uint32_t restarts_ = 0;
};

}  // namespace tern_companion

#endif
