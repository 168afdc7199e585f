/* Copyright (c) 2026, the Tern authors
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Records of planning queries, in C99: the writing half of tern/record.hpp, which explains them. */
#ifndef TERN_TERN_RECORD_H
#define TERN_TERN_RECORD_H

#include "tern/tern.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Bytes that are enough for any request on a grid of these dimensions; 0 if they are out of range. */
size_t tern_plan_record_bytes(tern_voxel dims);
/* Writes the record of a query and its answer. ok, record_full, or invalid_argument. */
uint8_t tern_record_plan(const tern_grid* grid, const tern_request* request, uint8_t status,
                         const tern_trajectory* plan, uint8_t* bytes, size_t room, size_t* used);

#ifdef __cplusplus
}
#endif

#endif
