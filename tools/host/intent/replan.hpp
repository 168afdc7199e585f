// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Giving way before the flight: later, at another level, or around.
#ifndef TERN_HOST_INTENT_REPLAN_HPP
#define TERN_HOST_INTENT_REPLAN_HPP

#include <string>
#include <vector>

#include "host/intent/conflicts.hpp"
#include "host/intent/tube_volumes.hpp"

namespace tern_host {

enum class Remedy {
  kNone,    ///< as asked
  kDelay,   ///< the same flight later
  kLevel,   ///< others' volumes are closed at their heights: over or under them, or around if that is shorter
  kDetour,  ///< others' volumes are closed at all heights: around them
            ///< Both are tried later as well, where they don't help at once and a delay alone would take longer.
};
const char* remedy_name(Remedy remedy);

struct ReplanSettings {
  TubeSettings tube;
  double rest = 0.0;              ///< s at the plan's end
  double longest_delay = 3600.0;  ///< s
};

/// A way to fly, and what it costs.
struct Proposal {
  Remedy remedy = Remedy::kNone;
  bool free = false;     ///< it must give way to nobody
  std::string why_not;   ///< why it is not free
  double arrival = 0.0;  ///< s of the scenario's clock at the plan's end
  PlanResult result;
  UtmEntity intent;
};

/// The scenario's plan as an intent like `like`. If it must give way, each remedy is tried. The first proposal is the
/// plan as asked; if that is not free, the remedies follow, in the order above. Throws std::invalid_argument where a
/// volume cannot be read or made, ScenarioError where the grid does not fit.
std::vector<Proposal> proposals_of(Session& session, const Scenario& scenario, const UtmEntity& like,
                                   const std::vector<UtmEntity>& others, const LocalFrame& frame,
                                   const ReplanSettings& settings);

/// The one that is free and arrives first; of several, the first. Null: there is none.
const Proposal* best_of(const std::vector<Proposal>& proposals);

/// Each proposal in a line.
std::string proposals_text(const std::vector<Proposal>& proposals);

}  // namespace tern_host

#endif
