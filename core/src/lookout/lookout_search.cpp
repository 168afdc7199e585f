// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The search's stages up to what the way needs.
#include "lookout/lookout_search.hpp"

#include "base/math.hpp"
#include "grid/lattice.hpp"

namespace tern {
namespace {

/// How far places may be away, metres.
constexpr double kFarthestPlace = 10.0;
/// Beyond the rim of the octets, each metre counts as if it was not seen.
constexpr double kPriceBeyond = kOpenSteps;
/// A known way is flown along only if it has so many octets.
constexpr std::int32_t kLeastLead = 4;

/// The voxel of a place, or of the nearest place in the window.
Voxel voxel_near(const Grid& grid, const Vec3& world) {
  Voxel voxel = grid.voxel_of(grid.to_local(world));
  const Voxel& dims = grid.spec().dims;
  for (int a = 0; a < 3; ++a) {
    if (axis(voxel, a) < 0) axis(voxel, a) = 0;
    if (axis(voxel, a) >= axis(dims, a)) axis(voxel, a) = axis(dims, a) - 1;
  }
  return voxel;
}

}  // namespace

std::size_t LookoutSearch::words(const Voxel& dims) noexcept {
  return (2 + kWaveLayers) * octet_layer_words(dims);
}

void LookoutSearch::begin(const RollingMap& map, const LookoutQuestion& asked, std::uint64_t* words) noexcept {
  question = asked;
  words_ = words;
  const Grid& safe = map.safe();
  layer_ = octet_layer_words(safe.spec().dims);
  octets_.place(safe, voxel_near(safe, asked.from), words);
  start_octet_ = octets_.of(voxel_near(safe, asked.from));
  lookout.hidden_count = 0;
  has_needed = false;
  begin_target(map, Target::kGoal, asked.goal);
}

void LookoutSearch::begin_target(const RollingMap& map, Target target, const Vec3& goal) noexcept {
  const Grid& safe = map.safe();
  target_ = target;
  goal_ = goal;
  goal_octet_ = octets_.of(safe.voxel_of(safe.to_local(goal)));
  goal_inside_ = octets_.has(goal_octet_);
  stage_ = Stage::kRead;
  plane_ = round_ = 0;
}

/// What the way needs can be seen from no place within reach. If a place elsewhere is known, the vehicle flies there as
/// far as it gets: the places within reach are the middles of voxels, and plans lead between them, too.
void LookoutSearch::end_in_vain(const RollingMap& map) noexcept {
  if (target_ == Target::kGoal) return begin_target(map, Target::kElsewhere, goal_);
  end(target_ == Target::kWayElsewhere ? LookoutAnswer::kFound : LookoutAnswer::kNoSight);
}

Progress LookoutSearch::advance(const RollingMap& map, const Tried& tried, Work& work) noexcept {
  while (stage_ != Stage::kOver) {
    if (!work.left()) return Progress::kMore;
    work.spend(ops::kPiece);
    if (stage_ == Stage::kRead) {
      read(map, tried, work);
    } else if (stage_ == Stage::kReach) {
      reach(work);
    } else if (stage_ == Stage::kWay) {
      find_way(map, work);
      if (stage_ == Stage::kNeeds) take_way(work);
    } else if (stage_ == Stage::kNeeds) {
      find_needs(map, work);
    } else if (stage_ == Stage::kRank) {
      rank(map, tried, work);
    } else {
      judge(map, tried, work);
    }
  }
  return Progress::kDone;
}

void LookoutSearch::end(LookoutAnswer with) noexcept {
  answer = with;
  stage_ = Stage::kOver;
}

void LookoutSearch::read(const RollingMap& map, const Tried& tried, Work& work) noexcept {
  octets_.read_plane(map, plane_++, work);
  if (plane_ < octets_.count.z) return;
  const Grid& safe = map.safe();
  const double radius = safe.spec().clearance();
  for (std::int32_t k = 0; k < tried.kept_voxels(); ++k) {
    const Vec3& centre = tried.voxel[k].centre;
    if (!tried.voxel[k].is_hopeless() || !is_unseen_at(map, centre)) continue;
    octets_.close_around(safe.voxel_of(safe.to_local(centre)), radius);
    work.spend(64 * ops::kTurn);
  }
  wave_.begin(octets_, words_ + 2 * layer_, layer_, work);
  wave_.seed(octets_, start_octet_);
  places_.begin(octets_.index(start_octet_));
  stage_ = Stage::kReach;
}

void LookoutSearch::reach(Work& work) noexcept {
  const bool everywhere = target_ == Target::kElsewhere;
  wave_.advance(octets_, everywhere, work);
  places_.take_front(octets_, wave_, everywhere, work);
  if (wave_.is_over || wave_.step * octets_.edge > kFarthestPlace) begin_way(work);
}

void LookoutSearch::begin_way(Work& work) noexcept {
  if (goal_inside_ && !octets_.bit(octets_.known, goal_octet_)) {
    octets_.open[octets_.row(goal_octet_)] |= std::uint64_t{1} << goal_octet_.x;
  }
  wave_.begin(octets_, words_ + 2 * layer_, layer_, work);
  wave_.seed(octets_, start_octet_);
  rim_cost_ = -1.0;
  way_count_ = 0;
  stage_ = Stage::kWay;
}

/// One step towards the goal, or the rim. Where the rest of the way is as long as the straight line at least, no later
/// place of the rim can be better once the wave alone is longer than the best one's.
void LookoutSearch::find_way(const RollingMap& map, Work& work) noexcept {
  const bool is_there = goal_inside_ && wave_.has(octets_, goal_octet_);
  const bool has_best = !goal_inside_ && rim_cost_ >= 0.0 && wave_.step > rim_cost_;
  if (is_there || has_best || (wave_.is_over && rim_cost_ >= 0.0)) {
    stage_ = Stage::kNeeds;
    return;
  }
  // If a way was given up, there is one, but it needs what can be seen from nowhere.
  if (wave_.is_over) return round_ > 0 ? end_in_vain(map) : end(LookoutAnswer::kNoWay);
  wave_.advance(octets_, true, work);
  if (!goal_inside_) note_rim(work);
}

void LookoutSearch::note_rim(Work& work) noexcept {
  std::int32_t turns = 0;
  for (std::int32_t z = wave_.planes.begin; z < wave_.planes.end; ++z) {
    for (std::int32_t y = wave_.rows.begin; y < wave_.rows.end; ++y) {
      const bool is_face = z == 0 || y == 0 || z == octets_.count.z - 1 || y == octets_.count.y - 1;
      const std::uint64_t ends = std::uint64_t{1} | std::uint64_t{1} << (octets_.count.x - 1);
      std::uint64_t bits = wave_.front[octets_.row({0, y, z})] & (is_face ? kAllBits : ends);
      for (; bits != 0; bits &= bits - 1) {  // 64 turns at most
        const Voxel at{__builtin_ctzll(bits), y, z};
        const Vec3 off{static_cast<double>(goal_octet_.x - at.x), static_cast<double>(goal_octet_.y - at.y),
                       static_cast<double>(goal_octet_.z - at.z)};
        const double cost = wave_.step + kPriceBeyond * length(off);
        ++turns;
        if (rim_cost_ >= 0.0 && cost >= rim_cost_) continue;
        rim_cost_ = cost;
        rim_octet_ = octets_.index(at);
      }
    }
  }
  work.spend(2 * ops::kWord * (wave_.planes.end - wave_.planes.begin) * (wave_.rows.end - wave_.rows.begin) +
             3 * ops::kTurn * turns);
}

void LookoutSearch::take_way(Work& work) noexcept {
  way_count_ = wave_.way_to(octets_, goal_inside_ ? goal_octet_ : octets_.octet(rim_octet_), way_, work);
  std::int32_t unknown = 0;
  for (std::int32_t k = 0; k < way_count_; ++k) {
    unknown += octets_.bit(octets_.known, octets_.octet(way_[k])) ? 0 : 1;
  }
  const std::int32_t sparse = kMaxWanted - kDenseWanted;
  share_ = unknown > 0 && unknown < sparse ? sparse / unknown : 1;
  wanted_.clear();
  at_ = 0;
}

Vec3 LookoutSearch::way_place(const RollingMap& map, std::int32_t at) const noexcept {
  const Grid& route = map.route();
  if (goal_inside_ && at == way_count_ - 1) return route.to_local(goal_);
  return route.center(octets_.free_voxel(route, octets_.octet(way_[at])));
}

/// The goal's ball is wanted exactly, even if the octet of the goal is known.
void LookoutSearch::find_needs(const RollingMap& map, Work& work) noexcept {
  const bool is_goal = goal_inside_ && at_ == way_count_ - 1;
  if (at_ < way_count_ && (is_goal || !octets_.bit(octets_.known, octets_.octet(way_[at_])))) {
    const double radius = map.safe().spec().clearance();
    wanted_.add_around(map, way_place(map, at_), radius, at_, share_, work);
    if (is_goal && question.lands && target_ != Target::kWayElsewhere)
      wanted_.add_site(map, way_place(map, at_), radius, question.ground, at_, work);
  }
  if (++at_ < way_count_) return;
  if (wanted_.count == 0) return lead_on(map);
  if (!has_needed) needed = wanted_.voxel[0].centre;
  has_needed = true;
  if (wanted_.dense == 0) wanted_.dense = wanted_.count;
  at_ = finalists_ = 0;
  pass_ = 0;
  for (std::uint64_t& word : ever_seen_) word = 0;
  stage_ = Stage::kRank;
}

/// The flight does not take the way that is known: a place on it may be easier to fly to.
void LookoutSearch::lead_on(const RollingMap& map) noexcept {
  const Grid& safe = map.safe();
  std::int32_t last = way_count_ - 1;
  while (last > 0 && !octets_.bit(octets_.known, octets_.octet(way_[last]))) --last;
  if (last < kLeastLead) return end_in_vain(map);
  lookout.place = safe.spec().origin + safe.center(octets_.free_voxel(safe, octets_.octet(way_[last])));
  lookout.look = goal_;
  const Vec3 way = lookout.look - lookout.place;
  const double flat = horizontal_length(way);
  lookout.heading = flat > octets_.edge ? Heading{way.x / flat, way.y / flat} : question.nose;
  lookout.hidden_count = 0;
  lookout.seconds = question.agility.seconds(last * octets_.edge);
  end(LookoutAnswer::kNothingUnseen);
}

}  // namespace tern
