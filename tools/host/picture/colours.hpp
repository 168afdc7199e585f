// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_PICTURE_COLOURS_HPP
#define TERN_HOST_PICTURE_COLOURS_HPP

#include <string>

namespace tern_host {

/// Steps that a speed's colour is rounded to, so that runs of one colour are drawn as one line.
constexpr int kColourSteps = 48;

/// The colour of part `t` in [0, 1] of the speed scale, from dark blue over magenta to amber: dark to light without
/// leaving what shows on white, and told apart by the colour-blind. "#rrggbb".
std::string speed_colour(double t);

/// The colours of x, y and z in the profiles.
constexpr const char* kAxisColours[3] = {"#c8553d", "#2f8f5b", "#2b6cb0"};

/// The colour of the horizontal norm, where that is limited.
constexpr const char* kHorizontalColour = "#7b3fa0";

/// The classes that all drawing code refers to.
std::string style_sheet();

}  // namespace tern_host

#endif
