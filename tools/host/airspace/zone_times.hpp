// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Instants as data about airspace has them: RFC 3339, times of the day, schedules by weekday.
#ifndef TERN_HOST_AIRSPACE_ZONE_TIMES_HPP
#define TERN_HOST_AIRSPACE_ZONE_TIMES_HPP

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tern_host {

/// Nanoseconds since 1970-01-01T00:00:00Z, without leap seconds.
using Instant = std::int64_t;

constexpr Instant kSecond = 1000000000;
constexpr Instant kDay = 86400 * kSecond;

/// A date and time with a zone, from 1900 on, such as 2026-03-01T09:30:00.5+01:00; a second 60 is the first of the next
/// minute. Any time after the beginning of 2200 is that. Nothing for any other text.
std::optional<Instant> parse_instant(const std::string& text);

/// A time of the day with a zone, such as 09:30Z or 18:00:00+01:00: nanoseconds since midnight in UTC, which may be
/// less than 0 or more than a day. 24:00 is the end of the day. Nothing for any other text.
std::optional<Instant> parse_day_time(const std::string& text);

/// As RFC 3339 in UTC, with fractions only where there are some.
std::string instant_text(Instant instant);

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

}  // namespace tern_host

#endif
