// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The records that say what sees, how it is mounted and how it errs.
#ifndef TERN_HOST_FLIGHT_SENSOR_RECORDS_HPP
#define TERN_HOST_FLIGHT_SENSOR_RECORDS_HPP

#include "host/flight/setting_readers.hpp"

namespace tern_host {

void add_sensor_setters(Setters& setters);

/// Whether a whole turn fits depends on the sensor, whose record may come later: to be called after all records.
void check_fov(const FlightSettings& settings, const Place& place);

}  // namespace tern_host

#endif
