// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_PICTURE_PROFILE_VIEW_HPP
#define TERN_HOST_PICTURE_PROFILE_VIEW_HPP

#include "host/picture/axes.hpp"
#include "host/session.hpp"

namespace tern_host {

enum class Profile { kVelocity, kAcceleration };

/// Velocity or acceleration over time, per axis and as a norm, against its limits, into `frame`; title and key stand
/// above the frame.
void draw_profile(Canvas& canvas, const Rect& frame, Profile profile, const PlanResult& result);

}  // namespace tern_host

#endif
