// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A program compiled and linked with -ffast-math around the core. The linker's start-up turned flush-to-zero on: the
// self-test must say so, and nothing else may be wrong with the core.
#include <cstdint>
#include <cstdio>

#include "tern/tern.hpp"

int main() {
  std::uint32_t faults = 0;
  const tern::Status status = tern::self_test(tern::configuration_hash(), &faults);
  std::printf("self-test under -ffast-math: %s, faults 0x%x\n", tern::status_name(status),
              static_cast<unsigned>(faults));
  return status == tern::Status::kSelfTestFailed && faults == tern::kFaultFlushToZero ? 0 : 1;
}
