// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/clear_ends.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "host/flight/full_knowledge.hpp"
#include "host/number.hpp"

namespace tern_host {
namespace {

using tern::Box;
using tern::Vec3;

constexpr double kTouch = 1e-9;       // metres: voxels that only touch something hold nothing of it
constexpr double kFenceError = 1e-3;  // metres, of the distance from a fence, which is found step by step

struct Near {
  std::string what;
  Vec3 at{};  ///< its nearest point
  double distance = std::numeric_limits<double>::infinity();
  double of_voxels = std::numeric_limits<double>::infinity();  ///< of the nearest voxel that holds a part of it
};

double apart(const Vec3& a, const Vec3& b) {
  return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

Vec3 nearest_in(const Box& b, const Vec3& p) {
  return {std::clamp(p.x, b.lower.x, b.upper.x), std::clamp(p.y, b.lower.y, b.upper.y),
          std::clamp(p.z, b.lower.z, b.upper.z)};
}

Vec3 nearest_in(const Cylinder& c, const Vec3& p) {
  const double off = std::hypot(p.x - c.x, p.y - c.y);
  const double scale = off > c.radius ? c.radius / off : 1.0;
  return {c.x + scale * (p.x - c.x), c.y + scale * (p.y - c.y), std::clamp(p.z, c.bottom, c.top)};
}

/// What is nearest to one point, as the map's voxels show it.
class NearestThing {
 public:
  NearestThing(const FlightWorld& world, const Vec3& origin, const Vec3& point)
      : origin_(origin), cell_(world.settings.cell), most_(radius_of(world.settings)), point_(point) {
    look_at_walls(world.boundary);
    for (const Box& block : world.blocks) look_at(block);
    for (const Cylinder& cylinder : world.cylinders) look_at(cylinder);
  }
  const Near& found() const { return found_; }

 private:
  void take(const Near& near) {
    const bool nearer =
        near.of_voxels < found_.of_voxels || (!(near.of_voxels > found_.of_voxels) && near.distance < found_.distance);
    if (nearer) found_ = near;
  }
  /// The faces of the voxels that hold a part of an interval.
  double low_face(double lower, double origin) const {
    return origin + cell_ * std::floor((lower + kTouch - origin) / cell_);
  }
  double high_face(double upper, double origin) const {
    return origin + cell_ * std::ceil((upper - kTouch - origin) / cell_);
  }
  double voxels_apart(double at, double lower, double upper, double origin) const {
    return std::max({0.0, low_face(lower, origin) - at, at - high_face(upper, origin)});
  }

  void look_at_walls(const Box& b) {
    const Vec3& p = point_;
    const Vec3& o = origin_;
    const auto lower = [&](const char* what, const Vec3& at, double p_at, double face, double from) {
      take({what, at, p_at - face, p_at - high_face(face, from)});
    };
    const auto upper = [&](const char* what, const Vec3& at, double p_at, double face, double from) {
      take({what, at, face - p_at, low_face(face, from) - p_at});
    };
    lower("the ground, the boundary's lower face,", {p.x, p.y, b.lower.z}, p.z, b.lower.z, o.z);
    upper("the ceiling, the boundary's upper face,", {p.x, p.y, b.upper.z}, p.z, b.upper.z, o.z);
    lower("a wall, the boundary's lower face along x,", {b.lower.x, p.y, p.z}, p.x, b.lower.x, o.x);
    upper("a wall, the boundary's upper face along x,", {b.upper.x, p.y, p.z}, p.x, b.upper.x, o.x);
    lower("a wall, the boundary's lower face along y,", {p.x, b.lower.y, p.z}, p.y, b.lower.y, o.y);
    upper("a wall, the boundary's upper face along y,", {p.x, b.upper.y, p.z}, p.y, b.upper.y, o.y);
  }

  void look_at(const Box& b) {
    const double x = voxels_apart(point_.x, b.lower.x, b.upper.x, origin_.x);
    const double y = voxels_apart(point_.y, b.lower.y, b.upper.y, origin_.y);
    const double z = voxels_apart(point_.z, b.lower.z, b.upper.z, origin_.z);
    const Vec3 at = nearest_in(b, point_);
    take({"a block", at, apart(at, point_), std::hypot(x, y, z)});
  }

  /// Columns of voxels no farther than matters, one after the other.
  void look_at(const Cylinder& c) {
    const Vec3 at = nearest_in(c, point_);
    Near near{"a cylinder", at, apart(at, point_), apart(at, point_)};
    if (near.distance > most_ + 2.0 * cell_) return;
    const double z = voxels_apart(point_.z, c.bottom, c.top, origin_.z);
    const double end_y = std::min(point_.y + most_, c.y + c.radius);
    const double end_x = std::min(point_.x + most_, c.x + c.radius);
    for (double y = low_face(std::max(point_.y - most_, c.y - c.radius), origin_.y); y < end_y; y += cell_) {
      for (double x = low_face(std::max(point_.x - most_, c.x - c.radius), origin_.x); x < end_x; x += cell_) {
        const double off_x = std::clamp(c.x, x, x + cell_) - c.x;
        const double off_y = std::clamp(c.y, y, y + cell_) - c.y;
        if (std::hypot(off_x, off_y) > c.radius - kTouch) continue;
        const double to_x = std::clamp(point_.x, x, x + cell_) - point_.x;
        const double to_y = std::clamp(point_.y, y, y + cell_) - point_.y;
        near.of_voxels = std::min(near.of_voxels, std::hypot(to_x, to_y, z));
      }
    }
    take(near);
  }

  Vec3 origin_;
  double cell_;
  double most_;
  Vec3 point_;
  Near found_;
};

std::string needed_text(const FlightSettings& s) {
  return fixed(radius_of(s), 2) + " m away: body_radius " + brief(s.body_radius) + ", tracking_margin " +
         brief(s.tracking_margin) + ", pose_margin " + brief(s.pose_margin);
}

std::string place_text(const Vec3& at) {
  return fixed(at.x, 2) + " " + fixed(at.y, 2) + " " + fixed(at.z, 2);
}

bool is_below(const Vec3& at, const Vec3& point) {
  return at.z < point.z && std::hypot(at.x - point.x, at.y - point.y) < kTouch;
}

/// One point of the flight, and how far from it the flight may be instead.
struct End {
  const char* name;
  const Vec3& position;
  double tolerance;
  Place place;
};

class EndsOfFlight {
 public:
  EndsOfFlight(const FlightWorld& world, const Vec3& origin) : world_(world), origin_(origin) {}

  void check(const End& end) const {
    check_boundary(end);
    check_things(end);
    check_fences(end);
  }

 private:
  [[noreturn]] static void refuse(const End& end, const std::string& why) {
    throw RecordError(end.place, std::string("the flight cannot be at its ") + end.name + ": " + why);
  }

  void check_boundary(const End& end) const {
    const Vec3& p = end.position;
    const Box& b = world_.boundary;
    if (apart(nearest_in(b, p), p) <= end.tolerance) return;
    refuse(end, place_text(p) + " is outside the boundary, " + place_text(b.lower) + " to " + place_text(b.upper));
  }

  void check_things(const End& end) const {
    const Near near = NearestThing(world_, origin_, end.position).found();
    const double needed = radius_of(world_.settings) - end.tolerance - kTouch;
    if (!(near.of_voxels < needed)) return;
    std::string why =
        near.what + " is " + fixed(std::max(0.0, near.distance), 2) + " m away, at " + place_text(near.at);
    if (!(near.distance < needed)) {
      why += ", and the voxels of " + brief(world_.settings.cell) + " m that hold a part of it " +
             fixed(std::max(0.0, near.of_voxels), 2) + " m";
    }
    why += ". All of it must be " + needed_text(world_.settings);
    if (is_below(near.at, end.position)) {
      why += std::string(". ") +
             (std::string(end.name) == "start" ? "A vehicle on the ground needs the record column"
                                               : "To land, give the record land") +
             "; else stay at least so far above the ground (docs/formats.md)";
    }
    refuse(end, why);
  }

  void check_fences(const End& end) const {
    for (const FenceRecord& fence : world_.fences) {
      if (tern::is_timed(fence.fence)) continue;  // it ends
      const bool keeps_out = fence.fence.kind == tern::FenceKind::kKeepOut;
      const double gap = fence_gap(fence, end.position);
      const double needed = keeps_out ? radius_of(world_.settings) : 0.0;
      if (gap >= needed - end.tolerance - kFenceError) continue;
      const std::string of = "'" + fence.key + "' of line " + std::to_string(fence.place.line) +
                             (fence.zone.empty() ? "" : " (" + fence.zone + ")");
      if (!keeps_out) refuse(end, "it is " + fixed(-gap, 2) + " m outside of the " + of);
      const std::string where = gap > 0.0 ? fixed(gap, 2) + " m from the " : "in the ";
      refuse(end, "it is " + where + of + ", which must be " + needed_text(world_.settings));
    }
  }

  const FlightWorld& world_;
  Vec3 origin_;
};

}  // namespace

void refuse_occupied_ends(const FlightWorld& world, const Vec3& origin) {
  const EndsOfFlight ends(world, origin);
  if (!(world.column.radius > 0.0)) ends.check({"start", world.start, 0.0, world.places.start});
  const bool must_pass = world.via_policy == tern::ViaPolicy::kEnd;
  for (std::size_t i = 0; must_pass && i < world.vias.size(); ++i) {
    const Place place = i < world.places.vias.size() ? world.places.vias[i] : Place{};
    ends.check({"via", world.vias[i].position, world.vias[i].tolerance, place});
  }
  const bool lands = world.landing.speed > 0.0;
  if (world.settings.goal_place == "given" && !lands) ends.check({"goal", world.goal, 0.0, world.places.goal});
}

}  // namespace tern_host
