// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "world/hull_gap.hpp"

#include "base/math.hpp"

namespace tern {
namespace {

/// kSettled: the iteration ends if the gap cannot grow by more than this share of the distance. kMeeting: below this
/// distance, in metres, a direction is only rounding error.
constexpr double kSettled = 1e-12;
constexpr double kMeeting = 1e-10;

/// Up to four differences of points of the two hulls.
struct Simplex {
  Vec3 points[4];
  int count;
};

/// The face that is nearest to the origin so far, and its nearest point.
struct Nearest {
  Vec3 point;
  double square;  ///< squared distance from the origin; < 0 while there is no face
  Simplex face;
};

void offer(Nearest& best, const Vec3& point, const Simplex& face) {
  const double square = dot(point, point);
  if (best.square >= 0.0 && square >= best.square) return;
  best = {point, square, face};
}

void offer_edge(Nearest& best, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double square = dot(along, along);
  if (!(square > 0.0)) return;
  const double t = -dot(a, along) / square;
  if (t > 0.0 && t < 1.0) offer(best, a + t * along, {{a, b, b, b}, 2});
}

/// Offers the origin's projection onto the triangle's plane if it lies in the triangle.
void offer_triangle(Nearest& best, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = cross(b - a, c - a);
  const double square = dot(normal, normal);
  if (!(square > 0.0)) return;
  const Vec3 foot = (dot(a, normal) / square) * normal;
  const bool inside = dot(cross(b - a, foot - a), normal) >= 0.0 && dot(cross(c - b, foot - b), normal) >= 0.0 &&
                      dot(cross(a - c, foot - c), normal) >= 0.0;
  if (inside) offer(best, foot, {{a, b, c, c}, 3});
}

/// True if the tetrahedron contains the origin: for each face, the origin is on the side of the fourth corner.
bool holds_origin(const Simplex& s) {
  if (s.count < 4) return false;
  for (int k = 0; k < 4; ++k) {
    const Vec3& a = s.points[(k + 1) % 4];
    const Vec3 normal = cross(s.points[(k + 2) % 4] - a, s.points[(k + 3) % 4] - a);
    const double corner = dot(s.points[k] - a, normal);
    const double origin = -dot(a, normal);
    if (!(corner * origin > 0.0)) return false;
  }
  return true;
}

/// The face of the simplex that is nearest to the origin, by trying all.
Nearest nearest_face(const Simplex& s) {
  Nearest best{{0.0, 0.0, 0.0}, -1.0, s};
  for (int i = 0; i < s.count; ++i) {
    const Vec3& a = s.points[i];
    offer(best, a, {{a, a, a, a}, 1});
    for (int j = i + 1; j < s.count; ++j) {
      offer_edge(best, a, s.points[j]);
      for (int k = j + 1; k < s.count; ++k) offer_triangle(best, a, s.points[j], s.points[k]);
    }
  }
  return best;
}

const Vec3& lowest(const Vec3& normal, const Hull& hull) {
  int best = 0;
  for (int k = 1; k < hull.count; ++k) {
    if (dot(normal, hull.points[k]) < dot(normal, hull.points[best])) best = k;
  }
  return hull.points[best];
}

const Vec3& highest(const Vec3& normal, const Hull& hull) {
  int best = 0;
  for (int k = 1; k < hull.count; ++k) {
    if (dot(normal, hull.points[best]) < dot(normal, hull.points[k])) best = k;
  }
  return hull.points[best];
}

}  // namespace

bool has_normal(const HullGap& gap) noexcept {
  return dot(gap.normal, gap.normal) > 0.5;
}

double hull_support(const Vec3& normal, const Hull& hull) noexcept {
  return dot(normal, lowest(normal, hull));
}

double hull_reach(const Vec3& normal, const Hull& hull) noexcept {
  return dot(normal, highest(normal, hull));
}

HullGap segment_hull_gap(const Vec3& from, const Vec3& to, const Hull& hull) noexcept {
  const Vec3 ends[2] = {from, to};
  return hull_gap({ends, 2}, hull);
}

HullGap hull_gap(const Hull& first, const Hull& second) noexcept {
  HullGap gap{{0.0, 0.0, 0.0}, 0.0};
  Vec3 toward = second.points[0] - first.points[0];
  Simplex simplex{{toward, toward, toward, toward}, 1};
  for (int step = 0; step < kGapSteps; ++step) {
    const double norm = length(toward);
    if (norm < kMeeting) return gap;
    const Vec3 normal = (1.0 / norm) * toward;
    const Vec3 difference = lowest(normal, second) - highest(normal, first);
    const double distance = dot(normal, difference);
    if (distance > gap.distance) gap = {normal, distance};
    if (norm - gap.distance <= kSettled * norm) return gap;
    simplex.points[simplex.count++] = difference;
    if (holds_origin(simplex)) return gap;
    const Nearest nearest = nearest_face(simplex);
    // Ends once rounding keeps the steps from coming nearer.
    if (nearest.face.count == 4 || nearest.square >= norm * norm) return gap;
    toward = nearest.point;
    simplex = nearest.face;
  }
  return gap;
}

HullGap widest_gap(const Vec3& from, const Vec3& to, const Hull& hull, const Halfspace* faces, int face_count,
                   double enough) noexcept {
  HullGap best = segment_hull_gap(from, to, hull);
  if (has_normal(best) && best.distance >= enough) return best;
  const HullGap backwards = segment_hull_gap(to, from, hull);
  if (backwards.distance > best.distance) best = backwards;
  for (int f = 0; f < face_count; ++f) {
    const Vec3 unit = -1.0 * faces[f].normal;
    const double room = hull_support(unit, hull) - larger(dot(unit, from), dot(unit, to));
    if (has_normal(best) && room <= best.distance) continue;
    best = {unit, room};
  }
  return best;
}

}  // namespace tern
