// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The rolling map without an operating system: the seeded flight of tests/support must give the same hash as on every
// host (contract C3). With TERN_MAP_ROWS it also prints what the jobs of maps that fit here count.
#include "baremetal/board.hpp"
#include "support/map_flight.hpp"
#ifdef TERN_MAP_ROWS
#include "timing/map_rows.hpp"
#endif

namespace {

using tern_board::hex;
using tern_board::print;

TERN_BOARD_LARGE tern_test::MapFlight flight;

bool same_hash(std::uint32_t slice) {
  const std::uint64_t hash = tern_test::map_flight_hash(flight, slice);
  const bool equal = hash == tern_test::kMapFlightHash;
  print("# map hash ", hex(hash, 16), ", recorded ", hex(tern_test::kMapFlightHash, 16),
        equal ? ": equal\n" : ": DIFFERENT\n");
  return equal;
}

}  // namespace

int main() {
  print("# ", tern_board::name(), ", ", tern_board::counter_unit(), "\n# compiler ", __VERSION__, "\n");
  bool right = same_hash(1u << 30);
  right = same_hash(11) && right;
#ifdef TERN_MAP_ROWS
  print("scenario,stage,count,work,bound\n");
  right = tern_timing::print_map_rows() && right;
#endif
  return right ? 0 : 1;
}
