// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The plan's own certificate: control points in half-spaces, and half-spaces between the curve and what is solid.
#include "verify/proofs.hpp"

namespace tern_verify {
namespace {

/// A half-space with bounds on the length of its normal.
struct Cut {
  const HalfSpace* plane;
  Rational shortest, longest;

  explicit Cut(const HalfSpace& half_space)
      : plane(&half_space),
        shortest(root_below(dot(half_space.normal, half_space.normal))),
        longest(root_above(dot(half_space.normal, half_space.normal))) {}

  /// Metres, from below, of a difference along the normal.
  Rational metres(const Rational& along) const { return along / (along < 0 ? shortest : longest); }

  /// The corner of the box that is the least distance beyond the half-space, and that distance.
  Rational beyond(const Box& box) const {
    Rational along = -plane->offset;
    for (std::size_t a = 0; a < 3; ++a) {
      along += plane->normal[a] * (plane->normal[a] < 0 ? box.upper[a] : box.lower[a]);
    }
    return metres(along);
  }

  Rational inside(const Point& point) const { return metres(plane->offset - dot(plane->normal, point)); }
};

std::vector<Cut> cuts_of(const std::vector<HalfSpace>& planes) {
  return std::vector<Cut>(planes.begin(), planes.end());
}

/// Proves the solid voxels beyond the half-spaces of one polyhedron.
class Separation {
 public:
  Separation(const Subject& subject, std::size_t polyhedron, Tightest& tightest)
      : subject_(subject),
        polyhedron_(polyhedron),
        cuts_(cuts_of(subject.plan.corridor[polyhedron])),
        tightest_(tightest) {}

  /// The voxels together, or if no half-space separates them, both halves, down to single voxels.
  void prove(const Cells& cells) {
    const Rational margin = best_margin(box_of(subject_.lattice, cells));
    const bool separated = margin >= -subject_.tolerance.half_space;
    std::size_t longest = 0;
    for (std::size_t a = 1; a < 3; ++a) {
      if (length(cells, a) > length(cells, longest)) longest = a;
    }
    if (separated || length(cells, longest) == 1) return note(margin, cells);
    Cells half = cells;
    half.end[longest] = cells.begin[longest] + length(cells, longest) / 2;
    prove(half);
    half.begin[longest] = half.end[longest];
    half.end[longest] = cells.end[longest];
    prove(half);
  }

 private:
  static long length(const Cells& cells, std::size_t a) { return cells.end[a] - cells.begin[a]; }

  /// Of the half-space that separates them best; any that leaves more room than the least so far will do.
  Rational best_margin(const Box& box) {
    Rational best = cuts_.empty() ? Rational(-subject_.problem.clearance - 1) : margin_of(last_, box);
    for (std::size_t c = 0; c < cuts_.size() && !is_enough(best); ++c) {
      const Rational margin = margin_of(c, box);
      if (margin <= best) continue;
      best = margin;
      last_ = c;
    }
    return best;
  }

  Rational margin_of(std::size_t cut, const Box& box) const {
    return cuts_[cut].beyond(box) - subject_.problem.clearance;
  }

  bool is_enough(const Rational& margin) const {
    return margin >= 0 && tightest_.is_above(margin, subject_.tolerance.half_space);
  }

  void note(const Rational& margin, const Cells& cells) {
    tightest_.note(margin, subject_.tolerance.half_space, [&] {
      return "polyhedron " + std::to_string(polyhedron_) + ", voxel (" + std::to_string(cells.begin[0]) + ", " +
             std::to_string(cells.begin[1]) + ", " + std::to_string(cells.begin[2]) + ")";
    });
  }

  const Subject& subject_;
  std::size_t polyhedron_;
  std::vector<Cut> cuts_;
  Tightest& tightest_;
  std::size_t last_ = 0;  ///< the half-space that separated the voxels before: neighbours are often alike
};

std::string point_place(std::size_t segment, std::size_t point) {
  return "segment " + std::to_string(segment) + ", control point " + std::to_string(point);
}

/// How far a point is inside a box, at least.
Rational depth_in(const Box& box, const Point& point) {
  Rational depth = point[0] - box.lower[0];
  for (std::size_t a = 0; a < 3; ++a) {
    depth = std::min<Rational>(depth, point[a] - box.lower[a]);
    depth = std::min<Rational>(depth, box.upper[a] - point[a]);
  }
  return depth;
}

}  // namespace

void prove_inside(const Subject& subject, Claims& claims) {
  Tightest boundary("boundary", "m");
  Tightest corridor("inside the corridor", "m");
  for (std::size_t s = 0; s < subject.plan.segments.size(); ++s) {
    const std::vector<Cut> cuts = cuts_of(subject.plan.corridor[subject.plan.segments[s].polyhedron]);
    const Polygon<3> points = subject.world_points(s);
    for (std::size_t p = 0; p < points.size(); ++p) {
      const auto place = [&] { return point_place(s, p); };
      boundary.note(depth_in(subject.problem.boundary, points[p]), subject.tolerance.point, place);
      for (const Cut& cut : cuts) corridor.note(cut.inside(points[p]), subject.tolerance.point, place);
    }
  }
  claims.push_back(boundary.claim());
  if (corridor.noted()) claims.push_back(corridor.claim());
}

void prove_corridor(const Subject& subject, Claims& claims) {
  Tightest tightest("corridor off obstacles", "m");
  std::vector<bool> used(subject.plan.corridor.size(), false);
  for (const Segment& segment : subject.plan.segments) used[segment.polyhedron] = true;
  for (std::size_t polyhedron = 0; polyhedron < used.size(); ++polyhedron) {
    if (!used[polyhedron]) continue;
    Separation separation(subject, polyhedron, tightest);
    for (const Cells& cells : subject.solid) separation.prove(cells);
  }
  if (tightest.noted()) claims.push_back(tightest.claim());
}

}  // namespace tern_verify
