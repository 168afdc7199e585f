// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Records the first ticks of the golden flight on the board, and prints the record's bytes in hexadecimal: what an
// autopilot would save. record.py reads them.
#include <cstddef>
#include <cstdint>

#include "baremetal/board.hpp"
#include "golden/flight_run.hpp"

namespace {

using tern_board::hex;
using tern_board::print;

constexpr int kRecordedTicks = 96;
constexpr std::size_t kRoom = 128 * 1024;
constexpr std::size_t kBytesOfLine = 32;

TERN_BOARD_LARGE tern_golden::FlightMemory<20000, 28000> memory;
TERN_BOARD_LARGE std::uint8_t bytes[kRoom];
tern_golden::PillarCamera camera;

}  // namespace

int main() {
  tern::FlightRecorder recorder;
  if (recorder.begin(bytes, kRoom) != tern::Status::kOk) return 1;
  const auto look = [](const tern::FlightReport&, const tern::FlightReport&, std::uint64_t) {};
  const tern_golden::FlightTotals totals = tern_golden::fly(tern_golden::kSmallFlight, memory, camera, camera.world,
                                                            tern_board::counter, look, {kRecordedTicks, &recorder});
  std::size_t used = 0;
  if (totals.started != tern::Status::kOk || totals.committed == 0) return 1;
  if (recorder.close(&used) != tern::Status::kOk) return 1;
  for (std::size_t k = 0; k < used; ++k) {
    print(k % kBytesOfLine == 0 ? "\nrecord " : "", hex(bytes[k], 2));
  }
  print("\n");
  return 0;
}
