// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/airspace/zone_times.hpp"

#include <algorithm>
#include <stdexcept>

namespace tern_host {
namespace {

Instant time_of(const DayTime& time, const DayEvents& events) {
  if (time.time) return *time.time;
  const auto found = events.find(time.event);
  if (found == events.end()) {
    throw std::invalid_argument("nothing says when '" + time.event + "' is: give --event " + time.event + "=HH:MMZ");
  }
  return found->second;
}

void add_days(const Applicability& when, const DaySchedule& part, const TimeSpan& dates, const DayEvents& events,
              std::vector<TimeSpan>& spans) {
  const Instant from = time_of(part.from, events);
  Instant until = time_of(part.until, events);
  if (until <= from) until += kDay;
  // Zones of time move a time of the day by less than a day, and parts last less than two.
  for (Instant day = day_of(dates.from) - 4; day <= day_of(dates.until) + 2; ++day) {
    const Instant weekday = ((day + 3) % 7 + 7) % 7;
    if (!part.days[weekday]) continue;
    TimeSpan span{day * kDay + from, day * kDay + until};
    if (when.from) span.from = std::max(span.from, *when.from);
    if (when.until) span.until = std::min(span.until, *when.until);
    if (span.from < span.until) spans.push_back(span);
  }
}

std::vector<TimeSpan> merged(std::vector<TimeSpan> spans) {
  std::sort(spans.begin(), spans.end(), [](const TimeSpan& a, const TimeSpan& b) { return a.from < b.from; });
  std::vector<TimeSpan> out;
  for (const TimeSpan& span : spans) {
    if (out.empty() || span.from > out.back().until) {
      out.push_back(span);
    } else {
      out.back().until = std::max(out.back().until, span.until);
    }
  }
  return out;
}

}  // namespace

std::vector<TimeSpan> spans_of(const std::vector<Applicability>& applicability, const TimeSpan& horizon,
                               const DayEvents& events) {
  const TimeSpan all{kFirstInstant, kLastInstant};
  std::vector<TimeSpan> spans;
  for (const Applicability& when : applicability) {
    if (when.from && when.until && *when.until < *when.from) {
      throw std::invalid_argument("it ends at " + instant_text(*when.until) + ", before it begins");
    }
    if (when.schedule.empty()) {
      const TimeSpan span{when.from.value_or(all.from), when.until.value_or(all.until)};
      if (span.from < span.until) spans.push_back(span);
    }
    for (const DaySchedule& part : when.schedule) add_days(when, part, horizon, events, spans);
  }
  std::vector<TimeSpan> out = merged(spans);
  const auto misses = [&horizon](const TimeSpan& s) { return s.until < horizon.from || s.from > horizon.until; };
  out.erase(std::remove_if(out.begin(), out.end(), misses), out.end());
  return out;
}

std::string span_text(const TimeSpan& span) {
  const bool begins = span.from > kFirstInstant, ends = span.until < kLastInstant;
  if (!begins) return ends ? "until " + instant_text(span.until) : "always";
  return ends ? instant_text(span.from) + " to " + instant_text(span.until) : "from " + instant_text(span.from) + " on";
}

}  // namespace tern_host
