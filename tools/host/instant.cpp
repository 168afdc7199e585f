// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/instant.hpp"

#include <cstdio>

namespace tern_host {
namespace {

constexpr int kFirstYear = 1900, kLastYear = 2200;

/// Reads a text from its beginning.
class TimeReader {
 public:
  explicit TimeReader(const std::string& text) : text_(text) {}

  bool at_end() const { return at_ == text_.size(); }
  bool take(const char* any) {
    if (at_end() || std::string(any).find(text_[at_]) == std::string::npos) return false;
    ++at_;
    return true;
  }
  /// Exactly so many digits, as a number up to `most`; -1 for anything else.
  int digits(int count, int most) {
    int value = 0;
    for (int i = 0; i < count; ++i, ++at_) {
      if (at_end() || text_[at_] < '0' || text_[at_] > '9') return -1;
      value = 10 * value + (text_[at_] - '0');
    }
    return value <= most ? value : -1;
  }
  /// Digits after the point, as nanoseconds; more than nine are read and dropped. -1 where there is none.
  Instant fraction() {
    Instant value = 0, unit = kSecond;
    const std::size_t first = at_;
    for (; !at_end() && text_[at_] >= '0' && text_[at_] <= '9'; ++at_) {
      unit /= 10;
      value += unit * (text_[at_] - '0');
    }
    return at_ > first ? value : -1;
  }

 private:
  const std::string& text_;
  std::size_t at_ = 0;
};

/// Days from 1970-01-01 to a date of the Gregorian calendar. Years are counted from March, so that leap days end them.
Instant days_to(int year, int month, int day) {
  const int y = month > 2 ? year : year - 1, m = month > 2 ? month - 3 : month + 9;
  return Instant{365} * y + y / 4 - y / 100 + y / 400 + (153 * m + 2) / 5 + day - 1 - 719468;
}

int days_in(int year, int month) {
  const int next = month == 12 ? 1 : month + 1;
  return static_cast<int>(days_to(month == 12 ? year + 1 : year, next, 1) - days_to(year, month, 1));
}

/// HH:MM, HH:MM:SS or HH:MM:SS.fraction.
std::optional<Instant> clock_time(TimeReader& reader) {
  const int hour = reader.digits(2, 24);
  if (hour < 0 || !reader.take(":")) return {};
  const int minute = reader.digits(2, 59);
  if (minute < 0) return {};
  Instant rest = 0;
  if (reader.take(":")) {
    const int second = reader.digits(2, 60);
    const Instant part = second >= 0 && reader.take(".,") ? reader.fraction() : 0;
    if (second < 0 || part < 0) return {};
    rest = second * kSecond + part;
  }
  const Instant time = (Instant{3600} * hour + Instant{60} * minute) * kSecond + rest;
  if (hour == 24 && time != kDay) return {};
  return time;
}

/// Z, +HH:MM or -HH:MM, to the end of the text.
std::optional<Instant> offset(TimeReader& reader) {
  if (reader.take("Zz")) return reader.at_end() ? std::optional<Instant>(0) : std::nullopt;
  const bool east = reader.take("+");
  if (!east && !reader.take("-")) return {};
  const int hour = reader.digits(2, 23);
  const bool colon = reader.take(":");
  const int minute = reader.digits(2, 59);
  if (hour < 0 || !colon || minute < 0 || !reader.at_end()) return {};
  return (east ? 1 : -1) * (Instant{3600} * hour + Instant{60} * minute) * kSecond;
}

}  // namespace

Instant day_of(Instant instant) {
  return instant >= 0 ? instant / kDay : -((kDay - 1 - instant) / kDay);
}

std::optional<Instant> parse_instant(const std::string& text) {
  TimeReader reader(text);
  const int year = reader.digits(4, 9999);
  if (year < kFirstYear || !reader.take("-")) return {};
  const int month = reader.digits(2, 12);
  if (month < 1 || !reader.take("-")) return {};
  const int day = reader.digits(2, days_in(year, month));
  if (day < 1 || !reader.take("Tt ")) return {};
  const std::optional<Instant> time = clock_time(reader);
  if (!time) return {};
  const std::optional<Instant> zone = offset(reader);
  if (!zone) return {};
  if (year >= kLastYear) return kLastInstant;
  return days_to(year, month, day) * kDay + *time - *zone;
}

std::optional<Instant> parse_day_time(const std::string& text) {
  TimeReader reader(text);
  const std::optional<Instant> time = clock_time(reader);
  if (!time) return {};
  const std::optional<Instant> zone = offset(reader);
  if (!zone) return {};
  return *time - *zone;
}

std::string instant_text(Instant instant) {
  const Instant day = day_of(instant), in_day = instant - day * kDay;
  int year = kFirstYear - 1;
  while (days_to(year + 1, 1, 1) <= day) ++year;
  int month = 1;
  while (month < 12 && days_to(year, month + 1, 1) <= day) ++month;
  const long long seconds = in_day / kSecond, rest = in_day % kSecond;
  char text[64];
  std::snprintf(text, sizeof text, "%04d-%02d-%02dT%02lld:%02lld:%02lld", year, month,
                static_cast<int>(day - days_to(year, month, 1)) + 1, seconds / 3600, seconds / 60 % 60, seconds % 60);
  std::string out = text;
  if (rest != 0) {
    std::snprintf(text, sizeof text, ".%09lld", rest);
    out += text;
    // Whole milliseconds or microseconds need no more digits.
    while (out.compare(out.size() - 3, 3, "000") == 0) out.resize(out.size() - 3);
  }
  return out + "Z";
}

}  // namespace tern_host
