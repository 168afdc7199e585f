// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/intent/path_parts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace tern_host {
namespace {

constexpr std::size_t kMostPieces = 4096;
/// A piece is at most this part of the limits, so that parts can end near the best places.
constexpr double kFraction = 0.125;

using tern::Vec3;

/// The middle and the size of some control points.
class Extent {
 public:
  void add(const PathPiece& piece) {
    for (const Vec3& p : piece.points) {
      lower_ = {std::min(lower_.x, p.x), std::min(lower_.y, p.y), std::min(lower_.z, p.z)};
      upper_ = {std::max(upper_.x, p.x), std::max(upper_.y, p.y), std::max(upper_.z, p.z)};
    }
  }
  double rise() const { return upper_.z - lower_.z; }
  double across() const { return std::max(upper_.x - lower_.x, upper_.y - lower_.y); }

 private:
  static constexpr double kMost = std::numeric_limits<double>::infinity();
  Vec3 lower_{kMost, kMost, kMost};
  Vec3 upper_{-kMost, -kMost, -kMost};
};

/// The distance in plan of a point from the chord from a to b.
double off_chord(const Vec3& a, const Vec3& b, const Vec3& p) {
  const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
  const double along = square > 0.0 ? ((p.x - a.x) * dx + (p.y - a.y) * dy) / square : 0.0;
  const double u = std::clamp(along, 0.0, 1.0);
  return std::hypot(p.x - a.x - u * dx, p.y - a.y - u * dy);
}

PathPiece half(const PathPiece& piece, bool second) {
  const double middle = 0.5 * (piece.begin + piece.end);
  PathPiece out{second ? middle : piece.begin, second ? piece.end : middle, piece.points};
  const std::size_t count = out.points.size();
  if (second) std::reverse(out.points.begin(), out.points.end());
  for (std::size_t level = 1; level < count; ++level) {
    for (std::size_t i = count - 1; i >= level; --i) {
      Vec3& p = out.points[i];
      const Vec3& q = out.points[i - 1];
      p = {0.5 * (p.x + q.x), 0.5 * (p.y + q.y), 0.5 * (p.z + q.z)};
    }
  }
  if (second) std::reverse(out.points.begin(), out.points.end());
  return out;
}

/// One part of a way against the limits.
class Part {
 public:
  Part(const std::vector<PathPiece>& pieces, const PartLimits& limits, std::size_t first)
      : pieces_(pieces), limits_(limits), first_(first) {}

  /// Takes one piece more. False if no part that begins here can be that long.
  bool extend(std::size_t last) {
    last_ = last;
    extent_.add(pieces_[last - 1]);
    if (pieces_[last - 1].end - pieces_[first_].begin > limits_.longest) return false;
    return extent_.rise() <= limits_.rise || extent_.across() <= limits_.column;
  }

  double rise() const { return extent_.rise(); }
  bool is_column() const { return extent_.across() <= limits_.column / std::sqrt(2.0); }

  /// The chord's ends are on the way, so each place of the chord has a place of the way straight across from it. If the
  /// hull is within half the spread of the chord, it is within the spread of the way.
  bool fits() const {
    if (is_column()) return true;
    if (extent_.rise() > limits_.rise) return false;
    const Vec3& a = pieces_[first_].points.front();
    const Vec3& b = pieces_[last_ - 1].points.back();
    for (std::size_t i = first_; i < last_; ++i) {
      for (const Vec3& p : pieces_[i].points) {
        if (2.0 * off_chord(a, b, p) > limits_.spread) return false;
      }
    }
    return true;
  }

 private:
  const std::vector<PathPiece>& pieces_;
  const PartLimits& limits_;
  std::size_t first_;
  std::size_t last_ = 0;
  Extent extent_;
};

/// A piece may rise no more than a fraction in a column either: control points can be above and below all of the way.
bool fits_with_room(const PathPiece& piece, const PartLimits& limits) {
  const PartLimits fraction{kFraction * limits.longest, kFraction * limits.spread, kFraction * limits.column,
                            kFraction * limits.rise};
  const std::vector<PathPiece> one{piece};
  Part part(one, fraction, 0);
  return part.extend(1) && part.fits() && part.rise() <= fraction.rise;
}

}  // namespace

std::vector<PathPiece> halved(const std::vector<PathPiece>& pieces, const PartLimits& limits) {
  std::vector<PathPiece> left(pieces.rbegin(), pieces.rend());
  std::vector<PathPiece> out;
  while (!left.empty()) {
    const PathPiece piece = left.back();
    left.pop_back();
    if (fits_with_room(piece, limits)) {
      out.push_back(piece);
      continue;
    }
    left.push_back(half(piece, true));
    left.push_back(half(piece, false));
    if (out.size() + left.size() > kMostPieces) {
      throw std::invalid_argument("the plan is too long for so small a looseness, or so short a volume: raise them");
    }
  }
  return out;
}

std::vector<PathPart> fewest_parts(const std::vector<PathPiece>& pieces, const PartLimits& limits) {
  struct Best {
    std::size_t parts = std::numeric_limits<std::size_t>::max();
    PathPart last{};
  };
  std::vector<Best> best(pieces.size() + 1);
  best[0].parts = 0;
  for (std::size_t first = 0; first < pieces.size(); ++first) {
    Part part(pieces, limits, first);
    for (std::size_t last = first + 1; last <= pieces.size() && part.extend(last); ++last) {
      if (best[first].parts + 1 < best[last].parts && part.fits()) {
        best[last] = {best[first].parts + 1, {first, last, part.is_column()}};
      }
    }
  }
  std::vector<PathPart> parts;
  for (std::size_t at = pieces.size(); at > 0; at = parts.back().first) parts.push_back(best[at].last);
  std::reverse(parts.begin(), parts.end());
  return parts;
}

}  // namespace tern_host
