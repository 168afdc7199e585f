// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/airspace/convex_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "host/airspace/outline_edges.hpp"

namespace tern_host {
namespace {

/// One side of a piece that grows upwards: its edges from the bottom up, and the level from which each is the side.
struct Chain {
  struct Link {
    const Edge* edge;
    std::size_t from;
  };
  std::vector<Link> links;

  const Edge& last() const { return *links.back().edge; }
};

/// A piece between two levels.
struct Growing {
  Chain left;
  Chain right;
  std::size_t bottom;
  std::size_t top;
};

/// An edge that passes from one level to the next, and where.
struct Passing {
  const Edge* edge;
  Abscissa at_bottom;
  Abscissa at_top;
};

bool coincide(const Passing& a, const Passing& b) {
  return compare(a.at_bottom, b.at_bottom) == 0 && compare(a.at_top, b.at_top) == 0;
}

bool is_left_of(const Passing& a, const Passing& b) {
  const int at_bottom = compare(a.at_bottom, b.at_bottom);
  return at_bottom < 0 || (at_bottom == 0 && compare(a.at_top, b.at_top) < 0);
}

/// From one level to the next, the edges that pass do not cross: the area between two of them is filled or it is not.
/// Filled strips become pieces, or go on with a piece below that stays convex.
class Sweep {
 public:
  Sweep(const Arrangement& arrangement, std::size_t layers, const Filled& filled)
      : arrangement_(arrangement), layers_(layers), filled_(filled) {}

  std::vector<Growing> run() {
    for (std::size_t level = 0; level + 1 < arrangement_.levels.size(); ++level) {
      advance(level);
      below_.swap(open_);
      open_.clear();
      first_below_ = 0;
      line_ = line_of(arrangement_.levels[level]);
      fill(level);
      for (Growing& piece : below_) {
        if (!piece.left.links.empty()) done_.push_back(std::move(piece));
      }
    }
    for (Growing& piece : open_) done_.push_back(std::move(piece));
    return std::move(done_);
  }

 private:
  void advance(std::size_t level) {
    const Level& bottom = arrangement_.levels[level];
    const Level& top = arrangement_.levels[level + 1];
    const auto ended = [&bottom](const Passing& p) { return !(bottom < Level{Wide(p.edge->high.y), Wide(1)}); };
    passing_.erase(std::remove_if(passing_.begin(), passing_.end(), ended), passing_.end());
    for (; next_ < arrangement_.edges.size(); ++next_) {
      const Edge& edge = arrangement_.edges[next_];
      if (bottom < Level{Wide(edge.low.y), Wide(1)}) break;
      passing_.push_back({&edge, {}, {}});
    }
    const LevelLine below = line_of(bottom), above = line_of(top);
    for (Passing& p : passing_) {
      p.at_bottom = abscissa(*p.edge, below);
      p.at_top = abscissa(*p.edge, above);
    }
    // Most edges are in order, from the level below.
    for (std::size_t i = 1; i < passing_.size(); ++i) {
      for (std::size_t k = i; k > 0 && is_left_of(passing_[k], passing_[k - 1]); --k) {
        std::swap(passing_[k], passing_[k - 1]);
      }
    }
  }

  void fill(std::size_t level) {
    std::vector<int> windings(layers_, 0);
    const Passing* left = nullptr;
    for (std::size_t i = 0; i < passing_.size(); ++i) {
      const Passing& edge = passing_[i];
      windings[edge.edge->layer] += edge.edge->turn;
      if (i + 1 < passing_.size() && coincide(edge, passing_[i + 1])) continue;
      const bool filled = filled_(windings);
      if (filled && left == nullptr) left = &edge;
      if (filled || left == nullptr) continue;
      add(level, *left, edge);
      left = nullptr;
    }
  }

  /// True if the strip can go on with the piece: they share a whole side, and bend inwards nowhere.
  bool continues(const Growing& piece, const Passing& left, const Passing& right) const {
    if (piece.left.links.size() + piece.right.links.size() + 4 > kMostSides) return false;
    return compare_slopes(*left.edge, piece.left.last()) >= 0 && compare_slopes(*right.edge, piece.right.last()) <= 0 &&
           compare(abscissa(piece.left.last(), line_), left.at_bottom) == 0 &&
           compare(abscissa(piece.right.last(), line_), right.at_bottom) == 0;
  }

  /// Pieces below are in order from left to right, too. Those that went on have no links left.
  Growing* find_below(const Passing& left, const Passing& right) {
    for (std::size_t k = first_below_; k < below_.size(); ++k) {
      const bool is_over = below_[k].left.links.empty();
      if (!is_over && continues(below_[k], left, right)) return &below_[k];
      const int side = is_over ? -1 : compare(abscissa(below_[k].left.last(), line_), left.at_bottom);
      if (side > 0) break;
      if (side < 0 && k == first_below_) ++first_below_;
    }
    return nullptr;
  }

  void add(std::size_t level, const Passing& left, const Passing& right) {
    Growing* const found = find_below(left, right);
    if (found == nullptr) {
      open_.push_back({{{{left.edge, level}}}, {{{right.edge, level}}}, level, level + 1});
      return;
    }
    found->top = level + 1;
    if (compare_slopes(*left.edge, found->left.last()) != 0) found->left.links.push_back({left.edge, level});
    if (compare_slopes(*right.edge, found->right.last()) != 0) found->right.links.push_back({right.edge, level});
    open_.push_back(std::move(*found));
    found->left.links.clear();
  }

  const Arrangement& arrangement_;
  const std::size_t layers_;
  const Filled& filled_;
  std::size_t next_ = 0;          // of the edges by their lower ends
  std::vector<Passing> passing_;  // from left to right
  LevelLine line_{};              // of the level below
  std::vector<Growing> below_;    // up to the level below
  std::size_t first_below_ = 0;   // those before are left of all that is still to come
  std::vector<Growing> open_;     // up to the level above
  std::vector<Growing> done_;
};

/// Beyond which the piece does not go: to the left of an edge, or to its right.
Side side(const Edge& edge, bool is_left) {
  const std::int64_t turn = is_left ? -1 : 1;
  const std::int64_t a = turn * edge.dy(), b = -turn * edge.dx();
  return {a, b, static_cast<__int128>(a) * edge.low.x + static_cast<__int128>(b) * edge.low.y};
}

/// The level, or the next whole number below or above if it is none.
std::int64_t whole(const Level& level, bool upwards) {
  Wide down = level.p / level.q;
  if (down * level.q > level.p) down -= 1;
  if (upwards && down * level.q < level.p) down += 1;
  return down.convert_to<std::int64_t>();
}

ConvexPiece::Vertex vertex(const Edge& edge, const Level& level) {
  return {static_cast<double>(rounded_x(edge, level)) * kStep, static_cast<double>(rounded(level)) * kStep};
}

double area_of(const std::vector<ConvexPiece::Vertex>& v) {
  double twice = 0.0;
  for (std::size_t i = 1; i + 1 < v.size(); ++i) {
    twice += (v[i].x - v[0].x) * (v[i + 1].y - v[0].y) - (v[i].y - v[0].y) * (v[i + 1].x - v[0].x);
  }
  return 0.5 * twice;
}

ConvexPiece finished(const Growing& piece, const std::vector<Level>& levels) {
  const Level& bottom = levels[piece.bottom];
  const Level& top = levels[piece.top];
  const auto& left = piece.left.links;
  const auto& right = piece.right.links;
  const LevelLine below = line_of(bottom), above = line_of(top);
  const bool has_bottom = compare(abscissa(*left.front().edge, below), abscissa(*right.front().edge, below)) != 0;
  const bool has_top = compare(abscissa(*left.back().edge, above), abscissa(*right.back().edge, above)) != 0;
  ConvexPiece out{};
  for (const Chain::Link& link : right) {
    out.sides.push_back(side(*link.edge, false));
    out.vertices.push_back(vertex(*link.edge, levels[link.from]));
  }
  out.vertices.push_back(vertex(*right.back().edge, top));
  if (has_top) {
    out.sides.push_back({0, 1, whole(top, true)});
    out.vertices.push_back(vertex(*left.back().edge, top));
  }
  for (std::size_t i = left.size(); i-- > 0;) {
    out.sides.push_back(side(*left[i].edge, true));
    if (i > 0 || has_bottom) out.vertices.push_back(vertex(*left[i].edge, levels[left[i].from]));
  }
  if (has_bottom) out.sides.push_back({0, -1, -whole(bottom, false)});
  out.area = area_of(out.vertices);
  return out;
}

std::vector<ConvexPiece> cut_along_levels(const std::vector<Outline>& outlines, std::size_t layers,
                                          const Filled& filled) {
  const Arrangement arrangement = arrange(outlines);
  std::vector<ConvexPiece> out;
  for (const Growing& piece : Sweep(arrangement, layers, filled).run()) {
    out.push_back(finished(piece, arrangement.levels));
  }
  return out;
}

void mirror(std::vector<ConvexPiece>& cut) {
  for (ConvexPiece& piece : cut) {
    for (Side& s : piece.sides) std::swap(s.a, s.b);
    for (ConvexPiece::Vertex& v : piece.vertices) std::swap(v.x, v.y);
    std::reverse(piece.sides.begin(), piece.sides.end());
    std::reverse(piece.vertices.begin(), piece.vertices.end());
  }
}

void check(const std::vector<Outline>& outlines) {
  std::size_t corners = 0;
  for (const Outline& outline : outlines) {
    if (!outline.is_hull) corners += outline.corners.size();
    for (const Corner& c : outline.corners) {
      if (std::max(std::llabs(c.x), std::llabs(c.y)) > kMostSteps) {
        throw std::invalid_argument("a corner is more than 32 km from the origin");
      }
    }
  }
  if (corners > kMostCorners) {
    throw std::invalid_argument("more than " + std::to_string(kMostCorners) + " corners in one area");
  }
}

}  // namespace

std::vector<ConvexPiece> convex_pieces(const std::vector<Outline>& outlines, std::size_t layers, const Filled& filled) {
  check(outlines);
  std::vector<ConvexPiece> upright = cut_along_levels(outlines, layers, filled);
  if (upright.size() < 2) return upright;
  // Cut across the other axis, there may be fewer pieces. Mirrored outlines would wind the other way.
  std::vector<Outline> mirrored = outlines;
  for (Outline& outline : mirrored) {
    for (Corner& c : outline.corners) std::swap(c.x, c.y);
    std::reverse(outline.corners.begin(), outline.corners.end());
  }
  std::vector<ConvexPiece> across = cut_along_levels(mirrored, layers, filled);
  if (across.size() >= upright.size()) return upright;
  mirror(across);
  return across;
}

}  // namespace tern_host
