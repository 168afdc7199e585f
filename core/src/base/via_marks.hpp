// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_BASE_VIA_MARKS_HPP
#define TERN_BASE_VIA_MARKS_HPP

#include <cstdint>

#include "tern/config.hpp"

namespace tern {

/// Where a plan passes its vias, in order.
struct ViaMarks {
  std::int32_t count;
  std::int32_t waypoint[kMaxVias];    ///< index of the via's waypoint in the path; increasing
  std::int32_t polyhedron[kMaxVias];  ///< index of the corridor's polyhedron that begins at the via; increasing
};

}  // namespace tern

#endif
