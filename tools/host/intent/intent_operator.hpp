// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// An operator that plans with what it knows, and learns from refusals, until its intent is accepted.
#ifndef TERN_HOST_INTENT_INTENT_OPERATOR_HPP
#define TERN_HOST_INTENT_INTENT_OPERATOR_HPP

#include <string>
#include <vector>

#include "host/intent/intent_store.hpp"
#include "host/intent/replan.hpp"

namespace tern_host {

class IntentOperator {
 public:
  /// `like`: id, manager and priority of its intent.
  IntentOperator(Scenario scenario, UtmEntity like, const LocalFrame& frame, ReplanSettings settings)
      : scenario_(std::move(scenario)), like_(std::move(like)), frame_(frame), settings_(std::move(settings)) {}

  /// One plan, and one write of it. True once it is accepted. Throws as proposals_of() does.
  bool try_once(IntentStore& store);

  const std::string& name() const { return scenario_.name; }
  /// What was written last, and by which remedy; nothing if no plan is free of what the operator knows.
  const UtmEntity& written() const { return written_; }
  Remedy remedy() const { return remedy_; }
  /// Of the plan that was written last, on the scenario's clock.
  double arrival() const { return arrival_; }
  /// What was missing in the last write's key, as the store answered.
  std::size_t missing() const { return missing_; }

 private:
  Session session_;
  Scenario scenario_;
  UtmEntity like_;
  LocalFrame frame_;
  ReplanSettings settings_;
  std::vector<UtmEntity> known_;
  UtmEntity written_;
  Remedy remedy_ = Remedy::kNone;
  double arrival_ = 0.0;
  std::size_t missing_ = 0;
};

/// Lets them try in turn, until all are accepted or `rounds` are over. Appends a line for each try to `log`. True if
/// all were accepted.
bool plan_until_accepted(std::vector<IntentOperator>& operators, IntentStore& store, int rounds, std::string& log);

}  // namespace tern_host

#endif
