/* Copyright (c) 2026, the Tern authors
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * docs/integration.md: what a C program asks before it plans. */
#include "tern/tern.h"

int main(void) {
  if (tern_abi() != TERN_ABI || tern_size_of(TERN_SIZE_TRAJECTORY) != sizeof(tern_trajectory) ||
      tern_self_test(tern_header_hash(), NULL) != 0) { /* do not fly */
    return 1;
  }
  return 0;
}
