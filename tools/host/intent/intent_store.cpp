// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/intent/intent_store.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>

#include "host/intent/conflicts.hpp"

namespace tern_host {
namespace {

/// A DSS draws its numbers. These are the same in every run.
std::string ovn_of(const UtmEntity& entity) {
  std::uint64_t hash = 14695981039346656037u;
  for (const char c : entity.id + "/" + std::to_string(entity.version)) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
  }
  char text[24];
  std::snprintf(text, sizeof text, "ovn-%016llx", static_cast<unsigned long long>(hash));
  return text;
}

}  // namespace

std::vector<UtmEntity> IntentStore::relevant(const UtmEntity& entity) const {
  std::vector<bool> meets(entities_.size(), false);
  for (const Conflict& c : conflicts_of(entity, entities_, frame_)) meets[c.other] = true;
  std::vector<UtmEntity> out;
  for (std::size_t i = 0; i < entities_.size(); ++i) {
    if (meets[i]) out.push_back(entities_[i]);
  }
  return out;
}

StoreAnswer IntentStore::put(UtmEntity entity, const std::vector<std::string>& key) {
  StoreAnswer answer;
  const auto old =
      std::find_if(entities_.begin(), entities_.end(), [&entity](const UtmEntity& e) { return e.id == entity.id; });
  answer.is_outdated = entity.ovn != (old == entities_.end() ? "" : old->ovn);
  for (const UtmEntity& other : relevant(entity)) {
    if (std::find(key.begin(), key.end(), other.ovn) == key.end()) answer.missing.push_back(other);
  }
  if (answer.is_outdated || !answer.missing.empty()) return answer;
  entity.version = old == entities_.end() ? 1 : old->version + 1;
  entity.ovn = ovn_of(entity);
  answer.accepted = true;
  answer.ovn = entity.ovn;
  if (old == entities_.end()) {
    entities_.push_back(std::move(entity));
  } else {
    *old = std::move(entity);
  }
  return answer;
}

std::vector<std::string> key_of(const std::vector<UtmEntity>& entities) {
  std::vector<std::string> key;
  for (const UtmEntity& entity : entities) key.push_back(entity.ovn);
  return key;
}

}  // namespace tern_host
