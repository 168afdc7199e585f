// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "flight/flight_access.hpp"

#include "map/map_state.hpp"

namespace tern {

void FlightAccess::forget_time(RollingMap& map) noexcept {
  map.state_->timed = false;
}

}  // namespace tern
