// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Step (1) of the paper's Section 3.3.1: the ellipsoid around a segment. It starts as a sphere whose diameter is the
// segment, and its x axis stays along the segment. The other two axes shrink until no obstacle is inside. Then z alone
// stretches again as far as it can.
#ifndef TERN_ELLIPSOID_ELLIPSOID_FIT_HPP
#define TERN_ELLIPSOID_ELLIPSOID_FIT_HPP

#include <cstdint>

#include "base/progress.hpp"
#include "base/work.hpp"
#include "ellipsoid/ellipsoid_metric.hpp"
#include "grid/local_boxes.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// The boxes, grown by a radius, that the ellipsoid must not meet.
struct Obstacles {
  const LocalBox* boxes;
  int count;
  double radius;
};

/// Segments shorter than this, in metres, count as points. Their ellipsoid is a ball.
constexpr double kPointLike = 1e-6;

/// The phases of a fit.
enum class FitPhase : std::uint8_t {
  kCollect,       ///< the obstacles near the sphere, before y and z shrink
  kShrink,        ///< y and z shrink together, so that the ellipsoid stays round about the segment
  kCollectAgain,  ///< the obstacles near the sphere, before z is stretched
  kStretch,       ///< z alone: it starts as long as x, and shrinks
  kDone,
};

/// A fit in progress. Plain data; needs no initialisation before fit_begin.
struct EllipsoidFit {
  EllipsoidFrame frame;  ///< when done, the ellipsoid
  FitPhase phase;
  double half;  ///< half the segment's length, metres
  // The current round: it looks at the candidates, and keeps those that the ellipsoid meets.
  EllipsoidMetric metric;
  int step;   ///< rounds of this phase before the current one
  int count;  ///< candidates
  int next;   ///< the one to look at next
  int kept;
  BoxContact first;  ///< the contact that the ellipsoid meets first, if any are kept
};

/// Fits the ellipsoid to the segment from `from` to `to` (local frame, metres). `cell` sets the size of the ball if the
/// segment is a point.
///
/// The paper shrinks until no obstacle is inside. Here, an obstacle may reach inside by a thousandth of the ellipsoid's
/// size, and no axis falls below a hundredth of the longest. This is good enough, because the ellipsoid only gives the
/// half-spaces their directions.
void fit_begin(EllipsoidFit& fit, const Vec3& from, const Vec3& to, double cell) noexcept;

constexpr int kFitScreens = 256;
constexpr int kFitContacts = 16;
/// A piece of work collects the candidates, or looks at kFitScreens of them and computes at most kFitContacts contacts.
/// `inside` is scratch for obstacles.count indices. Do not touch it until kDone.
Progress fit_advance(EllipsoidFit& fit, const Obstacles& obstacles, std::int32_t* inside, Work& work) noexcept;

/// The ellipsoid with every semi-axis raised to at least `share` of the first. If a segment grazes an obstacle, its
/// ellipsoid is a needle. The tangents of a needle are all nearly parallel, and they cut away free space.
EllipsoidFrame at_least_as_thick(const EllipsoidFrame& frame, double share) noexcept;

}  // namespace tern

#endif
