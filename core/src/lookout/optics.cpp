// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lookout/optics.hpp"

#include "base/math.hpp"
#include "grid/bit_rows.hpp"
#include "path/sight.hpp"
#include "yaw/angle.hpp"

namespace tern {
namespace {

/// A wider horizontal angle of view than this is a scanner's, rad.
constexpr double kWidestCamera = 3.0;
/// Directions steeper than this tangent count as this steep.
constexpr double kSteepest = 100.0;
/// Lines of sight between paths' corners mostly end at the first rows that they meet. These are mostly free: they take
/// so many times what sight_operations() says.
constexpr Operations kWholeSight = 6;
/// A cube's nearest face counts as no nearer than this part of its depth.
constexpr double kLeastDepth = 0.1;
/// A scan sees nothing within so many of its pixels of a thing's direction, or of the edge of the view.
constexpr double kScanEdge = 1.25;

double tangent_of(double angle) {
  const Heading at = heading_of(angle);
  if (absolute(at.sine) < kSteepest * at.cosine) return at.sine / at.cosine;
  return at.sine < 0.0 ? -kSteepest : kSteepest;
}

/// Half of a cube's extent along a unit vector, in edges.
double half_extent(const Vec3& along) {
  return 0.5 * (absolute(along.x) + absolute(along.y) + absolute(along.z));
}

/// Least and largest tangents of a cube's outline on one axis of the image: `off` is the centre's distance from the
/// image's middle, `reach` half the cube's extent, all at depths from `near` to `far`.
struct Range {
  double least, most;
};

Range outline(double off, double reach, double near, double far) {
  const double low = off - reach;
  const double high = off + reach;
  return {low / (low < 0.0 ? near : far), high / (high < 0.0 ? far : near)};
}

/// A scanner's axes for what lies in this direction, of length 1.
SensorPose facing(const Vec3& eye, const Vec3& ahead) {
  const double flat = horizontal_length(ahead);
  const Vec3 right = flat > 0.0 ? Vec3{ahead.y / flat, -ahead.x / flat, 0.0} : Vec3{1.0, 0.0, 0.0};
  return {eye, ahead, right, cross(ahead, right)};
}

/// From the eye to `behind` metres behind the centre.
bool line_is_free(const RollingMap& map, const Vec3& eye, const Vec3& centre, double behind, Work& work) {
  const Grid& grid = map.route();
  const Vec3 from = grid.to_local(eye);
  const Vec3 to = grid.to_local(centre);
  const Vec3 way = to - from;
  const double far = length(way);
  if (!(far > 0.0)) return true;
  const Vec3 beyond = to + (behind / far) * way;
  const bool is_inside = grid.inside(grid.voxel_of(beyond));
  work.spend(kWholeSight * sight_operations(grid, from, beyond));
  return line_of_sight(GridAccess::bare(grid), from, is_inside ? beyond : to);
}

}  // namespace

Optics::Optics(const FlightSensor& sensor, const MapSpec& map) noexcept
    : sensor_(sensor),
      is_scanner_(sensor.horizontal > kWidestCamera),
      tangent_right_(tangent_of(0.5 * smaller(sensor.horizontal, kWidestCamera))),
      tangent_down_(tangent_of(0.5 * sensor.vertical)),
      cosine_side_(heading_of(0.5 * sensor.horizontal).cosine),
      tangent_low_(tangent_of(sensor.pitch_min)),
      tangent_high_(tangent_of(sensor.pitch_max)),
      tangent_bottom_(tangent_of(sensor.raised - 0.5 * sensor.vertical)),
      tangent_top_(tangent_of(sensor.raised + 0.5 * sensor.vertical)),
      cell_(map.cell),
      range_(map.range),
      margin_(map.depth_margin),
      margin_square_(map.depth_margin_square),
      pose_margin_(map.pose_margin),
      angle_margin_(map.angle_margin + (is_scanner_ ? kScanEdge * map.scan_pixel : 0.0)) {}

SensorPose Optics::pose(const Vec3& place, const Heading& heading, const Vec3& look) const noexcept {
  const double c = heading.cosine;
  const double s = heading.sine;
  const Vec3& o = sensor_.offset;
  const Vec3 eye = place + Vec3{c * o.x - s * o.y, s * o.x + c * o.y, o.z};
  const Vec3 way = look - eye;
  const double flat = larger(c * way.x + s * way.y, absolute(way.z) / kSteepest);
  double tangent = tangent_low_;
  if (tangent_high_ > tangent_low_ && flat > 0.0) tangent = clamp(way.z / flat, tangent_low_, tangent_high_);
  const double cosine = 1.0 / square_root(1.0 + tangent * tangent);
  const double sine = tangent * cosine;
  return {eye, {cosine * c, cosine * s, sine}, {s, -c, 0.0}, {sine * c, sine * s, -cosine}};
}

bool Optics::in_view(const SensorPose& pose, const Vec3& centre) const noexcept {
  const Vec3 way = centre - pose.eye;
  const double grown = pose_margin_ + angle_margin_ * length(way);
  return is_scanner_ ? in_ring(pose, way, grown) : in_pyramid(pose, way, grown);
}

bool Optics::in_pyramid(const SensorPose& pose, const Vec3& way, double grown) const noexcept {
  const double depth = dot(way, pose.ahead);
  const double reach = cell_ * half_extent(pose.ahead) + grown;
  const double nearest = depth - reach;
  if (nearest < sensor_.nearest || depth + reach + margin_ + margin_square_ * depth * depth > range_) return false;
  return absolute(dot(way, pose.right)) + cell_ * half_extent(pose.right) + grown <= tangent_right_ * nearest &&
         absolute(dot(way, pose.down)) + cell_ * half_extent(pose.down) + grown <= tangent_down_ * nearest;
}

/// A scanner's axis is level or nearly so: its pitch tilts what it sees ahead.
bool Optics::in_ring(const SensorPose& pose, const Vec3& way, double grown) const noexcept {
  const double reach = cell_ * kHalfDiagonal + grown;
  const double far = length(way);
  if (far - reach < sensor_.nearest || far + reach + margin_ + margin_square_ * far * far > range_) return false;
  const double down = dot(way, pose.down);
  const double level = square_root(larger(0.0, far * far - down * down));
  // The part of the cube that is nearest to the bottom of the view, and to its top.
  const double low = tangent_bottom_ < 0.0 ? level - reach : level + reach;
  const double high = tangent_top_ > 0.0 ? level - reach : level + reach;
  if (-down - reach < tangent_bottom_ * low || -down + reach > tangent_top_ * high) return false;
  return sensor_.horizontal >= 2.0 * kPi - 1e-3 || dot(way, pose.ahead) - reach >= cosine_side_ * level;
}

bool Optics::in_wide_sight(const RollingMap& map, const SensorPose& pose, const Vec3& centre, double narrower,
                           Work& work) const noexcept {
  if (!in_sight(map, pose.eye, centre, work)) return false;
  const Vec3 way = centre - pose.eye;
  const double distant = length(way);
  if (!(distant > 0.0)) return true;
  SensorPose axes = pose;
  if (is_scanner_) axes = facing(pose.eye, (1.0 / distant) * way);
  const double grown = pose_margin_ + angle_margin_ * distant;
  const double depth = dot(way, axes.ahead);
  const double half = cell_ * half_extent(axes.ahead) + grown;
  const double near = larger(depth - half, kLeastDepth * depth);
  const double far = depth + half + margin_ + margin_square_ * depth * depth;
  const double wider = grown - narrower * cell_;
  const double side = larger(0.0, cell_ * half_extent(axes.right) + wider);
  const double height = larger(0.0, cell_ * half_extent(axes.down) + wider);
  const Range across = outline(dot(way, axes.right), side, near, depth + half);
  const Range down = outline(dot(way, axes.down), height, near, depth + half);
  for (int corner = 0; corner < 4; ++corner) {
    const double x = corner % 2 == 0 ? across.least : across.most;
    const double y = corner / 2 == 0 ? down.least : down.most;
    const Vec3 slope = axes.ahead + x * axes.right + y * axes.down;
    if (!line_is_free(map, pose.eye, pose.eye + depth * slope, (far - depth) * length(slope), work)) return false;
  }
  return true;
}

bool Optics::in_sight(const RollingMap& map, const Vec3& eye, const Vec3& centre, Work& work) const noexcept {
  const double far = distance(eye, centre);
  return line_is_free(map, eye, centre, kHalfDiagonal * cell_ + margin_ + margin_square_ * far * far, work);
}

bool Optics::in_short_sight(const RollingMap& map, const Vec3& eye, const Vec3& centre, Work& work) noexcept {
  return line_is_free(map, eye, centre, 0.0, work);
}

}  // namespace tern
