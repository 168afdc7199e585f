// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How much room fences leave a curve, for all t.
#ifndef TERN_VERIFY_FENCES_HPP
#define TERN_VERIFY_FENCES_HPP

#include <cstddef>
#include <vector>

#include "verify/bezier.hpp"
#include "verify/problem.hpp"

namespace tern_verify {

/// The least room of curves, in metres: inside a keep-in, or beyond a keep-out's distance. Below 0, they break it.
struct FenceRoom {
  Rational least;  ///< no point of a curve has less
  Rational most;   ///< this point has no more, as far as the directions that were tried say
  std::size_t curve;
  Rational u;  ///< of that point, in [0, 1]
};

/// To within 1e-10 m, or to a quarter where there is more than a metre. There are curves, in the world frame.
/// `boundary`: of the world; what a keep-out has further than its distance beyond it does not matter.
FenceRoom fence_room(const std::vector<Polygon<3>>& curves, const Fence& fence, const Box& boundary);
/// The same of curves that need room from one of their own fences each, of which there are some.
FenceRoom fence_room(const std::vector<Polygon<3>>& curves, const std::vector<std::vector<const Fence*>>& fences,
                     const Box& boundary);

}  // namespace tern_verify

#endif
