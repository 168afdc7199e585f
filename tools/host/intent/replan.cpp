// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/intent/replan.hpp"

#include <algorithm>

#include "host/intent/others_fences.hpp"
#include "host/number.hpp"
#include "host/plan_file.hpp"

namespace tern_host {
namespace {

/// Later than touching, s.
constexpr double kMargin = 1e-3;

/// Plans the scenario in one way after the other.
class Replan {
 public:
  Replan(Session& session, const Scenario& scenario, const UtmEntity& like, const std::vector<UtmEntity>& others,
         const LocalFrame& frame, const ReplanSettings& settings)
      : session_(session), scenario_(scenario), like_(like), others_(others), frame_(frame), settings_(settings) {}

  std::vector<Proposal> run() {
    std::vector<Proposal> out;
    std::vector<Conflict> conflicts;
    out.push_back(propose(Remedy::kNone, scenario_, conflicts));
    if (out[0].free || !out[0].result.ok()) return out;
    out.push_back(later(out[0].intent, conflicts));
    out.push_back(around(Remedy::kLevel, FenceHeights::kAsTheyAre, conflicts));
    out.push_back(around(Remedy::kDetour, FenceHeights::kAll, conflicts));
    return out;
  }

 private:
  Proposal propose(Remedy remedy, const Scenario& scenario, std::vector<Conflict>& conflicts) {
    Proposal proposal;
    proposal.remedy = remedy;
    proposal.result = session_.plan(scenario);
    proposal.intent = like_;
    if (!proposal.result.ok()) {
      proposal.why_not = std::string("there is no plan: ") + tern::status_name(proposal.result.report.status);
      return proposal;
    }
    TimedPath path = timed_path_of(proposal.result);
    proposal.arrival = path.pieces.back().end;
    if (settings_.rest > 0.0) path = with_rest(path, settings_.rest);
    proposal.intent.volumes = tube_volumes(path, frame_, settings_.tube);
    conflicts = conflicts_of(proposal.intent, others_, frame_);
    proposal.free = !has_binding(conflicts);
    if (!proposal.free) proposal.why_not = "it meets " + first_binding(conflicts);
    return proposal;
  }

  std::string first_binding(const std::vector<Conflict>& conflicts) const {
    const auto first = std::find_if(conflicts.begin(), conflicts.end(), [](const Conflict& c) { return c.binding; });
    return others_[first->other].id;
  }

  /// By how much later the flight must be for these conflicts to end, s. Each of its volumes must begin after the one
  /// that it meets has ended.
  double wait_for(const UtmEntity& intent, const std::vector<Conflict>& conflicts) const {
    Instant wait = 0;
    for (const Conflict& c : conflicts) {
      if (!c.binding) continue;
      const Instant end = span_of(others_[c.other].volumes[c.other_volume]).until;
      wait = std::max(wait, end - span_of(intent.volumes[c.volume]).from);
    }
    return static_cast<double>(wait) / static_cast<double>(kSecond) + kMargin;
  }

  /// The least delay: conflicts with a volume end only once that volume has ended, however the flight goes on.
  Proposal later(UtmEntity intent, std::vector<Conflict> conflicts) {
    Scenario scenario = scenario_;
    for (;;) {
      scenario.start_time += wait_for(intent, conflicts);
      if (scenario.start_time - scenario_.start_time > settings_.longest_delay) {
        Proposal none;
        none.remedy = Remedy::kDelay;
        none.why_not = "it would have to begin more than " + brief(settings_.longest_delay) + " s later, because of " +
                       first_binding(conflicts);
        return none;
      }
      Proposal proposal = propose(Remedy::kDelay, scenario, conflicts);
      if (proposal.free || !proposal.result.ok()) return proposal;
      intent = proposal.intent;
    }
  }

  /// Among all volumes while they hold; where no such plan is found, among those that plans met, closed at all times.
  Proposal around(Remedy remedy, FenceHeights heights, std::vector<Conflict> conflicts) {
    std::vector<Conflict> left;
    Proposal timed = propose(remedy, among(others_, heights, true), left);
    if (timed.free) return timed;
    std::vector<UtmEntity> met;
    for (;;) {
      if (!add_met(conflicts, met)) return timed;
      Proposal closed = propose(remedy, among(met, heights, false), conflicts);
      if (closed.free) return closed;
      if (!closed.result.ok()) return timed;
    }
  }

  Scenario among(const std::vector<UtmEntity>& others, FenceHeights heights, bool timed) const {
    Scenario scenario = scenario_;
    scenario.rest_clear = std::max(scenario.rest_clear, settings_.rest);
    const OwnFlight own{scenario.boundary, scenario.clearance(), like_.priority, like_.id};
    for (FenceRecord& fence : others_fences(others, own, frame_, settings_.tube, heights)) {
      if (!timed) fence.fence.from = fence.fence.until = 0;
      scenario.fences.push_back(std::move(fence));
    }
    return scenario;
  }

  /// Adds the volumes of the conflicts that bind. False if none of them is new.
  bool add_met(const std::vector<Conflict>& conflicts, std::vector<UtmEntity>& met) const {
    const std::size_t before = met.size();
    for (const Conflict& c : conflicts) {
      UtmEntity one = others_[c.other];
      one.volumes = {one.volumes[c.other_volume]};
      const auto is_same = [&one](const UtmEntity& e) {
        return e.id == one.id && e.volumes[0].place == one.volumes[0].place;
      };
      if (c.binding && std::none_of(met.begin(), met.end(), is_same)) met.push_back(std::move(one));
    }
    return met.size() > before;
  }

  Session& session_;
  const Scenario& scenario_;
  const UtmEntity& like_;
  const std::vector<UtmEntity>& others_;
  const LocalFrame& frame_;
  const ReplanSettings& settings_;
};

}  // namespace

const char* remedy_name(Remedy remedy) {
  const char* const names[] = {"as asked", "delay", "level", "detour"};
  return names[static_cast<int>(remedy)];
}

std::vector<Proposal> proposals_of(Session& session, const Scenario& scenario, const UtmEntity& like,
                                   const std::vector<UtmEntity>& others, const LocalFrame& frame,
                                   const ReplanSettings& settings) {
  return Replan(session, scenario, like, others, frame, settings).run();
}

const Proposal* best_of(const std::vector<Proposal>& proposals) {
  const Proposal* best = nullptr;
  for (const Proposal& p : proposals) {
    if (p.free && (best == nullptr || p.arrival < best->arrival)) best = &p;
  }
  return best;
}

std::string proposals_text(const std::vector<Proposal>& proposals) {
  const Proposal* const best = best_of(proposals);
  std::string text;
  for (const Proposal& p : proposals) {
    text += std::string(remedy_name(p.remedy)) + ": ";
    if (p.free) {
      text +=
          "free, begins at " + fixed(p.result.scenario.start_time, 3) + " s, arrives at " + fixed(p.arrival, 3) + " s";
    } else {
      text += "not free, " + p.why_not;
    }
    text += &p == best ? " (taken)\n" : "\n";
  }
  return text;
}

}  // namespace tern_host
