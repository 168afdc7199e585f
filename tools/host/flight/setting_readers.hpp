// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the records of a flight's settings have in common.
#ifndef TERN_HOST_FLIGHT_SETTING_READERS_HPP
#define TERN_HOST_FLIGHT_SETTING_READERS_HPP

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "host/flight/flight_world.hpp"
#include "host/text_records.hpp"

namespace tern_host {

/// What a setting of one number may be.
struct Range {
  double least;
  double most;
};

inline bool holds(const Range& range, double value) {
  return value >= range.least && value <= range.most;
}

/// Reads a record, of which `words` are all, into the settings. Throws RecordError.
using Setter = std::function<void(FlightSettings&, const Words& words, const Place&)>;
using Setters = std::map<std::string, Setter>;

/// `value` if it is within the range. Throws RecordError.
double within(const std::string& key, double value, const Range& range, const Place& place);
/// The same for whole numbers alone.
double whole_within(const std::string& key, double value, const Range& range, const Place& place);

/// The record's only number, within the range. Throws RecordError.
double number_within(const Words& words, const Range& range, const Place& place);
double whole_number_within(const Words& words, const Range& range, const Place& place);

/// The record's two numbers. Throws RecordError.
std::vector<double> two_numbers(const Words& words, const Place& place);

/// A setting of one number, and of one whole number.
Setter real(double FlightSettings::*field, double least, double most);
Setter whole(int FlightSettings::*field, double least, double most);

}  // namespace tern_host

#endif
