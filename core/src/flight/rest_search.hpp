// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a vehicle does that rests without a plan. Where it begins its way to a goal far away, it makes a survey first:
// it looks in all directions, because the way that a lookout is chosen for is a better one if more is known. If no
// lookout helps, it looks around, then at what blocks its way, then gives up. This part also says where the sensor
// should look while there is no lookout.
#ifndef TERN_FLIGHT_REST_SEARCH_HPP
#define TERN_FLIGHT_REST_SEARCH_HPP

#include <cstdint>

#include "flight/blocked.hpp"
#include "flight/draft.hpp"
#include "flight/flight_facts.hpp"
#include "flight/nose.hpp"

namespace tern {

/// Cycles at rest without a commit after which the vehicle looks around, and directions of a full turn.
constexpr int kIdleCycles = 3;
constexpr int kLookDirections = 4;
/// After a look around, the vehicle looks at the place that ended the last proof for so long, nanoseconds: a noisy
/// sensor needs some frames.
constexpr std::int64_t kStare = 3000000000;

struct RestSearch {
  Vec3 look_at;     ///< the place that the sensor should see for the next plan, world frame
  int idle_cycles;  ///< cycles at rest without a commit
  bool is_looking;  ///< the vehicle looks around
  std::int64_t look_since;
  Vec3 stuck_at;  ///< where the vehicle rested when it began to look for a way on
  bool surveys;   ///< the look around is a survey
  bool surveyed;  ///< the vehicle made a survey, or looked around, on its way to the next point
  Vec3 began_at;  ///< where it was when that became the next point
  bool turned;    ///< the vehicle looked around at `stuck_at`, and nothing helped

  /// The sensor should see this place.
  void look_towards(const Vec3& place) noexcept { look_at = place; }
  /// Forgets all reasons to give up; the vehicle is here.
  void try_anew(const Vec3& at) noexcept;
  void end_look() noexcept { is_looking = false; }
  /// Forgets the look around once the vehicle is no longer near the place where it was made.
  void note_place(const FlightFacts& flight) noexcept;
  /// A cycle at rest ended without a commit. True if there were kIdleCycles such cycles in a row.
  bool count_idle() noexcept { return ++idle_cycles >= kIdleCycles; }
  /// After kIdleCycles failed cycles, the vehicle looks around. If that does not help, it gives up: the answer says
  /// why, otherwise kNone. `is_cut_off`: no way leads to the target.
  FlightReason after_failed_cycle(const FlightFacts& flight, bool hemmed_in, bool is_cut_off,
                                  const Nose& nose) noexcept;
  void note_commit() noexcept;
  /// The sensor should see the place that ended the draft's proof. The proof holds until `until`, seconds since the
  /// draft's beginning.
  void look_at_end(const FlightFacts& flight, const Draft& draft, double until) noexcept;
  void look_at_voxel(const FlightFacts& flight, const Voxel& voxel) noexcept;

  /// The place that the sensor should see next: `look_at` or, during a look around, one direction after the other.
  Vec3 looking_at(const FlightFacts& flight, const Nose& nose, std::int64_t t) const noexcept;
  /// The next point is further away than the horizon, the vehicle is where it began its way there, and it did not look
  /// around.
  bool wants_survey(const FlightFacts& flight) const noexcept;
  /// The direction of a look around at time `t`, from 0; kLookDirections during the stare, more after it.
  int sector_at(const FlightFacts& flight, const Nose& nose, std::int64_t t) const noexcept;
};

}  // namespace tern

#endif
