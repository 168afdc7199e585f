// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// When a zone holds: spans of time, and schedules by weekday.
#ifndef TERN_HOST_AIRSPACE_ZONE_TIMES_HPP
#define TERN_HOST_AIRSPACE_ZONE_TIMES_HPP

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "host/instant.hpp"

namespace tern_host {

/// From an instant until another, both included.
struct TimeSpan {
  Instant from;
  Instant until;
};

/// A time of the day or an event, such as sunrise, by its name.
struct DayTime {
  std::optional<Instant> time;
  std::string event;
};

/// When events are, as the caller gives them: times of the day, as parse_day_time() returns them.
using DayEvents = std::map<std::string, Instant>;

/// Parts of days. One that ends no later than it begins ends on the next day.
struct DaySchedule {
  bool days[7];  ///< Monday first; the days on which it begins, in the zone of its first time
  DayTime from;
  DayTime until;
};

/// When a zone holds: within the dates, in each part of a day; with no parts, all the time.
struct Applicability {
  std::optional<Instant> from;
  std::optional<Instant> until;
  std::vector<DaySchedule> schedule;
};

/// The spans that meet `horizon`, in order; those that overlap or touch are one. A span without end lasts until 2200.
/// Throws std::invalid_argument where one ends before it begins, or an event is not among `events`.
std::vector<TimeSpan> spans_of(const std::vector<Applicability>& applicability, const TimeSpan& horizon,
                               const DayEvents& events);

/// "2026-03-02T09:00:00Z to 2026-03-02T10:00:00Z"; "from … on", "until …" or "always" of a span that begins with 1900
/// or ends with 2200, as spans without a beginning or an end do.
std::string span_text(const TimeSpan& span);

}  // namespace tern_host

#endif
