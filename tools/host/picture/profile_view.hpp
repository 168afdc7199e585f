// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_PICTURE_PROFILE_VIEW_HPP
#define TERN_HOST_PICTURE_PROFILE_VIEW_HPP

#include "host/figures.hpp"
#include "host/picture/axes.hpp"
#include "host/session.hpp"

namespace tern_host {

enum class Profile { kVelocity, kAcceleration };

/// Velocity or acceleration over time against its limits, each axis and limit in a colour of its own, into `frame`. The
/// title stands above the frame, the key with the peaks in its upper part. `figures`: the plan's.
void draw_profile(Canvas& canvas, const Rect& frame, Profile profile, const PlanResult& result, const Figures& figures);

}  // namespace tern_host

#endif
