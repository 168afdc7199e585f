// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Instants as files have them: RFC 3339, and times of the day.
#ifndef TERN_HOST_INSTANT_HPP
#define TERN_HOST_INSTANT_HPP

#include <cstdint>
#include <optional>
#include <string>

namespace tern_host {

/// Nanoseconds since 1970-01-01T00:00:00Z, without leap seconds.
using Instant = std::int64_t;

constexpr Instant kSecond = 1000000000;
constexpr Instant kDay = 86400 * kSecond;

/// The beginnings of 1900 and of 2200: no instant is read as one before or after.
constexpr Instant kFirstInstant = -25567 * kDay;
constexpr Instant kLastInstant = 84006 * kDay;

/// A date and time with a zone, from 1900 on, such as 2026-03-01T09:30:00.5+01:00; a second 60 is the first of the next
/// minute. Any time after the beginning of 2200 is that. Nothing for any other text.
std::optional<Instant> parse_instant(const std::string& text);

/// A time of the day with a zone, such as 09:30Z or 18:00:00+01:00: nanoseconds since midnight in UTC, which may be
/// less than 0 or more than a day. 24:00 is the end of the day. Nothing for any other text.
std::optional<Instant> parse_day_time(const std::string& text);

/// The day that the instant is in, counted from 1970-01-01, a Thursday.
Instant day_of(Instant instant);

/// As RFC 3339 in UTC, with three, six or nine digits of a fraction only where they are needed.
std::string instant_text(Instant instant);

}  // namespace tern_host

#endif
