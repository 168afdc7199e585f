// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The currency of work. Plans, maps, proofs, yaw plans and flights all count in it.
#ifndef TERN_WORK_HPP
#define TERN_WORK_HPP

#include <stdint.h>

namespace tern {

/// Operations of a unit. A unit stands for about a thousand instructions of a 64-bit processor, whatever they are for.
constexpr int64_t kUnit = 1000;

/// Work that may be done now, in units. It is counted from sizes and turns of loops, never from time (contract C7), so
/// the same input takes the same work on every machine.
///
/// Work is done in pieces. A piece may begin as long as anything is left, and then runs to its end. What it takes
/// beyond that is a debt. Units that are added later pay the debt first. So if you add n units in each turn of a loop,
/// a turn takes n units in the mean, and at most the longest piece more.
class Work {
 public:
  /// Nothing is left, and there is no debt.
  constexpr Work() noexcept = default;
  explicit constexpr Work(uint32_t units) noexcept : operations_(kUnit * units) {}

  /// Adds units.
  void add(uint32_t units) noexcept { operations_ += kUnit * units; }
  /// True if a piece may begin.
  constexpr bool left() const noexcept { return operations_ > 0; }
  /// Units that are left, the last one perhaps in part; 0 under a debt.
  constexpr uint32_t units() const noexcept {
    return left() ? static_cast<uint32_t>((operations_ + kUnit - 1) / kUnit) : 0;
  }
  /// The part of this work that keeps within `operations`.
  Work within(int64_t operations) const noexcept {
    Work part;
    part.operations_ = operations < operations_ ? operations : operations_;
    return part;
  }
  /// Takes the operations of a piece. An operation is about an instruction.
  void spend(int64_t operations) noexcept { operations_ -= operations; }
  /// Drops a debt.
  void forgive() noexcept { operations_ = left() ? operations_ : 0; }
  /// What is left, in operations; a debt is negative.
  constexpr int64_t operations() const noexcept { return operations_; }

 private:
  int64_t operations_ = 0;
};

}  // namespace tern

#endif
