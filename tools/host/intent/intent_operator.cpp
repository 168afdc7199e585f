// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/intent/intent_operator.hpp"

#include <algorithm>

#include "host/number.hpp"

namespace tern_host {
namespace {

std::string line_of(const IntentOperator& one, int round, bool accepted) {
  std::string line = "round " + std::to_string(round) + ", " + one.name() + ": ";
  if (one.written().volumes.empty()) return line + "no plan is free of what it knows\n";
  line += std::string(remedy_name(one.remedy())) + ", arrives at " + fixed(one.arrival(), 3) + " s: ";
  if (accepted) return line + "accepted\n";
  return line + "refused, " + std::to_string(one.missing()) + " that it did not know are in the way\n";
}

}  // namespace

bool IntentOperator::try_once(IntentStore& store) {
  const std::vector<Proposal> all = proposals_of(session_, scenario_, like_, known_, frame_, settings_);
  const Proposal* const best = best_of(all);
  written_ = best == nullptr ? UtmEntity{} : best->intent;
  missing_ = 0;
  if (best == nullptr) return false;
  remedy_ = best->remedy;
  arrival_ = best->arrival;
  const StoreAnswer answer = store.put(written_, key_of(known_));
  missing_ = answer.missing.size();
  for (const UtmEntity& entity : answer.missing) {
    const auto old = std::find_if(known_.begin(), known_.end(), [&](const UtmEntity& e) { return e.id == entity.id; });
    if (old == known_.end()) {
      known_.push_back(entity);
    } else {
      *old = entity;
    }
  }
  return answer.accepted;
}

bool plan_until_accepted(std::vector<IntentOperator>& operators, IntentStore& store, int rounds, std::string& log) {
  std::vector<bool> accepted(operators.size(), false);
  for (int round = 1; round <= rounds; ++round) {
    for (std::size_t i = 0; i < operators.size(); ++i) {
      if (accepted[i]) continue;
      accepted[i] = operators[i].try_once(store);
      log += line_of(operators[i], round, accepted[i]);
    }
    if (std::all_of(accepted.begin(), accepted.end(), [](bool is) { return is; })) return true;
  }
  return false;
}

}  // namespace tern_host
