// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// When the flight looks for a lookout, how it flies there and looks, and what it remembers of it. It begins once the
// end of what is committed stands still, while the vehicle is still on its way there.
#ifndef TERN_FLIGHT_LOOKOUTS_HPP
#define TERN_FLIGHT_LOOKOUTS_HPP

#include <cstdint>

#include "base/work.hpp"
#include "flight/flight_facts.hpp"
#include "flight/nose.hpp"
#include "lookout/lookout_search.hpp"

namespace tern {

/// Lookouts without coming kNearer metres nearer to the next point, after which the vehicle looks for no more: those
/// that showed nothing of what they should, and those that did.
constexpr int kMostLookouts = 8;
constexpr int kMostShown = 32;
constexpr double kNearer = 0.5;
/// Searches in a row that showed nothing and learned less than kLearned words of the map, while nothing that moves held
/// the vehicle up, after which what was tried is forgotten, once, and after as many more of which there is no hope.
constexpr int kInVain = 3;
/// Plans that may follow the last lookout without coming nearer, if they learn less than kLearned words each.
constexpr int kPlansAfterLast = 100;
/// A search without anything unseen leads along the way that is known: the vehicle has come to its end within this
/// distance, metres.
constexpr double kPassed = 1.0;
/// Cycles on the way to a lookout that may fail while the vehicle rests.
constexpr int kFailedCycles = 6;

enum class LookoutPhase : std::uint8_t {
  kIdle,       ///< the flight flies to its goal
  kSearching,  ///< a lookout is sought
  kOnWay,      ///< the vehicle flies there
  kLooking,    ///< it rests there and looks
};

/// How many plans were made, as FlightReport::asked and dropped.
struct PlanCounts {
  std::uint32_t asked;
  std::uint32_t dropped;
};

/// A route that the planner found, world frame: where it begins and ends, and its length, metres.
struct FoundRoute {
  Vec3 from;
  Vec3 to;
  double length;
};

struct Lookouts {
  LookoutPhase phase;
  LookoutSearch search;
  Tried tried;
  std::uint64_t* words;  ///< the caller's

  int left;            ///< lookouts in vain until the vehicle gives up
  int shown;           ///< lookouts that showed some of what they should
  double nearest;      ///< the least distance to the next point since the last reset, metres; negative: not known
  bool is_last_try;    ///< the look around is over, or there were kInVain searches in vain
  int in_vain;         ///< searches in a row that had no answer; in between, nothing was learned or moved in the way
  bool found_nothing;  ///< the last search at this place had no answer
  int wandering_due;   ///< the next lookout at so many plans without coming nearer

  // The end of what is committed stands still.
  Vec3 anchor;  ///< where
  std::int64_t anchored;
  std::uint32_t anchored_plans;
  std::uint64_t anchored_frames;
  std::int64_t not_before;  ///< the next search
  FoundRoute route;         ///< the last one. A length of 0: none
  bool is_due;              ///< the last route turns away, or the vehicle stepped back, and no search has begun since
  std::uint64_t stepped;    ///< what the map had learned when it last stepped back without a lookout

  // On the way, and looking.
  std::int64_t began;
  std::int64_t aligned;  ///< since when the sensor points there; negative: not yet
  std::uint64_t aligned_frames;
  int failed_cycles;
  std::uint64_t learned;  ///< RollingMap::learned() at that time, or at the last search without an answer
  std::int64_t held_up;   ///< Itinerary::held_up at that search

  /// Forgets all reasons to give up, and the lookout.
  void try_anew() noexcept;
  /// Notes where the vehicle is, and whether what is committed still ends at the same place. To be called every tick.
  void note_tick(const FlightFacts& flight, const PlanCounts& plans) noexcept;
  /// Notes a new route. True if the vehicle should look before it follows that: it is much longer than the way by the
  /// last one, although the same place is its end.
  bool turns_away(const FoundRoute& found) noexcept;
  /// A search should begin now.
  bool is_called_for(const FlightFacts& flight, const Nose& nose, const PlanCounts& plans) const noexcept;
  void begin(const FlightFacts& flight, const Nose& nose, const Vec3& look_at) noexcept;
  /// Goes on with the search.
  void advance(const FlightFacts& flight, Work& work) noexcept;
  /// Goes on with the flight to the lookout, and with the look.
  void follow(const FlightFacts& flight, const Nose& nose, const PlanCounts& plans) noexcept;
  /// A cycle on the way to the lookout failed while the vehicle rests.
  void note_failure(const FlightFacts& flight) noexcept;

  /// The flight leads to a lookout, or looks from there.
  bool is_active() const noexcept { return phase == LookoutPhase::kOnWay || phase == LookoutPhase::kLooking; }
  bool is_searching() const noexcept { return phase == LookoutPhase::kSearching; }
  /// No lookout was found here. But for what the map learned since, to step back again leads nowhere.
  bool may_step_back(const RollingMap& map) const noexcept {
    return found_nothing && map.learned() - stepped >= kLearned;
  }
  /// The vehicle steps back without a lookout. From there one is sought first: the next plan may lead to the same
  /// place.
  void note_step_back(const RollingMap& map) noexcept {
    stepped = map.learned();
    is_due = true;
  }
  /// The next plan leads to the lookout.
  bool leads() const noexcept { return phase == LookoutPhase::kOnWay; }
  /// No plan is made: the vehicle is at the lookout, or what is committed leads there.
  bool needs_no_plan(const FlightFacts& flight) const noexcept;
  /// After a look around, there may be a lookout where there was none: forgets what was tried. True if one will be
  /// sought.
  bool searches_again(const FlightFacts& flight) noexcept;
  /// Another lookout may still help a vehicle that rests.
  bool may_help(const FlightFacts& flight) const noexcept;
  /// However often a lookout was sought, what the way needs can be seen from nowhere; or there are no more lookouts,
  /// and the vehicle flies to and fro.
  bool is_hopeless(const FlightFacts& flight) const noexcept;
  /// Writes the voxel that no view shows: one that the last of all lookouts should have shown, one that was looked at
  /// in vain or, if there is none, one that can be seen from nowhere. False if it is not for want of a view that the
  /// vehicle rests.
  bool has_unseen(const FlightFacts& flight, Vec3& centre) const noexcept;
  /// The place to look at from `position`, world frame. Only while it is active.
  Vec3 look_at(const Vec3& position) const noexcept;
  const Vec3& place() const noexcept { return search.lookout.place; }

 private:
  bool wanders(const FlightFacts& flight) const noexcept;
  bool stands_still(const FlightFacts& flight, const PlanCounts& plans) const noexcept;
  std::int32_t count_unseen(const FlightFacts& flight) const noexcept;
  void end(const FlightFacts& flight, bool looked, bool failed) noexcept;
  void note_aligned(const FlightFacts& flight, const Nose& nose) noexcept;
  bool accept(const FlightFacts& flight) noexcept;
  bool last_needed(const FlightFacts& flight, Vec3& centre) const noexcept;
};

}  // namespace tern

#endif
