// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Operational intents and constraints of ASTM F3548-21, as services of UTM exchange them.
#ifndef TERN_HOST_AIRSPACE_F3548_HPP
#define TERN_HOST_AIRSPACE_F3548_HPP

#include <string>
#include <vector>

#include "host/airspace/json_node.hpp"
#include "host/airspace/zone.hpp"

namespace tern_host {

enum class EntityKind { kIntent, kConstraint };

/// An operational intent or a constraint. What a document does not say is empty or 0.
struct UtmEntity {
  EntityKind kind = EntityKind::kIntent;
  std::string id;       ///< of the reference; without one, the place in the file
  std::string manager;  ///< who answers for it
  std::string state;    ///< Accepted, Activated, Nonconforming or Contingent; a constraint has none
  std::string ovn;      ///< the number of its present version that others show to have seen it
  std::string base_url;
  int version = 0;
  int priority = 0;           ///< a larger number goes first
  std::string type;           ///< of a constraint
  std::vector<Zone> volumes;  ///< keep-outs with one area, heights above the ellipsoid, and one span of time
};

/// All entities of a document, in its order, which may be none: of an intent first the nominal volumes, then the
/// others. Throws RecordError.
std::vector<UtmEntity> read_utm_entities(const JsonNode& document);

/// The same of a file.
std::vector<UtmEntity> read_utm_file(const std::string& path);

/// A UUID in lower case: the same one may be written in capitals.
std::string entity_id(std::string text);

/// When a volume of an entity holds; without a beginning or an end, from 1900 or until 2200.
TimeSpan span_of(const Zone& volume);

}  // namespace tern_host

#endif
