// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the model explores, and a state of its world.
#ifndef TERN_TESTS_FLEET_MODEL_SETTING_HPP
#define TERN_TESTS_FLEET_MODEL_SETTING_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "tern/fleet.hpp"

namespace tern_model {

constexpr int kVehicles = 4;
constexpr std::int64_t kTick = 1'000'000'000;
/// By how much the largest speed of a straight plan is above its mean one.
constexpr double kPeak = 2.1875;

/// What the model explores.
struct Setting {
  int vehicles = 3;
  int announcements = 1;       ///< of each vehicle
  int withdrawals = 0;         ///< of each vehicle
  int restarts = 0;            ///< of all together, with the same priority as before and with a higher one
  int departures = 0;          ///< vehicles that may leave
  int last_tick = 4;           ///< of each clock
  int skew = 0;                ///< ticks by which clocks may differ
  int settling = 0;            ///< ticks more until everyone gets on: promises that have to end first
  double seconds = 2.0;        ///< that a plan lasts
  std::size_t in_the_air = 2;  ///< messages of each vehicle that may still arrive: its last ones
  bool in_pieces = false;      ///< state and plans arrive separately
  bool in_slices = false;      ///< proofs go on piece by piece, in steps of their own
  tern::FleetRange range;      ///< members by range; else each knows of each
  bool keeps_first = false;    ///< what was said first, with the plan that is flown, may still arrive
  std::array<std::vector<tern::Vec3>, kVehicles> targets;
  std::array<tern::Vec3, kVehicles> places;
  std::array<std::uint8_t, kVehicles> priorities{};
};

/// A state of the world: numbers of fleets and of the set of messages that were sent, clocks, and what is used up.
struct World {
  std::array<std::uint32_t, kVehicles> fleets{};
  std::uint32_t sent = 0;
  std::array<std::uint16_t, kVehicles> clocks{};
  std::array<std::uint8_t, kVehicles> announced{};
  std::array<std::uint8_t, kVehicles> withdrawn{};
  std::uint8_t restarts = 0;
  std::uint8_t departures = 0;
  std::uint8_t unused[2] = {};

  bool operator==(const World& other) const { return std::memcmp(this, &other, sizeof other) == 0; }
};
static_assert(sizeof(World) == 40, "no padding, so that bytes can be compared");

struct HashOfWorld {
  std::size_t operator()(const World& world) const {
    std::uint64_t words[5] = {};
    std::memcpy(words, &world, sizeof world);
    std::uint64_t hash = 0;
    for (const std::uint64_t word : words) {
      hash = (hash ^ word) * 0x9E3779B97F4A7C15u;
      hash ^= hash >> 29;
    }
    return hash;
  }
};

}  // namespace tern_model

#endif
