// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The frame that an intent is made in: what a plan or a scenario says of it, and what the user says.
#ifndef TERN_HOST_INTENT_INTENT_FRAME_HPP
#define TERN_HOST_INTENT_INTENT_FRAME_HPP

#include <string>

#include "host/airspace/zone_heights.hpp"
#include "host/earth_frame.hpp"

namespace tern_host {

/// What the user says; files may say the rest.
struct ToldFrame {
  EarthFrame frame;
  HeightSources heights;  ///< the origin's height above mean sea level, and the geoid
};

struct IntentFrame {
  ZoneHeights heights;  ///< its frame() is that of the plan
  Instant epoch;        ///< when the plan's clock is 0
};

/// Of what the user and the file say. Throws std::invalid_argument where neither says it, or one says something else
/// than the other; `file` is for messages.
IntentFrame intent_frame(const ToldFrame& told, const EarthFrame& in_file, const std::string& file);

/// Throws std::invalid_argument where another file has another frame.
void check_same_frame(const IntentFrame& frame, const EarthFrame& in_file, const std::string& file);

}  // namespace tern_host

#endif
