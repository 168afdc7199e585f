// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Newlib's square root of a double, which this FPU does not have, writes here where its argument is negative. Tern's
// never is.
extern "C" int* __errno() {
  static int value;
  return &value;
}
