// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "flight/foresight.hpp"

#include "tracks/thing.hpp"

namespace tern {
namespace {

/// Instants of a plan that are looked at.
constexpr int kInstants = 6;
/// Operations of one thing at one instant.
constexpr Operations kLookOperations = 6 * ops::kDot + 2 * ops::kTurn;

Things things_of(const TrackTable& table, double clearance, std::int64_t begin) {
  Things things;
  things.tracks = table.tracks;
  things.count = table.count;
  things.radius = clearance;
  things.begin = begin;
  return things;
}

/// In both of its tubes: what is clear of one is clear of the thing.
bool is_met_by(const Things& things, const Track& track, const Vec3& place, double at) {
  Track alone = track;
  alone.reach = 0.0;
  if (!is_too_near(things, alone, place, at)) return false;
  if (!(track.reach > 0.0)) return true;
  if (track.piece_count > 0) alone.position = track.position + track.pieces[0].points[0];
  alone.piece_count = 0;
  alone.velocity = kZero;
  alone.error_speed = track.reach;
  alone.error_growth = 0.0;
  return is_too_near(things, alone, place, at);
}

bool is_met(const Things& things, const Vec3& place, double at, Work& work) {
  work.spend(ops::kCurve + 2 * kLookOperations * things.count);
  for (std::int32_t k = 0; k < things.count; ++k) {
    if (is_met_by(things, things.tracks[k], place, at)) return true;
  }
  return false;
}

}  // namespace

bool meets_thing(const Trajectory& plan, double from, const TrackTable& things, double clearance, Work& work) noexcept {
  const Things all = things_of(things, clearance, plan.begin);
  const double end = duration(plan);
  // The end first: there, tubes are largest.
  for (int k = 0; k < kInstants && all.count > 0; ++k) {
    const double at = end - (end - from) * k / kInstants;
    if (is_met(all, evaluate(plan, at).position, at, work)) return true;
  }
  return false;
}

int rest_steps(const Trajectory& plan, double from, const TrackTable& things, double clearance, Work& work) noexcept {
  const Things all = things_of(things, clearance, plan.begin);
  const Vec3 place = evaluate(plan, duration(plan)).position;
  for (int k = 1; k <= kRestSteps && all.count > 0; ++k) {
    if (is_met(all, place, from + k * kRestStep, work)) return k - 1;
  }
  return kRestSteps;
}

}  // namespace tern
