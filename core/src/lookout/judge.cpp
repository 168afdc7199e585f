// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The search's last stages: which lookout is the best.
#include "base/math.hpp"
#include "lookout/lookout_search.hpp"
#include "yaw/angle.hpp"

namespace tern {
namespace {

/// Every so many voxels are tried when places are ranked, and when they are ranked again.
constexpr std::int32_t kRankStride = 3;
constexpr std::int32_t kNextStride = 6;
/// Seconds that a look takes, and those until a vehicle that flies somewhere begins to move.
constexpr double kLookSeconds = 0.25;
constexpr double kBeginSeconds = 0.3;
/// If something of the way stays unseen, another lookout will be needed: it takes so many seconds, and the rest of the
/// way counts so many times.
constexpr double kNextLookout = 2.5;
constexpr double kUnseenWay = 2.0;
/// What a lookout costs that shows only a part of what comes first: so many times kNextLookout for nothing of it.
constexpr double kPartPrice = 2.0;
constexpr double kPartBase = 1.2;
/// Voxels that were looked at in vain need a flat line of sight, because what is right below or above them hides them
/// from steep lines: seconds for a line at 45 degrees.
constexpr double kSteepPrice = 6.0;
/// A floor or ceiling fills a part of the voxels alone that were hit. Narrow lines of sight leave out so much of a
/// voxel on each side of a cube's outline, so they pass through the part that is free.
constexpr double kNarrower = 0.75;
/// The middle of what is looked at must be so far away, seen from above, that there is a heading to it, metres.
constexpr double kLeastFlat = 0.3;

std::uint64_t& word_of(std::uint64_t* bits, std::int32_t k) {
  return bits[k / kWordBits];
}

std::uint64_t bit_of(std::int32_t k) {
  return std::uint64_t{1} << k % kWordBits;
}

}  // namespace

/// The vehicle's own place is where it is, and not the centre of a voxel. Of an octet, the layer is taken that is
/// nearer to the height of what should be seen: right above a floor or below a ceiling, only flat lines of sight show
/// it.
Vec3 LookoutSearch::place_of(const RollingMap& map, std::int32_t place) const noexcept {
  if (place == 0) return question.from;
  const Grid& safe = map.safe();
  const Voxel octet = octets_.octet(places_.place[place].octet);
  const Grid& grid = octets_.bit(octets_.known, octet) ? safe : map.route();
  const bool from_top = safe.to_local(wanted_.middle(false)).z > octets_.middle_height(octet, safe.spec().cell);
  return safe.spec().origin + safe.center(octets_.free_voxel(grid, octet, from_top));
}

bool LookoutSearch::aims(const Vec3& place, bool at_all, Heading& heading) const noexcept {
  const Vec3 way = wanted_.middle(at_all) - place;
  const double flat = horizontal_length(way);
  if (!(flat > kLeastFlat)) return false;
  heading = {way.x / flat, way.y / flat};
  return true;
}

double LookoutSearch::seconds_to(std::int32_t place, const Heading& heading) const noexcept {
  const Agility& agility = question.agility;
  const double metres = places_.place[place].steps * octets_.edge;
  const double move = place == 0 ? 0.0 : agility.seconds(metres) + kBeginSeconds;
  const Heading& nose = question.nose;
  const double sine = nose.cosine * heading.sine - nose.sine * heading.cosine;
  const double angle = absolute(angle_of({nose.cosine * heading.cosine + nose.sine * heading.sine, sine}));
  const double turn = optics.is_scanner() ? 0.0 : agility.seconds_to_turn(angle);
  return larger(move, turn) + kLookSeconds;
}

bool LookoutSearch::sees(const RollingMap& map, const SensorPose& pose, const Vec3& centre, Lines lines,
                         Work& work) const noexcept {
  switch (lines) {
    case Lines::kWide:
      return optics.in_wide_sight(map, pose, centre, 0.0, work);
    case Lines::kNarrow:
      return optics.in_wide_sight(map, pose, centre, kNarrower, work);
    case Lines::kThin:
      return optics.in_sight(map, pose.eye, centre, work);
    default:
      return Optics::in_short_sight(map, pose.eye, centre, work);
  }
}

LookoutSearch::Sight LookoutSearch::look(const RollingMap& map, const Tried& tried, const Vec3& place,
                                         const Heading& heading, const Vec3& at, std::int32_t stride, Lines lines,
                                         Work& work) const noexcept {
  const SensorPose pose = optics.pose(place, heading, at);
  Sight sight{{0, 0}, 0, way_count_};
  for (std::int32_t k = 0; k < wanted_.count; k += stride) {
    const WantedVoxel& voxel = wanted_.voxel[k];
    const bool is_seen = optics.in_view(pose, voxel.centre) &&
                         (entry_[k] < 0 || !tried.voxel[entry_[k]].was_tried_from(place)) &&
                         sees(map, pose, voxel.centre, lines, work);
    if (is_seen) {
      word_of(sight.seen, k) |= bit_of(k);
      if (k < wanted_.dense) ++sight.dense;
    } else if (voxel.at < sight.until) {
      sight.until = voxel.at;
    }
  }
  work.spend(8 * ops::kDot * (wanted_.count / stride + 1));
  return sight;
}

/// Seconds until the vehicle is at its goal: those until the voxels are seen, those of the way back to where the way
/// goes on, and what the rest of the way costs.
double LookoutSearch::cost(const RollingMap& map, const Vec3& place, double seconds, const Sight& sight,
                           std::int32_t tested) const noexcept {
  const std::int32_t first = wanted_.voxel[0].at;
  const bool opens = sight.until > first;
  const std::int32_t reached = opens ? sight.until : first;
  const std::int32_t last = reached < way_count_ ? reached : way_count_ - 1;
  const Vec3 goes_on = map.route().spec().origin + way_place(map, last);
  double sum = seconds + question.agility.seconds(distance(place, goes_on));
  if (reached < way_count_) {
    sum += kNextLookout + kUnseenWay * (way_count_ - reached) * octets_.edge / question.agility.speed;
  }
  if (was_tried_ || pass_ > 1) {
    const Vec3 way = wanted_.middle(false) - place;
    sum += kSteepPrice * absolute(way.z) / larger(kLeastFlat, horizontal_length(way));
  }
  if (!opens) sum += kPartPrice * kNextLookout * (kPartBase - static_cast<double>(sight.dense) / tested);
  return sum;
}

bool LookoutSearch::is_worse_than_kept(double cost) const noexcept {
  return finalists_ == kFinalists && cost >= finalist_[kFinalists - 1].cost;
}

/// Of equal ones, the first that was found stays first.
void LookoutSearch::keep(const Candidate& candidate) noexcept {
  if (is_worse_than_kept(candidate.cost)) return;
  std::int32_t slot = finalists_ == kFinalists ? kFinalists - 1 : finalists_++;
  for (; slot > 0 && finalist_[slot - 1].cost > candidate.cost; --slot) finalist_[slot] = finalist_[slot - 1];
  finalist_[slot] = candidate;
}

void LookoutSearch::rank(const RollingMap& map, const Tried& tried, Work& work) noexcept {
  const double cell = map.safe().spec().cell;
  if (at_ == 0) {
    was_tried_ = question.flat;
    for (std::int32_t k = 0; k < wanted_.count; ++k) {
      entry_[k] = tried.find(wanted_.voxel[k].centre, cell);
      was_tried_ = was_tried_ || (k < wanted_.dense && entry_[k] >= 0);
    }
    work.spend(2 * ops::kTurn * wanted_.count * tried.kept_voxels());
  }
  const Vec3 place = place_of(map, at_);
  const std::int32_t stride = pass_ == 0 ? kRankStride : kNextStride;
  const std::int32_t tested = (wanted_.dense + stride - 1) / stride;
  for (int h = 0; h < 2; ++h) {
    const bool at_all = h == 1;
    const Vec3 aimed_at = wanted_.middle(at_all);
    Heading heading;
    if (!aims(place, at_all, heading) || tried.has_failed(place, aimed_at, cell)) continue;
    const double seconds = seconds_to(at_, heading);
    if (is_worse_than_kept(seconds)) continue;
    const Sight sight = look(map, tried, place, heading, aimed_at, stride, kRankedWith[pass_], work);
    for (std::size_t w = 0; w < sizeof ever_seen_ / sizeof ever_seen_[0]; ++w) ever_seen_[w] |= sight.seen[w];
    if (sight.dense > 0) keep({at_, at_all, cost(map, place, seconds, sight, tested)});
  }
  if (++at_ < places_.count) return;
  at_ = 0;
  best_.place = -1;
  stage_ = Stage::kJudge;
}

void LookoutSearch::judge(const RollingMap& map, const Tried& tried, Work& work) noexcept {
  if (at_ < finalists_) {
    const Candidate& candidate = finalist_[at_++];
    const Vec3 place = place_of(map, candidate.place);
    Heading heading;
    if (!aims(place, candidate.at_all, heading)) return;
    const Sight sight = look(map, tried, place, heading, wanted_.middle(candidate.at_all), 1, kJudgedWith[pass_], work);
    if (sight.dense == 0) return;
    const double value = cost(map, place, seconds_to(candidate.place, heading), sight, wanted_.dense);
    if (best_.place >= 0 && value >= best_.cost) return;
    best_ = {candidate.place, candidate.at_all, value};
    best_sight_ = sight;
    return;
  }
  if (best_.place >= 0) return conclude_judging(map);
  if (pass_ + 1 < kPasses) {
    pass_ = finalists_ > 0 || pass_ == 1 ? pass_ + 1 : kPasses - 1;
    at_ = finalists_ = 0;
    stage_ = Stage::kRank;
    return;
  }
  if (!give_up_voxels(map)) return end_in_vain(map);
  begin_way(work);
}

void LookoutSearch::conclude_judging(const RollingMap& map) noexcept {
  lookout.place = place_of(map, best_.place);
  lookout.look = wanted_.middle(best_.at_all);
  aims(lookout.place, best_.at_all, lookout.heading);
  lookout.seconds = seconds_to(best_.place, lookout.heading);
  lookout.hidden_count = 0;
  for (std::int32_t k = 0; k < wanted_.count; ++k) {
    if ((best_sight_.seen[k / kWordBits] & bit_of(k)) != 0) {
      lookout.hidden[lookout.hidden_count++] = wanted_.voxel[k].centre;
    }
  }
  if (target_ == Target::kElsewhere) return begin_target(map, Target::kWayElsewhere, lookout.place);
  end(LookoutAnswer::kFound);
}

/// What comes first can be seen from nowhere: the next way leads past it. False if there is nothing to give up.
bool LookoutSearch::give_up_voxels(const RollingMap& map) noexcept {
  const Grid& safe = map.safe();
  std::int32_t given_up = 0;
  for (std::int32_t k = 0; k < wanted_.dense && given_up < kGivenUp; k += kRankStride) {
    if ((ever_seen_[k / kWordBits] & bit_of(k)) != 0) continue;
    octets_.close_around(safe.voxel_of(safe.to_local(wanted_.voxel[k].centre)), safe.spec().clearance());
    ++given_up;
  }
  return given_up > 0 && ++round_ < kLookoutRounds;
}

}  // namespace tern
