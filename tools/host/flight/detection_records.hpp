// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_FLIGHT_DETECTION_RECORDS_HPP
#define TERN_HOST_FLIGHT_DETECTION_RECORDS_HPP

#include "host/flight/setting_readers.hpp"

namespace tern_host {

/// Adds the settings of what a flight is told of things that move.
void add_detection_setters(Setters& setters);

}  // namespace tern_host

#endif
