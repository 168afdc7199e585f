// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How a vehicle at rest finds a way on: it looks around, then flies to lookouts to see what blocks its way, the hidden
// voxel. This part also says where the sensor should look.
#ifndef TERN_FLIGHT_REST_SEARCH_HPP
#define TERN_FLIGHT_REST_SEARCH_HPP

#include <cstdint>

#include "base/progress.hpp"
#include "base/work.hpp"
#include "flight/blocked.hpp"
#include "flight/draft.hpp"
#include "flight/flight_facts.hpp"
#include "flight/nose.hpp"

namespace tern {

/// Cycles at rest without a commit after which the vehicle looks around, and directions of a full turn.
constexpr int kIdleCycles = 3;
constexpr int kDirections = 8;
/// After a look around, the vehicle looks at the place that ended the last proof, for the time of this many directions:
/// a noisy sensor needs some frames.
constexpr int kStares = 5;
/// Bits of RestSearch::sought: all directions of a full turn, the one straight away from the hidden voxel, and whether
/// the vehicle flew straight away already.
constexpr std::uint32_t kAround = (1u << kDirections) - 1;
constexpr std::uint32_t kAway = 1u << kDirections;
constexpr std::uint32_t kWentAway = kAway << 1;

/// A place from where something may be seen.
struct Lookout {
  Vec3 place;              ///< world frame
  double drop;             ///< how far the line of sight drops or climbs across a voxel, in voxels
  std::int32_t direction;  ///< from the hidden voxel to the place; negative: no lookout
  bool is_straight;        ///< the straight way there is known to be free
};

struct RestSearch {
  Vec3 look_at;     ///< the place that the sensor should see for the next plan, world frame
  int idle_cycles;  ///< cycles at rest without a commit
  bool is_looking;  ///< the vehicle looks around
  std::int64_t look_since;
  Vec3 stuck_at;          ///< where the vehicle rested when it began to look for a way on
  bool turned;            ///< the vehicle looked around at `stuck_at`
  bool seeks;             ///< the next plan leads to a lookout
  int lookouts;           ///< lookouts flown to since the vehicle last came nearer to the goal
  std::uint32_t sought;   ///< directions in which a lookout was sought, as bits
  std::int32_t searched;  ///< places that the search for a lookout has looked at
  Lookout lookout;        ///< the best lookout so far

  /// The sensor should see this place.
  void look_towards(const Vec3& place) noexcept { look_at = place; }
  /// Forgets all reasons to give up.
  void try_anew() noexcept;
  void forget_lookouts() noexcept;
  void end_look() noexcept { is_looking = false; }
  /// Forgets all attempts once the vehicle is no longer near the place where it made them.
  void note_place(const FlightFacts& flight) noexcept;
  /// A cycle at rest ended without a commit. True if there were kIdleCycles such cycles in a row.
  bool count_idle() noexcept { return ++idle_cycles >= kIdleCycles; }
  /// After kIdleCycles failed cycles, the vehicle looks around, then flies to lookouts. If nothing helps, it gives up:
  /// the answer says why, otherwise kNone. `is_cut_off`: no way leads to the target.
  FlightReason after_failed_cycle(const FlightFacts& flight, const Blockage& block, bool hemmed_in, bool is_cut_off,
                                  const Nose& nose) noexcept;
  /// True if the next plan leads to a lookout. A look around comes first: it shows more, sooner.
  bool seek_lookout(const FlightFacts& flight, const Blockage& block, bool hemmed_in) noexcept;
  void begin_lookout() noexcept;
  /// Looks for a lookout for a vehicle that rests at the takeover. Waits while the map slides, because nothing is known
  /// of it then.
  Progress find_lookout(const FlightFacts& flight, const Blockage& block, std::int64_t takeover, Work& work) noexcept;
  /// A plan is committed: counts the lookouts that plans lead to.
  void note_commit(const Draft& draft, const Commitment& in_flight) noexcept;
  /// The sensor should see the place that ended the draft's proof. The proof holds until `until`, seconds since the
  /// draft's beginning.
  void look_at_end(const FlightFacts& flight, const Draft& draft, double until) noexcept;
  void look_at_voxel(const FlightFacts& flight, const Voxel& voxel) noexcept;

  /// The next plan leads straight away from the hidden voxel.
  bool goes_away() const noexcept { return (sought & kAway) != 0; }
  /// Where the plan to a lookout leads from a start at rest.
  Vec3 lookout_place(const RollingMap& map, const Blockage& block, const Vec3& start, Work& work) const noexcept;
  /// The place that the sensor should see next: `look_at` or, during a look around, one direction after the other.
  Vec3 looking_at(const FlightFacts& flight, const Nose& nose, std::int64_t t) const noexcept;
  /// The direction of a look around at time `t`, from 0.
  int sector_at(const FlightFacts& flight, const Nose& nose, std::int64_t t) const noexcept;

 private:
  void look_from(const FlightFacts& flight, const Blockage& block, const Vec3& at, Work& work) noexcept;
};

}  // namespace tern

#endif
