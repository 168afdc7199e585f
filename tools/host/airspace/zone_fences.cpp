// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/airspace/zone_fences.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "host/airspace/convex_plan.hpp"
#include "host/airspace/planned_ring.hpp"
#include "host/number.hpp"

namespace tern_host {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// What rounding of corners, cuts and half-spaces amounts to at most, metres.
constexpr double kGuard = 4e-6;
/// Outlines are followed up to so far around the boundary, metres; slack must be less.
constexpr double kAround = 1000.0, kMostSlack = 900.0;

/// Fits one zone: its outlines in plan first, then pieces of them, then half-spaces.
class ZoneFit {
 public:
  ZoneFit(const Zone& zone, const ZoneHeights& heights, const FitSettings& settings)
      : zone_(zone), heights_(heights), settings_(settings), keeps_in_(zone.kind == ZoneKind::kKeepIn) {
    const tern::Box& b = settings.boundary;
    const double by = settings.clearance;
    box_ = {{b.lower.x - by, b.lower.y - by}, {b.upper.x + by, b.upper.y + by}};
    window_.reach = kAround + std::max({-box_.lower.east, -box_.lower.north, box_.upper.east, box_.upper.north});
  }

  FittedZone run() {
    out_.notes = zone_.notes;
    turns_.assign(zone_.areas.size(), 0);
    for (std::size_t i = 0; i < zone_.areas.size(); ++i) add_area(zone_.areas[i], i);
    by_ = slack_ + kGuard;
    const Filled filled = [this](const std::vector<int>& windings) { return holds(windings); };
    const std::vector<ConvexPiece> pieces = convex_pieces(outlines_, 2 * zone_.areas.size(), filled);
    if (ambiguous_) {
      out_.notes.push_back(keeps_in_ ? "its outline crosses itself: by the even-odd rule"
                                     : "its outline crosses itself: all that it goes around is closed");
    }
    for (const ConvexPiece& piece : pieces) out_.area += piece.area;
    out_.flat = pieces.empty() && has_corner_within();
    if (keeps_in_) {
      keep_in(pieces);
    } else {
      keep_out(pieces);
    }
    return std::move(out_);
  }

 private:
  void add_area(const ZoneArea& area, std::size_t index) {
    const double tolerance = 0.25 * settings_.looseness;
    if (area.radius > 0.0) {
      double off = 0.0;
      add_outline(
          planned_circle(heights_.frame(), area.centre, area.radius, keeps_in_, settings_.looseness, window_, off),
          2 * index);
      shape_off_ = std::max(shape_off_, off);
      return;
    }
    add_outline(planned_ring(heights_.frame(), area.ring, zone_.edges, tolerance, window_), 2 * index);
    for (const std::vector<GeoPoint>& hole : area.holes) {
      add_outline(planned_ring(heights_.frame(), hole, zone_.edges, tolerance, window_), 2 * index + 1);
    }
  }

  void add_outline(PlannedRing ring, std::size_t layer) {
    if (ring.slack > kMostSlack) {
      throw std::invalid_argument("its edges are so long that their course is " + brief(std::ceil(ring.slack)) +
                                  " m uncertain: add corners to them");
    }
    slack_ = std::max(slack_, ring.slack);
    if (!ring.corners.empty()) outlines_.push_back({std::move(ring.corners), layer});
  }

  /// Of the outlines, not of where they were cut off.
  bool has_corner_within() const {
    const double reach = window_.reach / kStep - 1.0;
    return std::any_of(outlines_.begin(), outlines_.end(), [reach](const Outline& outline) {
      return std::any_of(outline.corners.begin(), outline.corners.end(), [reach](const Corner& c) {
        return std::fabs(static_cast<double>(c.x)) < reach && std::fabs(static_cast<double>(c.y)) < reach;
      });
    });
  }

  /// On the safe side where an outline goes around a place more than once, or both ways.
  bool holds(const std::vector<int>& windings) {
    bool in_any = false;
    for (std::size_t i = 0; i < windings.size(); i += 2) {
      const int ring = windings[i], hole = windings[i + 1];
      // Both ways round, in different places, is a bow tie.
      turns_[i / 2] |= (ring > 0 ? 1 : 0) | (ring < 0 ? 2 : 0);
      ambiguous_ = ambiguous_ || std::abs(ring) > 1 || std::abs(hole) > 1 || turns_[i / 2] == 3;
      const bool in = keeps_in_ ? ring % 2 != 0 && hole == 0 : ring != 0 && hole % 2 == 0;
      in_any = in_any || in;
    }
    return in_any;
  }

  /// Bottom and top: the widest for a keep-out, the narrowest for a keep-in.
  bool find_heights(const ConvexPiece& piece) {
    bottom_ = -kInfinity;
    top_ = kInfinity;
    PlanBox where{{kInfinity, kInfinity}, {-kInfinity, -kInfinity}};
    for (const ConvexPiece::Vertex& v : piece.vertices) {
      where.lower = {std::min(where.lower.east, v.x - 2.0 * by_), std::min(where.lower.north, v.y - 2.0 * by_)};
      where.upper = {std::max(where.upper.east, v.x + 2.0 * by_), std::max(where.upper.north, v.y + 2.0 * by_)};
    }
    where.lower = {std::max(where.lower.east, box_.lower.east), std::max(where.lower.north, box_.lower.north)};
    where.upper = {std::min(where.upper.east, box_.upper.east), std::min(where.upper.north, box_.upper.north)};
    const bool from_ground =
        zone_.lower && zone_.lower->reference == HeightReference::kGround && zone_.lower->metres <= 0.0;
    if (zone_.lower && !from_ground) {
      const HeightRange range = heights_.local(*zone_.lower, where);
      bottom_ = keeps_in_ ? range.high : range.low;
      out_.height_off = std::max(out_.height_off, range.high - range.low);
    }
    if (zone_.upper) {
      const HeightRange range = heights_.local(*zone_.upper, where);
      top_ = keeps_in_ ? range.low : range.high;
      out_.height_off = std::max(out_.height_off, range.high - range.low);
    }
    if (top_ < bottom_) throw std::invalid_argument("its upper height is below its lower");
    const double by = settings_.clearance;
    return bottom_ <= settings_.boundary.upper.z + by && top_ >= settings_.boundary.lower.z - by;
  }

  void add_fence(tern::FenceKind kind, const ConvexPiece& piece, double by, double bottom, double top) {
    FittedFence fence{kind, upright_planes(piece, by, box_), piece.vertices, bottom, top};
    const double beyond_top = settings_.boundary.upper.z + settings_.clearance;
    const double beyond_bottom = settings_.boundary.lower.z - settings_.clearance;
    if (top < beyond_top) fence.planes.push_back({{0.0, 0.0, 1.0}, top});
    if (bottom > beyond_bottom) fence.planes.push_back({{0.0, 0.0, -1.0}, -bottom});
    if (fence.planes.empty() && kind == tern::FenceKind::kKeepIn) return;
    if (fence.planes.empty()) {
      fence.planes.push_back({{0.0, 0.0, 1.0}, beyond_top});
      out_.notes.push_back("it covers all of the boundary");
    }
    out_.fences.push_back(std::move(fence));
  }

  void add_keep_out(const ConvexPiece& piece, double by) {
    if (!reaches(piece, box_, 2.0 * by)) return;
    if (find_heights(piece)) return add_fence(tern::FenceKind::kKeepOut, piece, by, bottom_, top_);
    out_.above = true;
  }

  std::vector<Corner> hull() const {
    std::vector<Corner> corners;
    for (const Outline& outline : outlines_) {
      if (outline.layer % 2 == 0) corners.insert(corners.end(), outline.corners.begin(), outline.corners.end());
    }
    return hull_of(std::move(corners));
  }

  /// What the hull has and the zone has not.
  std::vector<ConvexPiece> pockets(const std::vector<Corner>& hull) {
    const std::size_t layers = 2 * zone_.areas.size();
    std::vector<Outline> all = outlines_;
    all.push_back({hull, layers, true});
    return convex_pieces(all, layers + 1, [this, layers](const std::vector<int>& windings) {
      return windings[layers] != 0 && !holds({windings.begin(), windings.end() - 1});
    });
  }

  void keep_out(const std::vector<ConvexPiece>& pieces) {
    if (pieces.empty()) return;
    out_.off = shape_off_ + 2.0 * by_;
    if (pieces.size() > 1 && zone_.areas.size() == 1) {
      const std::vector<Corner> corners = hull();
      const ConvexPiece whole = piece_of(corners);
      const double most = 0.5 * settings_.looseness;
      const bool may_fit = corners.size() <= kMostSides && !has_corner_deeper(outlines_, most, whole);
      double deepest = may_fit ? 0.0 : kInfinity;
      for (const ConvexPiece& pocket : may_fit ? pockets(corners) : std::vector<ConvexPiece>{}) {
        deepest = std::max(deepest, depth_within(pocket, whole));
      }
      if (deepest <= most) {
        out_.off += deepest;
        return add_keep_out(whole, by_);
      }
    }
    for (const ConvexPiece& piece : pieces) add_keep_out(piece, by_);
  }

  void keep_in(const std::vector<ConvexPiece>& pieces) {
    if (pieces.empty()) throw std::invalid_argument("a keep-in that is nowhere near the boundary leaves no room");
    const std::vector<Corner> corners = hull();
    double lost = 0.0, flat = 0.0;
    const ConvexPiece whole = piece_of(corners);
    std::vector<ConvexPiece> rest;
    for (const ConvexPiece& pocket : pockets(corners)) {
      const double depth = depth_within(pocket, whole);
      if (depth > 0.5 * settings_.looseness) {
        rest.push_back(pocket);
      } else {
        flat = std::max(flat, depth);
      }
    }
    const ConvexPiece inner = piece_of(fewer_corners(corners, kMostSides, lost));
    find_heights(inner);
    add_fence(tern::FenceKind::kKeepIn, inner, -by_ - flat, bottom_, top_);
    if (!zone_.times.empty()) turn_inside_out();
    for (const ConvexPiece& pocket : rest) {
      if (reaches(pocket, box_, 2.0 * by_)) add_fence(tern::FenceKind::kKeepOut, pocket, by_, -kInfinity, kInfinity);
    }
    out_.off = shape_off_ + 2.0 * by_ + flat + lost;
    if (rest.empty()) return;
    out_.notes.push_back("not convex: a convex keep-in and keep-outs of the rest, from which the clearance is kept");
  }

  /// The far sides of a keep-in's half-spaces as keep-outs. A fence that is a keep-in for a while would be a link of a
  /// chain, outside of which a plan may never be.
  void turn_inside_out() {
    const std::vector<FittedFence> within = std::move(out_.fences);
    out_.fences.clear();
    for (const FittedFence& fence : within) {
      for (const tern::Halfspace& side : fence.planes) {
        const tern::Vec3& n = side.normal;
        out_.fences.push_back({tern::FenceKind::kKeepOut,
                               {{{-n.x, -n.y, -n.z}, -side.offset}},
                               beyond_in_box(side),
                               n.z > 0.0 ? side.offset : -kInfinity,
                               n.z < 0.0 ? -side.offset : kInfinity});
      }
    }
    out_.notes.push_back("a keep-in with times: keep-outs of all around it, from which the clearance is kept");
  }

  /// The part of the box in plan that is beyond a half-space: all of it, if the half-space is level.
  std::vector<ConvexPiece::Vertex> beyond_in_box(const tern::Halfspace& side) const {
    const ConvexPiece::Vertex corners[] = {{box_.lower.east, box_.lower.north},
                                           {box_.upper.east, box_.lower.north},
                                           {box_.upper.east, box_.upper.north},
                                           {box_.lower.east, box_.upper.north}};
    if (side.normal.z != 0.0) return {std::begin(corners), std::end(corners)};
    const auto depth = [&side](const ConvexPiece::Vertex& v) {
      return side.normal.x * v.x + side.normal.y * v.y - side.offset;
    };
    std::vector<ConvexPiece::Vertex> part;
    for (int i = 0; i < 4; ++i) {
      const ConvexPiece::Vertex &a = corners[i], &b = corners[(i + 1) % 4];
      const double at_a = depth(a), at_b = depth(b), t = at_a / (at_a - at_b);
      if (at_a >= 0.0) part.push_back(a);
      if ((at_a >= 0.0) != (at_b >= 0.0)) part.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
    }
    return part;
  }

  const Zone& zone_;
  const ZoneHeights& heights_;
  const FitSettings& settings_;
  const bool keeps_in_;
  PlanBox box_{};  // the boundary grown by the clearance
  Window window_{};
  std::vector<Outline> outlines_;
  double slack_ = 0.0;      // of the outlines' edges
  double shape_off_ = 0.0;  // of circles' polygons
  double by_ = 0.0;         // how far sides are moved to the safe side
  double bottom_ = 0.0, top_ = 0.0;
  std::vector<int> turns_;  // of each area's ring: 1 for to the left, 2 for to the right, and their sum
  bool ambiguous_ = false;
  FittedZone out_;
};

}  // namespace

void check_fit(const FitSettings& settings) {
  const tern::Box& b = settings.boundary;
  double farthest = 0.0;
  for (const double x : {b.lower.x, b.upper.x}) {
    for (const double y : {b.lower.y, b.upper.y}) farthest = std::max(farthest, std::hypot(x, y));
  }
  const bool room = b.lower.x < b.upper.x && b.lower.y < b.upper.y && b.lower.z <= b.upper.z;
  if (!room || !std::isfinite(b.lower.z) || !std::isfinite(b.upper.z)) {
    throw std::invalid_argument("the boundary has no room: its lower corner comes first");
  }
  if (!(farthest <= largest_radius())) {
    throw std::invalid_argument("the boundary reaches farther than " + brief(std::floor(largest_radius())) +
                                " m from the origin, where lengths are more than " + brief(kMostLengthError) +
                                " m off: move the origin, or divide the flight");
  }
  if (!(settings.clearance >= 0.0 && settings.clearance <= 100.0)) {
    throw std::invalid_argument("the clearance must be 0 to 100 m");
  }
  if (!(settings.looseness >= 0.001 && settings.looseness <= 100.0)) {
    throw std::invalid_argument("the looseness must be 0.001 to 100 m");
  }
}

FittedZone fit_zone(const Zone& zone, const ZoneHeights& heights, const FitSettings& settings) {
  return ZoneFit(zone, heights, settings).run();
}

}  // namespace tern_host
