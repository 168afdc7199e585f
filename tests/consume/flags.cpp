// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The self-test under a flight stack's flags: it must find exactly TERN_EXPECTED_FAULTS.
#include <stdint.h>
#include <stdio.h>

#include "tern/self_test.hpp"

int main() {
  using namespace tern;
  const uint32_t expected = TERN_EXPECTED_FAULTS;
  uint32_t faults = ~uint32_t{0};
  const bool healthy = self_test(configuration_hash(), &faults) == Status::kOk;
  printf("faults 0x%x, expected 0x%x\n", static_cast<unsigned>(faults), static_cast<unsigned>(expected));
  return faults == expected && healthy == (expected == 0) ? 0 : 1;
}
