// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "attack/clearance.hpp"

namespace tern_attack {
namespace {

/// A piece still to be decided, with the obstacles that are not proven far from it.
struct Piece {
  Curve curve;
  std::vector<tern::Voxel> near;
};

struct Span {
  Point low;
  Point high;
};

Span span_of(const Curve& curve) {
  Span span{curve.p[0], curve.p[0]};
  for (int i = 1; i <= curve.degree; ++i) {
    for (int a = 0; a < 3; ++a) {
      span.low[a] = std::min(span.low[a], curve.p[i][a]);
      span.high[a] = std::max(span.high[a], curve.p[i][a]);
    }
  }
  return span;
}

Real low_face(const World& world, const tern::Voxel& v, int a) {
  return axis(v, a) * static_cast<Real>(world.spec.cell);
}
Real high_face(const World& world, const tern::Voxel& v, int a) {
  return (axis(v, a) + 1) * static_cast<Real>(world.spec.cell);
}

std::vector<tern::Voxel> obstacles_near(const World& world, const Span& span, Real reach) {
  int low[3];
  int high[3];
  const Real cell = world.spec.cell;
  for (int a = 0; a < 3; ++a) {
    const Real count = axis(world.spec.dims, a);
    low[a] = static_cast<int>(std::floor(std::max(-1.0L, std::min(count, (span.low[a] - reach) / cell - 1e-6L))));
    high[a] = static_cast<int>(std::floor(std::max(-1.0L, std::min(count, (span.high[a] + reach) / cell + 1e-6L))));
  }
  std::vector<tern::Voxel> found;
  for (int z = low[2]; z <= high[2]; ++z) {
    for (int y = low[1]; y <= high[1]; ++y) {
      for (int x = low[0]; x <= high[0]; ++x) {
        if (world.is_solid(x, y, z)) found.push_back({x, y, z});
      }
    }
  }
  return found;
}

/// Proven by the boxes around both.
bool boxes_apart(const World& world, const Span& span, const tern::Voxel& v, Real least) {
  Real square = 0;
  for (int a = 0; a < 3; ++a) {
    const Real gap = std::max(low_face(world, v, a) - span.high[a], span.low[a] - high_face(world, v, a));
    if (gap >= least) return true;
    if (gap > 0) square += gap * gap;
  }
  return least > 0 && square >= least * least;
}

/// Proven by a plane that touches the cube at `on` and has it all on its far side: the hull lies beyond it.
bool plane_parts(const Curve& curve, const Point& on, const Point& normal, Real least) {
  for (int i = 0; i <= curve.degree; ++i) {
    if (dot(normal, curve.p[i] - on) < least) return false;
  }
  return true;
}

bool hull_apart(const World& world, const Curve& curve, const tern::Voxel& v, Real least) {
  const Point middle = 0.5L * (curve.first() + curve.last());
  Point on{};
  for (int a = 0; a < 3; ++a) {
    on[a] = std::max(low_face(world, v, a), std::min(high_face(world, v, a), middle[a]));
  }
  const Point away = middle - on;
  const Real distance = length(away);
  return distance > 0 && plane_parts(curve, on, (1 / distance) * away, least);
}

}  // namespace

Real cube_distance(const World& world, const tern::Voxel& voxel, const Point& p) {
  Real square = 0;
  Real deepest = -1e30L;
  for (int a = 0; a < 3; ++a) {
    const Real gap = std::max(low_face(world, voxel, a) - p[a], p[a] - high_face(world, voxel, a));
    deepest = std::max(deepest, gap);
    if (gap > 0) square += gap * gap;
  }
  return square > 0 ? std::sqrt(square) : deepest;
}

Clearance clearance(const World& world, const Curve& whole, Real least) {
  constexpr int kMostPieces = 20000;
  std::vector<Piece> open;
  open.push_back({whole, obstacles_near(world, span_of(whole), std::max(least, 0.0L))});
  for (int pieces = 0; !open.empty(); ++pieces) {
    const Piece piece = std::move(open.back());
    open.pop_back();
    const Span span = span_of(piece.curve);
    Piece left{{}, {}};
    for (const tern::Voxel& v : piece.near) {
      if (boxes_apart(world, span, v, least) || hull_apart(world, piece.curve, v, least)) continue;
      for (const bool end : {false, true}) {
        const Real distance = cube_distance(world, v, end ? piece.curve.last() : piece.curve.first());
        if (distance < least) return {Proof::kBroken, end ? piece.curve.to : piece.curve.from, distance, v};
      }
      left.near.push_back(v);
    }
    if (left.near.empty()) continue;
    if (pieces >= kMostPieces) return {Proof::kUnproven, piece.curve.from, 0, left.near.front()};
    Piece right{{}, left.near};
    split(piece.curve, left.curve, right.curve);
    open.push_back(std::move(right));
    open.push_back(std::move(left));
  }
  return {Proof::kProven, 0, 0, {}};
}

}  // namespace tern_attack
