// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Hits that a thing which moves explains: they mark nothing.
#include "base/math.hpp"
#include "base/work.hpp"
#include "map/map_state.hpp"
#include "map/voxel_words.hpp"

namespace tern {
namespace {

/// Where hits of a frame may be a thing's: its shape about a place, grown on all sides. The window's local frame.
struct Region {
  const Track* thing;
  Vec3 centre;
  double grown;

  /// Half of its extent along an axis.
  double half(int a) const {
    const bool is_flat = thing->shape == TrackShape::kBox || (thing->shape == TrackShape::kCylinder && a == 2);
    return (is_flat ? axis(thing->half, a) : thing->radius) + grown;
  }

  /// Half of its extent along x on the line through a point that is off the centre by y and z; negative if the line
  /// misses it.
  double half_along_x(double y, double z) const {
    if (absolute(z) > half(2) || absolute(y) > half(1)) return -1.0;
    if (thing->shape == TrackShape::kBox) return half(0);
    const double up = thing->shape == TrackShape::kBall ? z : 0.0;
    const double square = half(0) * half(0) - y * y - up * up;
    return square > 0.0 ? square_root(square) : -1.0;
  }
};

/// The difference of two times. Those that 63 bits cannot hold do not occur, but in frames whose time was forgotten.
std::int64_t minus(std::int64_t a, std::int64_t b) {
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(a) - static_cast<std::uint64_t>(b));
}

/// The voxels along an axis whose centres are within `half` of `centre`.
IndexRange centres_within(double centre, double half, double cell, const IndexRange& within) {
  const IndexRange range{ceil_index((centre - half) / cell - 0.5, within.begin, within.end),
                         floor_index((centre + half) / cell - 0.5, within.begin - 1, within.end - 1) + 1};
  return overlap(range, within);
}

/// A thing's place `since` seconds after it was measured, world frame. Before that, it is where its curve begins.
Vec3 place_on(const Track& thing, double since) {
  if (thing.piece_count == 0) return thing.position + since * thing.velocity;
  std::int32_t p = 0;
  while (p + 1 < thing.piece_count && since > thing.pieces[p].duration) since -= thing.pieces[p++].duration;
  const double u = clamp(since / thing.pieces[p].duration, 0.0, 1.0);
  Vec3 points[kControlPoints];
  for (int k = 0; k < kControlPoints; ++k) points[k] = thing.pieces[p].points[k];
  for (int last = kDegree; last > 0; --last) {
    for (int k = 0; k < last; ++k) points[k] = points[k] + u * (points[k + 1] - points[k]);
  }
  return thing.position + points[0];
}

/// False if the thing explains no hits of this frame: it was measured too long before or after, or too badly, or it is
/// gone. A curve is known for all of its time.
bool region_of(const MapState& state, const Track& thing, Region& region) {
  const std::int64_t time = minus(state.frame.time, state.things.begin);
  const bool has_ended = thing.end != TrackEnd::kGoesOn && time > thing.until;
  const bool is_curve = thing.piece_count > 0;
  if (has_ended && (!is_curve || thing.end == TrackEnd::kGone)) return false;
  const std::int64_t when = has_ended ? thing.until : time;
  const double since = 1e-9 * static_cast<double>(minus(when, thing.measured));
  const double apart = absolute(since);
  if (!(apart <= kExplainsFor || (is_curve && since > 0.0))) return false;
  const double error = thing.error + apart * (thing.error_speed + 0.5 * apart * thing.error_growth);
  if (!(error <= kExplainsWithin)) return false;
  const MapSpec& spec = state.spec;
  region.thing = &thing;
  region.centre = state.route.to_local(place_on(thing, since));
  const double far = smaller(distance(region.centre, state.frame.origin), spec.range);
  region.grown = error + spec.pose_margin + spec.angle_margin * far + spec.depth_margin +
                 spec.depth_margin_square * far * far + kHalfDiagonal * spec.cell;
  return true;
}

}  // namespace

void MapState::explain_hits(std::int64_t index, Work& work) const noexcept {
  const bool is_there = index < things.count;
  work.spend(is_there && things.tracks[index].piece_count > 0 ? ops::kPiece + ops::kCurve : ops::kPiece);
  Region region{};
  if (!is_there || !region_of(*this, things.tracks[index], region)) return;
  const double cell = spec.cell;
  const IndexRange across = centres_within(region.centre.y, region.half(1), cell, frame.box.y);
  const IndexRange up = centres_within(region.centre.z, region.half(2), cell, frame.box.z);
  for (std::int32_t z = up.begin; z < up.end; ++z) {
    for (std::int32_t y = across.begin; y < across.end; ++y) {
      const double along = region.half_along_x((y + 0.5) * cell - region.centre.y, (z + 0.5) * cell - region.centre.z);
      if (along < 0.0) continue;
      const VoxelBox part{centres_within(region.centre.x, along, cell, frame.box.x), {y, y + 1}, {z, z + 1}};
      visit_words(part, [&](std::int32_t, std::int32_t, std::int32_t k, std::uint64_t bits) {
        hit[row(y, z) + static_cast<std::size_t>(k)] &= ~bits;
      });
    }
    work.spend((2 * ops::kRow + 2 * ops::kDot + ops::kWord) * (across.end - across.begin));
  }
}

void RollingMap::explain_hits(const Track* tracks, int32_t count, int64_t begin) noexcept {
  if (state_ == nullptr) return;
  state_->things = {tracks, tracks == nullptr ? 0 : count, begin};
}

}  // namespace tern
