// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_INTENT_OUTER_OUTLINE_HPP
#define TERN_HOST_INTENT_OUTER_OUTLINE_HPP

#include "host/intent/convex_gap.hpp"

namespace tern_host {

/// A convex polygon around a convex polygon, with as few sides as can be had by leaving sides out one after the other.
/// It stops before `least` sides are left, at least 3, or where a corner would be more than `most` metres from the
/// original. A tenth of a micrometre of the original may be outside.
PlanPolygon outer_outline(PlanPolygon polygon, std::size_t least, double most);

}  // namespace tern_host

#endif
