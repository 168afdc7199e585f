// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fences for a while. Between two instants at which one of them begins or ends, the same fences hold: the curve's part
// is proven against each keep-out of them, and to be in one of the keep-ins.
#include <algorithm>

#include "verify/fence_records.hpp"
#include "verify/fences.hpp"
#include "verify/proofs.hpp"
#include "verify/tracks.hpp"

namespace tern_verify {
namespace {

/// What stands for the room where no keep-in holds, metres.
constexpr int kNoRoom = -1000000;

/// A part of the plan during which the same fences hold.
struct Stretch {
  Polygon<3> curve;
  Rational from, to;
};

Rational begin_of(const Fence& fence) {
  return fence.window->from + (fence.keep_in ? fence.window->clock_error : Rational(-fence.window->clock_error));
}

Rational end_of(const Fence& fence) {
  return fence.window->until - (fence.keep_in ? fence.window->clock_error : Rational(-fence.window->clock_error));
}

std::vector<Stretch> stretches_of(const TimedWay& way, const std::vector<Fence>& fences) {
  std::vector<Rational> times{way.begin};
  for (const TimedCurve& curve : way.curves) times.push_back(times.back() + curve.duration);
  times.push_back(times.back() + way.rest);
  const Rational end = times.back();
  for (const Fence& fence : fences) {
    if (!fence.window) continue;
    for (const Rational& time : {begin_of(fence), end_of(fence)}) {
      if (way.begin < time && time < end) times.push_back(time);
    }
  }
  std::sort(times.begin(), times.end());
  std::vector<Stretch> stretches;
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    if (!(times[i] < times[i + 1])) continue;
    stretches.push_back({chain_part(way.curves, way.begin, times[i], times[i + 1]), times[i], times[i + 1]});
  }
  return stretches;
}

/// Each curve beside its fences, of which it needs room from one.
struct Task {
  std::vector<Polygon<3>> curves;
  std::vector<std::vector<const Fence*>> fences;
  std::vector<const Stretch*> stretches;

  void add(const Stretch& stretch, const std::vector<const Fence*>& of) {
    curves.push_back(stretch.curve);
    fences.push_back(of);
    stretches.push_back(&stretch);
  }

  Claim claim(const std::string& what, const FenceTimes& demand) const {
    const FenceRoom room = fence_room(curves, fences, demand.boundary);
    const Stretch& at = *stretches[room.curve];
    const Rational time = at.from + room.u * (at.to - at.from) - demand.zero;
    return {what, "m", room.least, room.most, demand.tolerance, "t = " + text_below(time) + " s"};
  }
};

void prove_keep_out(const FenceTimes& demand, const std::vector<Stretch>& stretches, std::size_t f, Claims& claims) {
  const Fence& fence = demand.fences[f];
  Task task;
  for (const Stretch& stretch : stretches) {
    if (begin_of(fence) < stretch.to && stretch.from < end_of(fence)) task.add(stretch, {&fence});
  }
  if (task.curves.empty()) return;
  claims.push_back(task.claim(title_of(demand.fences, f) + " for a while", demand));
}

void prove_keep_ins(const FenceTimes& demand, const std::vector<Stretch>& stretches, Claims& claims) {
  Task task;
  for (const Stretch& stretch : stretches) {
    std::vector<const Fence*> holding;
    for (const Fence& fence : demand.fences) {
      const bool is_room = fence.window && fence.keep_in;
      if (is_room && begin_of(fence) <= stretch.from && stretch.to <= end_of(fence)) holding.push_back(&fence);
    }
    if (!holding.empty()) {
      task.add(stretch, holding);
      continue;
    }
    const Rational time = stretch.from - demand.zero;
    claims.push_back({"keep-ins for a while", "m", kNoRoom, kNoRoom, demand.tolerance,
                      "t = " + text_below(time) + " s, where none holds"});
    return;
  }
  claims.push_back(task.claim("keep-ins for a while", demand));
}

}  // namespace

void prove_windows(const TimedWay& way, const FenceTimes& demand, Claims& claims) {
  const std::vector<Stretch> stretches = stretches_of(way, demand.fences);
  bool has_keep_ins = false;
  for (std::size_t f = 0; f < demand.fences.size(); ++f) {
    if (!demand.fences[f].window) continue;
    has_keep_ins = has_keep_ins || demand.fences[f].keep_in;
    if (!demand.fences[f].keep_in) prove_keep_out(demand, stretches, f, claims);
  }
  if (has_keep_ins) prove_keep_ins(demand, stretches, claims);
}

}  // namespace tern_verify
