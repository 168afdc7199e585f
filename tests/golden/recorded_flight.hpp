// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The golden flight with a recorder, for the tests of its records.
#ifndef TERN_TESTS_GOLDEN_RECORDED_FLIGHT_HPP
#define TERN_TESTS_GOLDEN_RECORDED_FLIGHT_HPP

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "golden/flight_run.hpp"

namespace tern_golden {

constexpr int kShort = 120;  ///< ticks
constexpr std::size_t kHeadBytes = 40;

using SmallMemory = FlightMemory<40000, 80000>;

/// Flies the golden flight and hands each tick to `see`.
template <typename See>
void fly_recorded(tern::FlightRecorder& recorder, int ticks, See see) {
  const auto memory = std::make_unique<SmallMemory>();
  PillarCamera camera;
  const auto look = [&see](const tern::FlightReport&, const tern::FlightReport&, std::uint64_t) { see(); };
  const FlightTotals totals =
      fly(kSmallFlight, *memory, camera, camera.world, [] { return std::uint64_t{0}; }, look, {ticks, &recorder});
  ASSERT_EQ(totals.started, tern::Status::kOk);
  ASSERT_GT(totals.committed, 0u);
}

inline std::string text(const std::vector<std::uint8_t>& bytes, std::size_t used) {
  return {reinterpret_cast<const char*>(bytes.data()), used};
}

inline std::string record(int ticks, std::size_t room = std::size_t{4} << 20) {
  std::vector<std::uint8_t> bytes(room);
  tern::FlightRecorder recorder;
  EXPECT_EQ(recorder.begin(bytes.data(), bytes.size()), tern::Status::kOk);
  fly_recorded(recorder, ticks, [] {});
  std::size_t used = 0;
  EXPECT_EQ(recorder.close(&used), tern::Status::kOk);
  return text(bytes, used);
}

inline const std::string& short_record() {
  static const std::string bytes = record(kShort);
  return bytes;
}

}  // namespace tern_golden

#endif
