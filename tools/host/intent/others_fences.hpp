// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Volumes that one must give way to as fences for a while, wide enough that the volumes of a plan around them meet
// none.
#ifndef TERN_HOST_INTENT_OTHERS_FENCES_HPP
#define TERN_HOST_INTENT_OTHERS_FENCES_HPP

#include <vector>

#include "host/airspace/f3548.hpp"
#include "host/fence_record.hpp"
#include "host/intent/tube_volumes.hpp"

namespace tern_host {

enum class FenceHeights {
  kAsTheyAre,  ///< a plan may pass over and under a volume
  kAll,        ///< it must go around
};

/// The flight that is to keep clear of others.
struct OwnFlight {
  tern::Box boundary;  ///< world frame, m
  double clearance;    ///< radius and tracking margin, m
  int priority;        ///< intents of a lower one give way
  std::string id;      ///< others with it are its own earlier versions
};

/// Keep-outs for the volumes of constraints and of intents of no less priority that reach the boundary. Throws
/// std::invalid_argument where a volume cannot be read.
std::vector<FenceRecord> others_fences(const std::vector<UtmEntity>& others, const OwnFlight& own,
                                       const LocalFrame& frame, const TubeSettings& tube, FenceHeights heights);

}  // namespace tern_host

#endif
