// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_PICTURE_PICTURE_HPP
#define TERN_HOST_PICTURE_PICTURE_HPP

#include <string>

#include "host/session.hpp"

namespace tern_host {

/// The plan as one SVG page: key figures, top and side view to one scale, velocity and acceleration over time. Where
/// there is no plan: the map, what was reached, and why it ended.
std::string plan_svg(const PlanResult& result);

/// The flight through the map, seen from above and the side, with little text: wide, low and for anybody. The same
/// bytes for the same plan, as it shows no computing time.
std::string oblique_svg(const PlanResult& result);

}  // namespace tern_host

#endif
