// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A simulated flight that a far way leads: its coarse grid knows all blocks and cylinders of the world but those that
// are unmapped.
#ifndef TERN_HOST_FLIGHT_FAR_GUIDE_HPP
#define TERN_HOST_FLIGHT_FAR_GUIDE_HPP

#include <cstdint>
#include <memory>
#include <vector>

#include "host/flight/flight_world.hpp"
#include "tern/far_way.hpp"
#include "tern/flight.hpp"

namespace tern_host {

/// What became of the far way.
struct FarTotals {
  int searches = 0;  ///< 0: the flight had none
  int marked = 0;    ///< cells of the coarse grid
};

/// Throws RecordError where the world asks for a far way, and for more than one goal in the air, or for coarse cells
/// that are too large for its window.
void refuse_far_way(const FlightWorld& world, const Place& place);

class FarGuide {
 public:
  /// Throws std::runtime_error where no coarse grid can be made.
  explicit FarGuide(const FlightWorld& world);

  /// Before a tick, with the last report. True: the flight's goal is now goal().
  bool tick(const tern::Vec3& position, const tern::FlightReport& report, const tern::RollingMap& map, std::int64_t t);
  const tern::Vec3& goal() const { return far_.near_goal(); }
  /// True if that is the world's goal.
  bool is_last() const { return far_.is_last(); }
  FarTotals totals() const { return {far_.searches(), far_.marked()}; }

 private:
  std::uint32_t work_;
  std::vector<std::uint64_t> words_;
  tern::Grid coarse_;
  std::unique_ptr<tern::Workspace> memory_;
  tern::Planner planner_;
  tern::FarWay far_;
};

}  // namespace tern_host

#endif
