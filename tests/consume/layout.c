/* Copyright (c) 2026, the Tern authors
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * The layout as C sees it, for cxx11.cpp. */
#include "layout.h"

const layout_entry* layout_of_c(size_t* count);

static const layout_entry kLayout[] = {TERN_LAYOUT(TERN_LAYOUT_ENTRY)};

const layout_entry* layout_of_c(size_t* count) {
  *count = sizeof kLayout / sizeof *kLayout;
  return kLayout;
}
