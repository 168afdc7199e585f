// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/airspace/zone_times.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "support/random.hpp"

namespace {

using tern_host::Applicability;
using tern_host::DaySchedule;
using tern_host::Instant;
using tern_host::instant_text;
using tern_host::kDay;
using tern_host::kSecond;
using tern_host::parse_day_time;
using tern_host::parse_instant;
using tern_host::TimeSpan;

TEST(ZoneTimes, ReadsInstants) {
  EXPECT_EQ(parse_instant("1970-01-01T00:00:00Z"), Instant{0});
  EXPECT_EQ(parse_instant("2026-03-01T09:30:00.25+01:00"), Instant{1772353800} * kSecond + kSecond / 4);  // date -d
  EXPECT_EQ(parse_instant("2000-02-29t12:00:00z"), Instant{951825600} * kSecond);
  EXPECT_EQ(parse_instant("1969-12-31 23:59:59-00:00"), -kSecond);
  EXPECT_EQ(parse_instant("2016-12-31T23:59:60Z"), parse_instant("2017-01-01T00:00:00Z"));
  EXPECT_EQ(parse_instant("2026-03-01T24:00:00Z"), parse_instant("2026-03-02T00:00:00Z"));
  EXPECT_EQ(parse_instant("2026-03-01T00:00:00.123456789123Z"), Instant{1772323200} * kSecond + 123456789);
}

TEST(ZoneTimes, YearsAfter2200AreNoEnd) {
  EXPECT_EQ(parse_instant("9999-12-31T23:59:59Z"), parse_instant("2200-01-01T00:00:00Z"));
  EXPECT_LT(parse_instant("2199-12-31T23:59:59Z"), parse_instant("2200-01-01T00:00:00Z"));
}

TEST(ZoneTimes, RefusesWhatIsNoInstant) {
  for (const char* text :
       {"", "2026-03-01", "2026-03-01T09:30:00", "2026-02-29T00:00:00Z", "2026-13-01T00:00:00Z", "2026-00-01T00:00:00Z",
        "2026-03-00T00:00:00Z", "2026-03-01T25:00:00Z", "2026-03-01T24:00:01Z", "2026-03-01T09:60:00Z",
        "2026-03-01T09:30:61Z", "2026-03-01T09:30:00.Z", "2026-03-01T09:30:00Zx", "2026-03-01T09:30:00+1:00",
        "2026-03-01T09:30:00+0100", "1899-12-31T00:00:00Z", "26-03-01T00:00:00Z", "-026-03-01T00:00:00Z"}) {
    EXPECT_FALSE(parse_instant(text)) << text;
  }
  for (const char* text : {"", "9:00Z", "09:00", "09Z", "24:30Z", "09:00:00Z ", "-1:00Z"}) {
    EXPECT_FALSE(parse_day_time(text)) << text;
  }
}

TEST(ZoneTimes, ReadsTimesOfTheDay) {
  EXPECT_EQ(parse_day_time("09:30Z"), 34200 * kSecond);
  EXPECT_EQ(parse_day_time("00:30:00+01:00"), -1800 * kSecond);
  EXPECT_EQ(parse_day_time("24:00:00Z"), kDay);
}

TEST(ZoneTimes, WritesWhatItReads) {
  tern_test::Random random(21);
  for (int i = 0; i < tern_test::scaled(2000); ++i) {
    const Instant instant =
        static_cast<Instant>(random.real(-2.2e9, 7.2e9)) * kSecond + (i % 2) * random.integer(1, 999999999);
    EXPECT_EQ(parse_instant(instant_text(instant)), instant) << instant_text(instant);
  }
  EXPECT_EQ(instant_text(Instant{1772353800} * kSecond), "2026-03-01T08:30:00Z");
  EXPECT_EQ(instant_text(-kSecond), "1969-12-31T23:59:59Z");
  EXPECT_EQ(instant_text(500000000), "1970-01-01T00:00:00.500Z");
  EXPECT_EQ(instant_text(1000), "1970-01-01T00:00:00.000001Z");
  EXPECT_EQ(instant_text(7), "1970-01-01T00:00:00.000000007Z");
}

Instant at(const char* text) {
  return *parse_instant(text);
}

DaySchedule weekdays(const char* from, const char* until) {
  return {{true, true, true, true, true, false, false}, {parse_day_time(from), ""}, {parse_day_time(until), ""}};
}

TEST(ZoneTimes, SchedulesHoldOnTheirDays) {
  Applicability when;
  when.schedule.push_back(weekdays("07:00Z", "11:00Z"));
  // 2026-03-02 is a Monday.
  const auto monday = tern_host::spans_of({when}, {at("2026-03-02T00:00:00Z"), at("2026-03-02T23:00:00Z")}, {});
  ASSERT_EQ(monday.size(), 1u);
  EXPECT_EQ(instant_text(monday[0].from), "2026-03-02T07:00:00Z");
  EXPECT_EQ(instant_text(monday[0].until), "2026-03-02T11:00:00Z");
  EXPECT_TRUE(tern_host::spans_of({when}, {at("2026-02-28T00:00:00Z"), at("2026-03-01T23:00:00Z")}, {}).empty());
  EXPECT_EQ(tern_host::spans_of({when}, {at("2026-03-02T00:00:00Z"), at("2026-03-08T23:00:00Z")}, {}).size(), 5u);
}

TEST(ZoneTimes, PartsMayPassMidnightAndAreCutByDates) {
  Applicability when;
  when.schedule.push_back(weekdays("22:00Z", "02:00Z"));
  when.until = at("2026-03-07T01:00:00Z");
  // Friday evening, as seen on Saturday morning.
  const auto night = tern_host::spans_of({when}, {at("2026-03-07T00:30:00Z"), at("2026-03-07T10:00:00Z")}, {});
  ASSERT_EQ(night.size(), 1u);
  EXPECT_EQ(instant_text(night[0].from), "2026-03-06T22:00:00Z");
  EXPECT_EQ(instant_text(night[0].until), "2026-03-07T01:00:00Z");
  // In a zone to the east, Monday begins on Sunday in UTC: the day is that of UTC.
  Applicability east;
  east.schedule.push_back(weekdays("00:30+01:00", "05:00+01:00"));
  const auto early = tern_host::spans_of({east}, {at("2026-03-01T12:00:00Z"), at("2026-03-02T12:00:00Z")}, {});
  ASSERT_EQ(early.size(), 1u);
  EXPECT_EQ(instant_text(early[0].from), "2026-03-01T23:30:00Z");
}

TEST(ZoneTimes, SpansThatTouchAreOne) {
  Applicability first, second, later;
  first.from = at("2026-03-02T08:00:00Z");
  first.until = at("2026-03-02T09:00:00Z");
  second.from = at("2026-03-02T09:00:00Z");
  second.until = at("2026-03-02T10:00:00Z");
  later.from = at("2026-03-02T11:00:00Z");
  const auto spans =
      tern_host::spans_of({later, second, first}, {at("2026-03-02T00:00:00Z"), at("2026-03-03T00:00:00Z")}, {});
  ASSERT_EQ(spans.size(), 2u);
  EXPECT_EQ(spans[0].from, *first.from);
  EXPECT_EQ(spans[0].until, *second.until);
  EXPECT_EQ(instant_text(spans[1].until), "2200-01-01T00:00:00Z");
}

TEST(ZoneTimes, SpansInWords) {
  const Applicability open;
  const auto always = tern_host::spans_of({open}, {at("2026-03-02T00:00:00Z"), at("2026-03-03T00:00:00Z")}, {});
  ASSERT_EQ(always.size(), 1u);
  EXPECT_EQ(tern_host::span_text(always[0]), "always");
  const auto nine = at("2026-03-02T09:00:00Z"), ten = at("2026-03-02T10:00:00Z");
  EXPECT_EQ(tern_host::span_text({nine, ten}), "2026-03-02T09:00:00Z to 2026-03-02T10:00:00Z");
  EXPECT_EQ(tern_host::span_text({nine, always[0].until}), "from 2026-03-02T09:00:00Z on");
  EXPECT_EQ(tern_host::span_text({always[0].from, ten}), "until 2026-03-02T10:00:00Z");
}

TEST(ZoneTimes, RefusesAnEndBeforeTheBeginning) {
  Applicability when;
  when.from = at("2026-03-02T09:00:00Z");
  when.until = at("2026-03-02T08:00:00Z");
  EXPECT_THROW(tern_host::spans_of({when}, {at("2026-03-02T00:00:00Z"), at("2026-03-03T00:00:00Z")}, {}),
               std::invalid_argument);
}

TEST(ZoneTimes, EventsAreAsGiven) {
  Applicability when;
  DaySchedule part = weekdays("00:00Z", "00:00Z");
  part.from = {{}, "SR"};
  part.until = {{}, "SS"};
  when.schedule.push_back(part);
  const TimeSpan day{at("2026-03-02T00:00:00Z"), at("2026-03-02T12:00:00Z")};
  const auto spans = tern_host::spans_of({when}, day, {{"SR", 6 * 3600 * kSecond}, {"SS", 17 * 3600 * kSecond}});
  ASSERT_EQ(spans.size(), 1u);
  EXPECT_EQ(instant_text(spans[0].from), "2026-03-02T06:00:00Z");
  EXPECT_THROW(tern_host::spans_of({when}, day, {{"SR", 0}}), std::invalid_argument);
}

}  // namespace
