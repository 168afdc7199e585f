/* Copyright (c) 2026, the Tern authors
 * SPDX-License-Identifier: BSD-3-Clause */
int plan_in_library(void);

int main(void) {
  return plan_in_library();
}
