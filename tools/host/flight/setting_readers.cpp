// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/setting_readers.hpp"

#include <cmath>

#include "host/number.hpp"

namespace tern_host {
namespace {

double only_number(const Words& words, const Place& place) {
  const std::vector<double> values = numbers(words, place);
  if (values.size() != 1) throw_count(words[0], "one number", values.size(), place);
  return values[0];
}

}  // namespace

double within(const std::string& key, double value, const Range& range, const Place& place) {
  if (holds(range, value)) return value;
  throw RecordError(place,
                    key + " " + brief(value) + " is not within " + brief(range.least) + " .. " + brief(range.most));
}

double whole_within(const std::string& key, double value, const Range& range, const Place& place) {
  if (value < std::floor(value) || value > std::floor(value)) {
    throw RecordError(place, key + " " + brief(value) + " is not a whole number");
  }
  return within(key, value, range, place);
}

double number_within(const Words& words, const Range& range, const Place& place) {
  return within(words[0], only_number(words, place), range, place);
}

double whole_number_within(const Words& words, const Range& range, const Place& place) {
  return whole_within(words[0], only_number(words, place), range, place);
}

std::vector<double> two_numbers(const Words& words, const Place& place) {
  std::vector<double> values = numbers(words, place);
  if (values.size() != 2) throw_count(words[0], "two numbers", values.size(), place);
  return values;
}

Setter real(double FlightSettings::*field, double least, double most) {
  return [=](FlightSettings& s, const Words& words, const Place& place) {
    s.*field = number_within(words, {least, most}, place);
  };
}

Setter whole(int FlightSettings::*field, double least, double most) {
  return [=](FlightSettings& s, const Words& words, const Place& place) {
    s.*field = static_cast<int>(whole_number_within(words, {least, most}, place));
  };
}

}  // namespace tern_host
