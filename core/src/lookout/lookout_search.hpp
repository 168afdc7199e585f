// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// From where the vehicle should look so that it gets to its goal soonest. A wave through known octets reaches the
// places that it can fly to; another one, through open octets as well, finds the way to the goal, and with it the
// voxels that the way needs. From every place and with two headings, a third of those voxels is tried; the best of
// these lookouts are judged with all of them.
//
// If no place that the vehicle can reach shows what the way needs, the search finds one that would show it, anywhere,
// and then a lookout for the way to that place.
#ifndef TERN_LOOKOUT_LOOKOUT_SEARCH_HPP
#define TERN_LOOKOUT_LOOKOUT_SEARCH_HPP

#include <cstddef>
#include <cstdint>

#include "base/progress.hpp"
#include "base/work.hpp"
#include "lookout/octets.hpp"
#include "lookout/optics.hpp"
#include "lookout/places.hpp"
#include "lookout/tried.hpp"
#include "lookout/wanted.hpp"
#include "lookout/wave.hpp"
#include "tern/map.hpp"
#include "tern/yaw.hpp"

namespace tern {

/// Lookouts that are judged with all voxels.
constexpr std::int32_t kFinalists = 8;
/// How often a way is sought past voxels that can be seen from nowhere.
constexpr std::int32_t kLookoutRounds = 3;
/// Voxels that a round gives up, at most.
constexpr std::int32_t kGivenUp = 8;

struct LookoutQuestion {
  Vec3 from;  ///< where the vehicle will be, world frame
  Vec3 goal;
  Heading nose;  ///< where it will point there; of length 1
  Agility agility;
  bool flat = false;    ///< flat lines of sight are worth more than short ways
  bool lands = false;   ///< the vehicle is to descend from the goal to the ground,
  double ground = 0.0;  ///< which is no higher than this, world frame, metres
};

/// A lookout, or a place on a way that is known to be free.
struct Viewpoint {
  Vec3 place;  ///< world frame, in known space
  Heading heading;
  Vec3 look;                ///< the middle of what is to be seen
  Vec3 hidden[kMaxWanted];  ///< the voxels that should be seen from there: their centres
  std::int32_t hidden_count;
  double seconds;  ///< until they are seen
};

/// What a search found.
enum class LookoutAnswer : std::uint8_t {
  kFound,
  kNothingUnseen,  ///< all of the way is known, as far as the octets reach: `lookout` is the last place of it
  kNoWay,          ///< no way leads to the goal
  kNoSight,        ///< what the way needs can be seen from nowhere
};

struct LookoutSearch {
  LookoutQuestion question;
  Optics optics;
  Viewpoint lookout;
  LookoutAnswer answer;
  Vec3 needed;      ///< the first voxel that the way to the goal needs and nobody saw, world frame. Only if has_needed
  bool has_needed;  ///< there is one

  /// Words that a search needs for a map of these dimensions.
  static std::size_t words(const Voxel& dims) noexcept;
  /// Begins a search. Both grids of the map must be inflated, and must not change until the search is over. `words`:
  /// words() of them.
  void begin(const RollingMap& map, const LookoutQuestion& asked, std::uint64_t* words) noexcept;
  /// kDone: `answer` is there.
  Progress advance(const RollingMap& map, const Tried& tried, Work& work) noexcept;

 private:
  enum class Stage : std::uint8_t { kRead, kReach, kWay, kNeeds, kRank, kJudge, kOver };
  /// What the stages look for, in turn: a lookout for the way to the goal, a place anywhere that would be one, and a
  /// lookout for the way to that place.
  enum class Target : std::uint8_t { kGoal, kElsewhere, kWayElsewhere };
  /// How a voxel is seen: in_wide_sight(), the same with less of the outline, in_sight() or in_short_sight().
  enum class Lines : std::uint8_t { kWide, kNarrow, kThin, kShort };
  static constexpr int kPasses = 4;
  static constexpr Lines kRankedWith[kPasses] = {Lines::kThin, Lines::kWide, Lines::kNarrow, Lines::kShort};
  static constexpr Lines kJudgedWith[kPasses] = {Lines::kWide, Lines::kWide, Lines::kNarrow, Lines::kShort};
  /// A place with a heading, and how good it is: seconds until the vehicle is at its goal, compared with other ones.
  struct Candidate {
    std::int32_t place;
    bool at_all;  ///< its heading is that to the mean of all voxels, otherwise to that of the dense ones
    double cost;
  };
  /// What is seen from a candidate.
  struct Sight {
    std::uint64_t seen[(kMaxWanted + 63) / 64];
    std::int32_t dense;  ///< how many of the dense voxels
    std::int32_t until;  ///< the way is seen up to this place of it
  };

  void begin_target(const RollingMap& map, Target target, const Vec3& goal) noexcept;
  void end_in_vain(const RollingMap& map) noexcept;
  void read(const RollingMap& map, const Tried& tried, Work& work) noexcept;
  void reach(Work& work) noexcept;
  void begin_way(Work& work) noexcept;
  void find_way(const RollingMap& map, Work& work) noexcept;
  void note_rim(Work& work) noexcept;
  void take_way(Work& work) noexcept;
  void find_needs(const RollingMap& map, Work& work) noexcept;
  void rank(const RollingMap& map, const Tried& tried, Work& work) noexcept;
  void keep(const Candidate& candidate) noexcept;
  bool is_worse_than_kept(double cost) const noexcept;
  void judge(const RollingMap& map, const Tried& tried, Work& work) noexcept;
  void conclude_judging(const RollingMap& map) noexcept;
  bool give_up_voxels(const RollingMap& map) noexcept;
  void lead_on(const RollingMap& map) noexcept;
  void end(LookoutAnswer with) noexcept;

  Vec3 place_of(const RollingMap& map, std::int32_t place) const noexcept;
  Vec3 way_place(const RollingMap& map, std::int32_t at) const noexcept;
  bool aims(const Vec3& place, bool at_all, Heading& heading) const noexcept;
  double seconds_to(std::int32_t place, const Heading& heading) const noexcept;
  bool sees(const RollingMap& map, const SensorPose& pose, const Vec3& centre, Lines lines, Work& work) const noexcept;
  Sight look(const RollingMap& map, const Tried& tried, const Vec3& place, const Heading& heading, const Vec3& at,
             std::int32_t stride, Lines lines, Work& work) const noexcept;
  double cost(const RollingMap& map, const Vec3& place, double seconds, const Sight& sight,
              std::int32_t tested) const noexcept;

  Stage stage_;
  Target target_;
  Vec3 goal_;  ///< of the way that is sought, world frame
  std::uint64_t* words_;
  std::size_t layer_;
  Octets octets_;
  Wave wave_;
  Places places_;
  std::int32_t plane_;  ///< the next plane to read
  std::int32_t round_;
  Voxel start_octet_;
  Voxel goal_octet_;
  bool goal_inside_;  ///< the goal is in an octet, otherwise the way leads to the rim
  double rim_cost_;   ///< of the best place of the rim so far, in octets; negative: none
  std::int32_t rim_octet_;
  std::int32_t way_[kMaxWave];
  std::int32_t way_count_;
  std::int32_t at_;     ///< the next place of the way, place or finalist
  std::int32_t share_;  ///< voxels that each place of the sparse part may want
  Wanted wanted_;
  std::int32_t entry_[kMaxWanted];  ///< of each wanted voxel in Tried; negative: none
  bool was_tried_;                  ///< some of the dense voxels were looked at in vain
  std::uint64_t ever_seen_[(kMaxWanted + 63) / 64];
  Candidate finalist_[kFinalists];
  std::int32_t finalists_;
  /// 0: places are ranked with thin lines of sight, and judged with wide ones. 1: ranked with wide ones as well,
  /// because none of the first finalists saw anything. 2: narrow ones have to do. 3: short ones.
  int pass_;
  Candidate best_;
  Sight best_sight_;
};

}  // namespace tern

#endif
