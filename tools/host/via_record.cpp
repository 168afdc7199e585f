// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/via_record.hpp"

#include <cstddef>
#include <vector>

namespace tern_host {

namespace {

/// How the plan rests: [stop] [dwell seconds].
void read_stop(const Words& words, const Place& place, tern::Via& via) {
  via.stop = true;
  const std::size_t at = words[0] == "stop" ? 1 : 0;
  if (at == words.size()) return;
  if (words[at] != "dwell") throw RecordError(place, "'via' ends with 'stop', found " + quote(words[at]));
  const std::vector<double> seconds = numbers(Words(words.begin() + std::ptrdiff_t(at), words.end()), place);
  if (seconds.size() != 1) throw_count("dwell", "1 number of seconds", seconds.size(), place);
  via.dwell = seconds[0];
  if (!(via.dwell >= 0.0 && via.dwell <= tern::kMaxDwell)) {
    throw RecordError(place, "'dwell' is 0 to 3600 seconds, found " + quote(words[at + 1]));
  }
}

bool is_manner(const std::string& word) {
  return word == "stop" || word == "dwell" || word == "velocity";
}

}  // namespace

tern::Via read_via(const Words& words, const Place& place) {
  std::size_t count = 1;
  while (count < words.size() && !is_manner(words[count])) ++count;
  const std::vector<double> given = numbers(Words(words.begin(), words.begin() + std::ptrdiff_t(count)), place);
  if (given.size() != 3 && given.size() != 4)
    throw_count("via", "3 numbers, or 4 with a tolerance", given.size(), place);
  tern::Via via{{given[0], given[1], given[2]}, given.size() == 4 ? given[3] : 0.0, false, false, {}, 0.0};
  const Words manner(words.begin() + std::ptrdiff_t(count), words.end());
  if (!manner.empty() && manner[0] == "velocity") {
    via.velocity = vector(manner, place);
    via.has_velocity = true;
  } else if (!manner.empty()) {
    read_stop(manner, place, via);
  }
  return via;
}

}  // namespace tern_host
