// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HALFSPACE_HPP
#define TERN_HALFSPACE_HPP

#include "tern/vec3.hpp"

namespace tern {

/// The set normal . p <= offset.
struct Halfspace {
  Vec3 normal;  ///< of length 1 in all that Tern gives out; whoever asks for one says what it accepts
  double offset;
};

}  // namespace tern

#endif
