// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_PICTURE_ENDS_HPP
#define TERN_HOST_PICTURE_ENDS_HPP

#include <vector>

#include "host/picture/canvas.hpp"

namespace tern_host {

/// Marks start and goal and names them where the names hide least of `way` (a chain of pixels, may be empty), inside
/// `frame` where that can be, and clear of all text drawn so far. Ends in one place share a mark and a name.
void draw_end_marks(Canvas& canvas, const Rect& frame, Pixel start, Pixel goal, const std::vector<Pixel>& way);

/// Marks those vias that the frame shows with their numbers, from 1.
void draw_via_marks(Canvas& canvas, const Rect& frame, const std::vector<Pixel>& vias);

}  // namespace tern_host

#endif
