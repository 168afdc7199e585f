// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Short moves without the planner. Giving way at rest, out of the way of a thing that is expected where the vehicle
// rests, or is about to: a thing that is near leaves no time for a plan. And stepping back to where a plan can begin.
#ifndef TERN_FLIGHT_SIDESTEP_HPP
#define TERN_FLIGHT_SIDESTEP_HPP

#include <cstdint>

#include "base/progress.hpp"
#include "base/work.hpp"
#include "flight/draft.hpp"
#include "flight/flight_facts.hpp"
#include "flight/track_table.hpp"

namespace tern {

/// The sides are those of a cube, its edges and its corners, seen from its middle; each is tried with two lengths.
constexpr int kSides = 26;
constexpr int kSidesteps = 2 * kSides;
/// Places that a vehicle may step back to.
constexpr int kPlacesBack = 4;
/// Voxels around the vehicle that are looked at for them: so many along each axis and direction, and all.
constexpr std::int32_t kMostBack = 4;
constexpr std::int32_t kVoxelsBack = (2 * kMostBack + 1) * (2 * kMostBack + 1) * (2 * kMostBack + 1);
/// Units to judge all of them and to prove some.
constexpr std::uint32_t kSidestepWork = 6000;

struct Sidesteps {
  int stays;                       ///< for so many steps the end of the committed plan stays clear
  int candidate;                   ///< that was made last; it is scored, or, with all scored, proven
  bool is_proving;                 ///< that one is being proven
  bool are_scored;                 ///< all are
  std::int16_t score[kSidesteps];  ///< 0: not to be flown
  Vec3 place[kPlacesBack];         ///< to step back to, the nearest first, world frame
  int places;                      ///< 0: the vehicle gives way

  void begin(int steps_of_staying) noexcept;
  /// The candidates lead straight to one of the free voxels that are nearest to this place. False if there is none near
  /// it.
  bool begin_back(const Grid& safe, const Vec3& from, int steps_of_staying) noexcept;
  /// The same again, because what the proofs were made with changed.
  void begin_anew() noexcept;
  /// The sidesteps whose ends stay clear for longest come first, and of these those that lead nearer to the target.
  /// kDone: the draft is one of them, and it is proven. kFailed: none that is better than to stay is.
  Progress advance(const FlightFacts& flight, const TrackTable& expected, Draft& draft, Work& work) noexcept;

 private:
  bool next() noexcept;
  void add_place(const Vec3& centre, const Vec3& from) noexcept;
  bool make(const FlightFacts& flight, Draft& draft, Work& work) const noexcept;
  int score_of(const FlightFacts& flight, const TrackTable& expected, Draft& draft, Work& work) const noexcept;
};

/// Ticks from the beginning of a sidestep to its takeover.
std::int64_t sidestep_ticks(const FlightSpec& spec) noexcept;

/// For how many steps the end of the committed plan stays clear, from this takeover or from that end on.
int steps_at_end(const FlightFacts& flight, const TrackTable& expected, std::int64_t takeover, Work& work) noexcept;

/// True if the vehicle rests soon after this takeover, where a thing is expected within a short time. `stays` receives
/// for how many steps that place stays clear.
bool is_in_the_way(const FlightFacts& flight, const TrackTable& expected, std::int64_t takeover, int& stays,
                   Work& work) noexcept;

}  // namespace tern

#endif
