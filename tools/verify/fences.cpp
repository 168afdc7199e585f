// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Boundary and fences are proven by directions: a piece of a curve has as much room as any direction proves for all its
// control points. Doubles only guess directions. Curves are halved.
#include "verify/fences.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "verify/fence_records.hpp"
#include "verify/polyhedron.hpp"
#include "verify/proofs.hpp"

namespace tern_verify {
namespace {

/// Halvings after which a piece counts with what is proven of it.
constexpr int kMostCuts = 60;
/// Room that is more than this, metres, is proven to three quarters.
constexpr int kPlenty = 1;
/// Metres more that a keep-out counts beyond the boundary: in a flat boundary, it would have no inside.
constexpr int kSpare = 1;
/// Rounds of alternating projections; where they have not converged, only a guess is worse.
constexpr int kProjections = 100;

/// A correction of the projections below this, metres, is rounding.
constexpr double kNoPush = 1e-12;

/// Over the length of a normal, rounded down.
Rational over_length(const Rational& room, const Point& normal) {
  const Rational square = dot(normal, normal);
  return room / (room < 0 ? root_below(square) : root_above(square));
}

/// Of all points of a hull in a keep-in, metres from below.
Rational room_inside(const Fence& keep_in, const Polygon<3>& hull) {
  std::optional<Rational> least;
  for (const HalfSpace& plane : keep_in.planes) {
    for (const Point& point : hull) {
      const Rational room = over_length(plane.offset - dot(plane.normal, point), plane.normal);
      if (!least || room < *least) least = room;
    }
  }
  return *least;
}

/// Of all points of a hull before a keep-out, metres from below, by a direction along which the keep-out is no less
/// than `least`.
Rational room_along(const Fence& keep_out, const Polygon<3>& hull, const Point& n, const Rational& least) {
  Rational most = dot(n, hull.front());
  for (const Point& point : hull) most = std::max<Rational>(most, dot(n, point));
  return over_length(least - most, n) - keep_out.distance;
}

void raise(std::optional<Rational>& best, const Rational& room) {
  if (!best || room > *best) best = room;
}

/// One fence, and the room that it leaves the hull of some points.
class Room {
 public:
  Room(const Fence& fence, const Box& boundary) : fence_(fence) {
    if (fence.keep_in) return;
    extent_ = Extent(cut_to(boundary, fence.distance + kSpare, fence.planes));
  }

  /// Of all points of the hull, from below. Stops trying once there is more than `enough`.
  Rational of(const Polygon<3>& hull, const std::optional<Rational>& enough) const {
    return fence_.keep_in ? room_inside(fence_, hull) : beyond(hull, enough);
  }

 private:
  Rational beyond(const Polygon<3>& hull, const std::optional<Rational>& enough) const {
    // The keep-out has n . p >= offset for each of its faces, seen from outside.
    const HalfSpace& face = fence_.planes[face_towards(hull)];
    Rational best = room_along(fence_, hull, -1 * face.normal, -face.offset);
    if (enough && best >= *enough) return best;
    const Point direction = towards(hull);
    const std::optional<Rational> least = extent_.least_along(direction);
    if (least && dot(direction, direction) > 0) best = std::max(best, room_along(fence_, hull, direction, *least));
    return best;
  }

  /// The face that seems to leave the hull the most room.
  std::size_t face_towards(const Polygon<3>& hull) const {
    std::vector<double> rooms;
    for (std::size_t f = 0; f < fence_.planes.size(); ++f) {
      const Extent::Plane& face = extent_.planes()[f];
      double room = HUGE_VAL;
      for (const Point& point : hull) room = std::min(room, dot(face.normal, guess(point)) - face.offset);
      rooms.push_back(room);
    }
    return static_cast<std::size_t>(std::max_element(rooms.begin(), rooms.end()) - rooms.begin());
  }

  /// From the middle of the hull to the nearest point of the keep-out, by Dykstra's alternating projections. If that
  /// point is on an edge, the direction is at right angles to it, exactly: a long edge would take room from any other.
  Point towards(const Polygon<3>& hull) const {
    Guess middle{0.0, 0.0, 0.0};
    for (const Point& point : hull) {
      const Guess p = guess(point);
      for (std::size_t a = 0; a < 3; ++a) middle[a] += p[a] / static_cast<double>(hull.size());
    }
    Guess at = middle;
    const std::vector<Extent::Plane>& planes = extent_.planes();
    std::vector<double> pushed(planes.size(), 0.0);
    for (int round = 0; round < kProjections; ++round) {
      for (std::size_t k = 0; k < planes.size(); ++k) {
        const Guess& n = planes[k].normal;
        const double before = pushed[k];
        pushed[k] = std::max(0.0, dot(n, at) - planes[k].offset + before);
        for (std::size_t a = 0; a < 3; ++a) at[a] += (before - pushed[k]) * n[a];
      }
    }
    // Single precision is short to multiply with, and guess enough.
    Point direction;
    for (std::size_t a = 0; a < 3; ++a) direction[a] = static_cast<float>(at[a] - middle[a]);
    return across_edge(direction, pushed);
  }

  /// `pushed`: how far each plane moved the middle. Two planes meet in an edge.
  Point across_edge(const Point& direction, const std::vector<double>& pushed) const {
    std::vector<Point> normals;
    for (std::size_t k = 0; k < pushed.size(); ++k) {
      if (pushed[k] > kNoPush) normals.push_back(extent_.planes()[k].exact.normal);
    }
    if (normals.size() != 2) return direction;
    const Point edge = cross(normals[0], normals[1]);
    return dot(edge, edge) * direction - dot(direction, edge) * edge;
  }

  const Fence& fence_;
  Extent extent_;  // of a keep-out; its own planes come first
};

/// The rooms that a curve may be in: it needs one of them.
using Rooms = std::vector<const Room*>;

class RoomSearch {
 public:
  /// `rooms`: of each curve.
  RoomSearch(const std::vector<Polygon<3>>& curves, const std::vector<Rooms>& rooms) : curves_(curves), rooms_(rooms) {
    for (curve_ = 0; curve_ < curves.size(); ++curve_) {
      reach(curves[curve_].front(), 0);
      reach(curves[curve_].back(), 1);
    }
  }

  FenceRoom run() {
    proven_ = enough();
    for (curve_ = 0; curve_ < curves_.size(); ++curve_) search(curves_[curve_], 0, 1, 0);
    found_.least = std::min<Rational>(proven_, enough());
    return found_;
  }

 private:
  /// What is to be proven of a piece.
  Rational enough() const {
    return found_.most > kPlenty ? Rational(found_.most * 3 / 4) : Rational(found_.most - close_);
  }

  Rational room_of(const Polygon<3>& hull, const std::optional<Rational>& enough) const {
    std::optional<Rational> best;
    for (const Room* room : rooms_[curve_]) raise(best, room->of(hull, enough));
    return *best;
  }

  /// Points with more room than the least known are told by the first direction that proves it.
  void reach(const Point& point, const Rational& u) {
    const Rational room = room_of({point}, begun_ ? std::optional<Rational>(found_.most) : std::nullopt);
    if (begun_ && room >= found_.most) return;
    begun_ = true;
    found_ = {0, room, curve_, u};
  }

  void search(const Polygon<3>& piece, const Rational& u, const Rational& width, int halvings) {
    const Rational wanted = enough();
    const Rational room = room_of(piece, wanted);
    if (room >= wanted) return;
    if (halvings == kMostCuts) {
      proven_ = std::min(proven_, room);
      return;
    }
    const Halves<3> halves = halves_of(piece);
    reach(halves.right.front(), u + width / 2);
    search(halves.left, u, width / 2, halvings + 1);
    search(halves.right, u + width / 2, width / 2, halvings + 1);
  }

  const std::vector<Polygon<3>>& curves_;
  const std::vector<Rooms>& rooms_;
  const Rational close_ = decimal(1, 10);
  FenceRoom found_{};
  Rational proven_ = 0;
  std::size_t curve_ = 0;
  bool begun_ = false;
};

Claim room_claim(const Subject& subject, const std::string& what, const Fence& fence, const Rational& tolerance) {
  const FenceRoom room = fence_room(subject.curves(), fence, subject.problem.boundary);
  return {what, "m", room.least, room.most, tolerance, place_of(subject.plan.segments, room.curve, room.u)};
}

}  // namespace

FenceRoom fence_room(const std::vector<Polygon<3>>& curves, const Fence& fence, const Box& boundary) {
  const Room room(fence, boundary);
  return RoomSearch(curves, std::vector<Rooms>(curves.size(), {&room})).run();
}

FenceRoom fence_room(const std::vector<Polygon<3>>& curves, const std::vector<std::vector<const Fence*>>& fences,
                     const Box& boundary) {
  std::map<const Fence*, Room> known;
  std::vector<Rooms> rooms;
  for (const std::vector<const Fence*>& of_curve : fences) {
    rooms.emplace_back();
    for (const Fence* fence : of_curve)
      rooms.back().push_back(&known.try_emplace(fence, *fence, boundary).first->second);
  }
  return RoomSearch(curves, rooms).run();
}

void prove_boundary(const Subject& subject, Claims& claims) {
  Fence boundary{};
  boundary.keep_in = true;
  boundary.planes = cut_to(subject.problem.boundary, 0, {});
  claims.push_back(room_claim(subject, "boundary", boundary, subject.tolerance.point));
}

void prove_fences(const Subject& subject, Claims& claims) {
  const Tolerance& tolerance = subject.tolerance;
  for (std::size_t f = 0; f < subject.problem.fences.size(); ++f) {
    const Fence& fence = subject.problem.fences[f];
    if (fence.window) continue;
    const Rational granted = fence.keep_in ? tolerance.fence : Rational(tolerance.fence + tolerance.point);
    claims.push_back(room_claim(subject, title_of(subject.problem.fences, f), fence, granted));
  }
}

}  // namespace tern_verify
