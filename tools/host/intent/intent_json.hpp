// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_INTENT_INTENT_JSON_HPP
#define TERN_HOST_INTENT_INTENT_JSON_HPP

#include <string>

#include "host/airspace/f3548.hpp"

namespace tern_host {

/// True for the form that F3548 wants of an entity's id: a UUID of version 4.
bool is_entity_id(const std::string& id);

/// An operational intent as a service of UTM answers a question for its details ("GetOperationalIntentDetailsResponse"
/// of F3548-21). Every volume has heights and times.
std::string intent_json(const UtmEntity& intent);

}  // namespace tern_host

#endif
