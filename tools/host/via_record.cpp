// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/via_record.hpp"

#include <cstddef>
#include <vector>

namespace tern_host {

tern::Via read_via(const Words& words, const Place& place) {
  std::size_t count = 1;
  while (count < words.size() && words[count] != "stop" && words[count] != "velocity") ++count;
  const std::vector<double> given = numbers(Words(words.begin(), words.begin() + std::ptrdiff_t(count)), place);
  if (given.size() != 3 && given.size() != 4)
    throw_count("via", "3 numbers, or 4 with a tolerance", given.size(), place);
  tern::Via via{{given[0], given[1], given[2]}, given.size() == 4 ? given[3] : 0.0, false, false, {}};
  if (count < words.size() && words[count] == "velocity") {
    via.velocity = vector(Words(words.begin() + std::ptrdiff_t(count), words.end()), place);
    via.has_velocity = true;
  } else if (count < words.size()) {
    if (count + 1 < words.size()) throw RecordError(place, "'via' ends with 'stop', found " + quote(words[count + 1]));
    via.stop = true;
  }
  return via;
}

}  // namespace tern_host
