// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "flight/chain.hpp"

#include "base/common_point.hpp"
#include "base/math.hpp"
#include "flight/fence_hours.hpp"
#include "prove/fences.hpp"

namespace tern {
namespace {

/// As many metres outside of a link, a place still counts as in it, as in proofs.
constexpr double kOutside = 1e-9;
/// How far a place on the way keeps from the faces of its links, voxels: the first that leaves a place.
constexpr double kKept[3] = {kAimVoxels, 0.25 * kAimVoxels, 0.0};

bool is_link(const Fence& fence) {
  return fence.kind == FenceKind::kKeepIn && is_timed(fence);
}

/// The links, with times since the vehicle rests.
struct Links {
  const FlightFacts& flight;
  std::int32_t count;
  FenceHours hours[kMaxFences];  ///< ends before it begins: no link, or one that never holds
  bool around[kMaxFences];       ///< the vehicle rests in it

  Links(const FlightFacts& facts, const Vec3& place, std::int64_t rests, Work& work)
      : flight(facts), count(facts.spec.fence_count) {
    for (std::int32_t k = 0; k < count; ++k) {
      const Fence& fence = flight.fences[k];
      hours[k] = is_link(fence) ? hours_of(fence, rests) : FenceHours{0.0, -1.0};
      around[k] = hours[k].begin < hours[k].end && fence_clear(fence, {place, 0.0, kOutside}, &kZero, 1, work);
    }
  }
};

/// Until when one of the links around the vehicle holds, without a gap.
double covered_until(const Links& links) {
  double until = 0.0;
  for (std::int32_t turn = 0; turn < links.count; ++turn) {
    const double before = until;
    for (std::int32_t k = 0; k < links.count; ++k) {
      if (links.around[k] && links.hours[k].begin <= until) until = larger(until, links.hours[k].end);
    }
    if (!(until > before)) break;
  }
  return until;
}

/// Until when a vehicle that is in link `first` from `since` on may be in the chain. Ways take no time here.
double longest_stay(const Links& links, std::int32_t first, double since, Work& work) {
  double entered[kMaxFences];
  for (std::int32_t k = 0; k < links.count; ++k) entered[k] = kAllHours;
  entered[first] = since;
  double until = links.hours[first].end;
  bool goes_on = true;
  for (std::int32_t turn = 0; goes_on && turn < links.count; ++turn) {
    goes_on = false;
    work.spend(ops::kTurn * links.count * links.count);
    for (std::int32_t a = 0; a < links.count; ++a) {
      for (std::int32_t b = 0; b < links.count && entered[a] < kAllHours; ++b) {
        const double when = larger(entered[a], links.hours[b].begin);
        if (!links.flight.meet[a][b] || when > smaller(links.hours[a].end, links.hours[b].end)) continue;
        if (!(when < entered[b])) continue;
        entered[b] = when;
        until = larger(until, links.hours[b].end);
        goes_on = true;
      }
    }
  }
  return until;
}

bool add_all(const Fence& fence, CommonPoint& common) {
  bool has_point = true;
  for (std::int32_t p = 0; p < fence.count && has_point; ++p) has_point = common.add(fence.planes[p]);
  return has_point;
}

/// The place nearest to another one that is in both links and in all keep-ins that always hold, `kept` metres or more
/// from all their faces. False if there is none.
bool common_place(const FlightFacts& flight, std::int32_t a, std::int32_t b, const Vec3& near, double kept,
                  Vec3& found) {
  CommonPoint common(near, -kept, 1.0);
  for (std::int32_t k = 0; k < flight.spec.fence_count; ++k) {
    const Fence& fence = flight.fences[k];
    const bool is_asked = k == a || k == b || (fence.kind == FenceKind::kKeepIn && !is_timed(fence));
    if (is_asked && !add_all(fence, common)) return false;
  }
  found = common.nearest();
  return common.within_reach();
}

/// What common_place() takes at most.
Operations price_of(const FlightFacts& flight) {
  Operations planes = 0;
  for (std::int32_t k = 0; k < flight.spec.fence_count; ++k) planes += flight.fences[k].count;
  return 2 * ops::kDot * (planes * planes * planes / 6 + planes);
}

}  // namespace

void WaysOn::add(const WayOn& added) noexcept {
  std::int32_t at = count;
  const auto comes_before = [&](const WayOn& other) {
    return added.lasts > other.lasts || (!(added.lasts < other.lasts) && added.until > other.until);
  };
  while (at > 0 && comes_before(way[at - 1])) --at;
  if (at == kWaysOn) return;
  if (count < kWaysOn) ++count;
  for (std::int32_t k = count - 1; k > at; --k) way[k] = way[k - 1];
  way[at] = added;
}

WaysOn ways_on(const FlightFacts& flight, const Vec3& place, std::int64_t rests, Work& work) noexcept {
  WaysOn ways;
  work.spend(ops::kTurn * flight.spec.fence_count);
  if (!flight.has_chain) return ways;
  const Links links(flight, place, rests, work);
  const double covered = covered_until(links);
  for (std::int32_t b = 0; b < links.count; ++b) {
    if (links.around[b] || !(links.hours[b].begin < links.hours[b].end)) continue;
    WayOn best{kNoFence, b, 0.0, 0.0};
    double since = 0.0;
    for (std::int32_t a = 0; a < links.count; ++a) {
      if (!links.around[a] || links.hours[a].begin > covered || !flight.meet[a][b]) continue;
      const double until = smaller(links.hours[a].end, links.hours[b].end);
      const double when = larger(0.0, larger(links.hours[a].begin, links.hours[b].begin));
      if (when > until || !(until > best.until)) continue;
      best.from = a;
      best.until = until;
      since = when;
    }
    if (best.from == kNoFence) continue;
    best.lasts = longest_stay(links, b, since, work);
    if (best.lasts > covered) ways.add(best);
  }
  return ways;
}

bool place_on(const FlightFacts& flight, const WayOn& way, const Vec3& near, Vec3& found, Work& work) noexcept {
  const double cell = flight.map.safe().spec().cell;
  for (const double kept : kKept) {
    work.spend(price_of(flight));
    if (common_place(flight, way.from, way.to, near, kept * cell, found)) return true;
  }
  return false;
}

void find_meetings(FlightFacts& flight) noexcept {
  flight.has_chain = false;
  for (std::int32_t a = 0; a < flight.spec.fence_count; ++a) {
    flight.has_chain = flight.has_chain || is_link(flight.fences[a]);
    for (std::int32_t b = 0; b < a; ++b) {
      Vec3 common;
      flight.meet[a][b] = flight.meet[b][a] = is_link(flight.fences[a]) && is_link(flight.fences[b]) &&
                                              common_place(flight, a, b, flight.position(), 0.0, common);
    }
    flight.meet[a][a] = false;
  }
}

}  // namespace tern
