// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_INTENT_INTENT_TEXT_HPP
#define TERN_HOST_INTENT_INTENT_TEXT_HPP

#include <string>
#include <vector>

#include "host/airspace/zone_heights.hpp"
#include "host/intent/conflicts.hpp"

namespace tern_host {

/// An intent's volumes for people, each in a line: heights above the ellipsoid and, where a geoid is known, above mean
/// sea level.
std::string volumes_text(const UtmEntity& intent, const ZoneHeights& heights);

/// Each conflict in a line: with whom, when, where, and who gives way.
std::string conflicts_text(const std::vector<Conflict>& conflicts, const std::vector<UtmEntity>& others);

}  // namespace tern_host

#endif
