// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/intent/replan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "host/intent/others_fences.hpp"
#include "host/number.hpp"
#include "host/plan_file.hpp"

namespace tern_host {
namespace {

/// Later than touching, s.
constexpr double kMargin = 1e-3;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

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
    const double sooner_than = out[1].free ? out[1].arrival : kInfinity;
    out.push_back(around_or_later(Remedy::kLevel, FenceHeights::kAsTheyAre, out[0].intent, conflicts, sooner_than));
    out.push_back(around_or_later(Remedy::kDetour, FenceHeights::kAll, out[0].intent, conflicts, sooner_than));
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

  /// By how much later the flight must be for the first and for the last of these conflicts to end, s: a volume must
  /// begin after the one that it meets has ended.
  struct Waits {
    double first = kInfinity;
    double last = 0.0;
  };
  Waits waits_of(const UtmEntity& intent, const std::vector<Conflict>& conflicts) const {
    Waits waits;
    for (const Conflict& c : conflicts) {
      if (!c.binding) continue;
      const Instant end = span_of(others_[c.other].volumes[c.other_volume]).until;
      const Instant wait = end - span_of(intent.volumes[c.volume]).from;
      const double seconds = static_cast<double>(wait) / static_cast<double>(kSecond) + kMargin;
      waits.first = std::min(waits.first, seconds);
      waits.last = std::max(waits.last, seconds);
    }
    return waits;
  }

  /// The least delay: conflicts with a volume end only once that volume has ended, however the flight goes on. Where
  /// the scenario's own fences leave no plan, it waits until one of them opens or closes.
  Proposal later(UtmEntity intent, std::vector<Conflict> conflicts) {
    Scenario scenario = scenario_;
    scenario.start_time += waits_of(intent, conflicts).last;
    for (;;) {
      if (scenario.start_time - scenario_.start_time > settings_.longest_delay) {
        Proposal none;
        none.remedy = Remedy::kDelay;
        none.why_not = "it would have to begin more than " + brief(settings_.longest_delay) + " s later, because of " +
                       first_binding(conflicts);
        return none;
      }
      Proposal proposal = propose(Remedy::kDelay, scenario, conflicts);
      const double change = next_change(scenario);
      if (proposal.free || (!proposal.result.ok() && std::isinf(change))) return proposal;
      scenario.start_time =
          proposal.result.ok() ? scenario.start_time + waits_of(proposal.intent, conflicts).last : change;
    }
  }

  /// When the next fence of the scenario's own opens or closes after its start, s; infinite: none does.
  static double next_change(const Scenario& scenario) {
    double next = kInfinity;
    for (const FenceRecord& record : scenario.fences) {
      if (!tern::is_timed(record.fence)) continue;
      for (const std::int64_t change : {record.fence.from, record.fence.until}) {
        const double at = static_cast<double>(change) / static_cast<double>(kSecond) + record.fence.clock_error;
        if (at + kMargin > scenario.start_time) next = std::min(next, at + kMargin);
      }
    }
    return next;
  }

  /// At once, or else when a volume that the flight as asked would meet has ended, one after the other.
  Proposal around_or_later(Remedy remedy, FenceHeights heights, UtmEntity intent, std::vector<Conflict> conflicts,
                           double sooner_than) {
    Scenario scenario = scenario_;
    Proposal at_once = around(remedy, heights, scenario, conflicts);
    while (!at_once.free) {
      scenario.start_time += waits_of(intent, conflicts).first;
      const bool in_time = scenario.start_time - scenario_.start_time <= settings_.longest_delay;
      if (!in_time || scenario.start_time >= sooner_than) break;
      Proposal direct = propose(Remedy::kDelay, scenario, conflicts);
      if (direct.free || !direct.result.ok()) break;
      intent = std::move(direct.intent);
      Proposal later = around(remedy, heights, scenario, conflicts);
      if (later.free) return later;
    }
    return at_once;
  }

  /// Among all volumes while they hold; where no such plan is found, among those that plans met, closed at all times.
  Proposal around(Remedy remedy, FenceHeights heights, const Scenario& scenario, std::vector<Conflict> conflicts) {
    std::vector<Conflict> left;
    Proposal timed = propose(remedy, among(others_, scenario, heights, true), left);
    if (timed.free) return timed;
    std::vector<UtmEntity> met;
    for (;;) {
      if (!add_met(conflicts, met)) return timed;
      Proposal closed = propose(remedy, among(met, scenario, heights, false), conflicts);
      if (closed.free) return closed;
      if (!closed.result.ok()) return timed;
    }
  }

  Scenario among(const std::vector<UtmEntity>& others, Scenario scenario, FenceHeights heights, bool timed) const {
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
