// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A short flight that needs a new plan every few ticks, small enough for the tiny profile.
#ifndef TERN_TESTS_CAPACITY_HOP_HPP
#define TERN_TESTS_CAPACITY_HOP_HPP

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "support/owned_map.hpp"
#include "tern/flight.hpp"

namespace tern_capacity {

/// A box that turns up on the way.
enum class Surprise {
  kNone,
  kFar,   ///< far enough ahead for any brake
  kNear,  ///< too near for a straight one: the vehicle slows down along its way
};

/// 16 x 8 x 4 m, unknown at first, free but for a wall with a way around it.
class Hop {
 public:
  explicit Hop(Surprise surprise);
  /// What start() answered.
  tern::Status started() const { return status_; }
  /// What is wrong with the flight; empty where nothing is. With `may_touch`, it may come near to an obstacle if it
  /// reports a threat or, at rest, an obstacle in its way.
  std::string fly(bool may_touch = false);
  tern::FlightReason reason() const { return reason_; }
  /// Of the flight so far.
  std::uint64_t commands_hash() const { return hash_; }

 private:
  /// What a sensor sees; obstacles stay.
  void look_around(const tern::Vec3& at);
  void add(const tern::Box& box);
  void note_thing();
  void be_surprised();
  double clearance(const tern::Vec3& p) const;
  std::string wrong_with(const tern::Sample& last, const tern::Sample& now) const;
  std::string wrong_place(const tern::Sample& now) const;

  Surprise surprise_;
  tern_test::OwnedMap map_;
  std::unique_ptr<tern::Workspace> memory_;
  tern::Planner planner_;
  tern::FlightSpec spec_;
  std::vector<std::uint64_t> words_;
  tern::Flight flight_;
  tern::Status status_;
  std::vector<tern::Box> boxes_;
  tern::FlightReason reason_ = tern::FlightReason::kNone;
  std::uint64_t hash_ = 0xCBF29CE484222325u;
};

}  // namespace tern_capacity

#endif
