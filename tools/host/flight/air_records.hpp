// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_FLIGHT_AIR_RECORDS_HPP
#define TERN_HOST_FLIGHT_AIR_RECORDS_HPP

#include "host/flight/setting_readers.hpp"

namespace tern_host {

/// Adds the records of the air that rigid bodies fly in.
void add_air_setters(Setters& setters);

}  // namespace tern_host

#endif
