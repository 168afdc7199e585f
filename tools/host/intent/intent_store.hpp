// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Operational intents of all operators, in memory, as a DSS of ASTM F3548 keeps them: for tests and demonstrations.
#ifndef TERN_HOST_INTENT_INTENT_STORE_HPP
#define TERN_HOST_INTENT_INTENT_STORE_HPP

#include <string>
#include <vector>

#include "host/airspace/f3548.hpp"
#include "host/airspace/local_frame.hpp"

namespace tern_host {

/// What became of a write.
struct StoreAnswer {
  bool accepted = false;
  std::string ovn;                 ///< of what was written
  std::vector<UtmEntity> missing;  ///< relevant to it, and of another version than the writer knows, or unknown to it
  bool is_outdated = false;        ///< somebody wrote the entity since
};

/// Optimistic concurrency by OVN, the number of a version that nobody can guess the next of: who writes shows the OVNs
/// of all that is relevant, and of what is overwritten, and is refused if one is not the present one. The store does
/// not say whether entities conflict: whoever has seen them all decides that.
class IntentStore {
 public:
  /// Volumes are compared in this frame.
  explicit IntentStore(const LocalFrame& frame) : frame_(frame) {}

  /// Writes an intent or a constraint, new or in place of the one with its id, whose OVN is then `entity.ovn`. `key`:
  /// the OVNs of all that has a volume in common with it.
  StoreAnswer put(UtmEntity entity, const std::vector<std::string>& key);

  /// All that has a volume in common with the entity, but the entity itself.
  std::vector<UtmEntity> relevant(const UtmEntity& entity) const;

 private:
  LocalFrame frame_;
  std::vector<UtmEntity> entities_;
};

/// The OVNs of entities: a key.
std::vector<std::string> key_of(const std::vector<UtmEntity>& entities);

}  // namespace tern_host

#endif
