// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_PORT_BAREMETAL_AARCH64_COUNTERS_HPP
#define TERN_PORT_BAREMETAL_AARCH64_COUNTERS_HPP

#include <cstdint>

namespace tern_board {

/// Instructions retired since start-up (PMU event 0x08), widened to 64 bits; read it at least every 2^31 of them, for
/// QEMU sees a 32-bit counter's overflow only where its top bit fell between two readings.
std::uint64_t instructions() noexcept;

/// Processor cycles since start-up (PMCCNTR_EL0). Under -icount shift=0 the same as instructions; on a chip, time.
std::uint64_t cycles() noexcept;

}  // namespace tern_board

#endif
