// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_PICTURE_CANVAS_HPP
#define TERN_HOST_PICTURE_CANVAS_HPP

#include <string>
#include <vector>

namespace tern_host {

/// A point of the picture: pixels, y downwards.
struct Pixel {
  double x;
  double y;
};

struct Rect {
  double x;
  double y;
  double width;
  double height;

  double right() const { return x + width; }
  double bottom() const { return y + height; }
  bool overlaps(const Rect& other) const {
    return x < other.right() && other.x < right() && y < other.bottom() && other.y < bottom();
  }
  bool holds(const Pixel& p) const { return x <= p.x && p.x <= right() && y <= p.y && p.y <= bottom(); }
};

/// Collects SVG elements. `style` arguments are further attributes, e.g. `class="grid"` or `fill="#fff"`.
class Canvas {
 public:
  void rect(const Rect& rect, const std::string& style, double corner_radius = 0.0);
  void line(Pixel from, Pixel to, const std::string& style);
  void polyline(const std::vector<Pixel>& points, const std::string& style);
  void polygon(const std::vector<Pixel>& points, const std::string& style);
  void circle(Pixel center, double radius, const std::string& style);
  void text(Pixel at, const std::string& text, const std::string& style);
  /// Text that reads upwards, `at` the middle of its baseline.
  void upward_text(Pixel at, const std::string& text, const std::string& style);
  /// No text so far stands in `rect`.
  bool clear_of_text(const Rect& rect) const;
  /// Elements up to end_group() show inside `rect` only.
  void begin_clipped(const Rect& rect);
  void end_group();
  /// A raw element, for definitions.
  void raw(const std::string& element);

  /// The elements so far.
  const std::string& body() const { return body_; }
  /// The whole document.
  std::string document(double width, double height, const std::string& style_sheet) const;

 private:
  std::string body_;
  std::vector<Rect> texts_;  // the rooms of all text so far
  int clips_ = 0;
};

/// The room that text takes: its class among kFonts, its `text-anchor` start, middle or end, as `style` says.
Rect text_room(Pixel at, const std::string& text, const std::string& style);

/// Text with the five characters that XML reserves written as entities and control characters left out.
std::string escape(const std::string& text);

}  // namespace tern_host

#endif
