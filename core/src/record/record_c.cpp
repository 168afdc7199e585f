// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstddef>
#include <cstdint>

#include "grid/grid_handle.hpp"
#include "tern/record.hpp"
#include "tern/tern_record.h"

extern "C" {

std::size_t tern_plan_record_bytes(tern_voxel dims) {
  return tern::plan_record_bytes(dims);
}

std::uint8_t tern_record_plan(const tern_grid* grid, const tern_request* request, std::uint8_t status,
                              const tern_trajectory* plan, std::uint8_t* bytes, std::size_t room, std::size_t* used) {
  const bool complete = grid != nullptr && request != nullptr && plan != nullptr;
  const tern::Status answer = complete ? tern::record_plan(tern::object(grid), *request,
                                                           static_cast<tern::Status>(status), *plan, bytes, room, used)
                                       : tern::Status::kInvalidArgument;
  return static_cast<std::uint8_t>(answer);
}
}
