// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How much room text takes. A picture does not know the reader's font, so widths are those of DejaVu Sans, the widest
// of the fonts that a document names.
#ifndef TERN_HOST_PICTURE_LETTERING_HPP
#define TERN_HOST_PICTURE_LETTERING_HPP

#include <string>
#include <vector>

namespace tern_host {

/// A text class of the style sheet.
struct Font {
  const char* name;
  double size;  ///< pixels
  bool bold;
};

constexpr Font kTitle{"title", 27.0, true};
constexpr Font kSubtitle{"subtitle", 15.0, false};
constexpr Font kHeading{"heading", 16.0, true};
constexpr Font kLabel{"label", 14.0, false};
constexpr Font kNumber{"number", 13.0, false};
constexpr Font kFigure{"figure", 20.0, true};
constexpr Font kFigureName{"figure-name", 13.0, false};
constexpr Font kEndName{"end-name", 14.0, true};
constexpr Font kThingName{"thing-name", 12.0, true};
constexpr Font kFonts[] = {kTitle, kSubtitle, kHeading, kLabel, kNumber, kFigure, kFigureName, kEndName, kThingName};

/// Width of a UTF-8 text in pixels.
double text_width(const std::string& text, const Font& font);

/// The text, shortened with an ellipsis where it is wider than `width`.
std::string fit_text(const std::string& text, const Font& font, double width);

/// The text's words in lines of at most `width`; a longer word is shortened.
std::vector<std::string> wrap_text(const std::string& text, const Font& font, double width);

}  // namespace tern_host

#endif
