// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/picture/canvas.hpp"

#include <algorithm>

#include "host/number.hpp"
#include "host/picture/lettering.hpp"

namespace tern_host {
namespace {

std::string attribute(const char* name, double value) {
  return std::string(" ") + name + "=\"" + fixed(value, 2) + "\"";
}

std::string point_list(const std::vector<Pixel>& points) {
  std::string list;
  for (const Pixel& p : points) list += (list.empty() ? "" : " ") + fixed(p.x, 2) + "," + fixed(p.y, 2);
  return " points=\"" + list + "\"";
}

std::string box_attributes(const Rect& r) {
  return attribute("x", r.x) + attribute("y", r.y) + attribute("width", r.width) + attribute("height", r.height);
}

bool has(const std::string& style, const std::string& attribute) {
  return style.find(attribute) != std::string::npos;
}

const Font& font_of(const std::string& style) {
  for (const Font& font : kFonts) {
    if (has(style, std::string("class=\"") + font.name + "\"")) return font;
  }
  return kSubtitle;
}

/// Of a baseline's letters: what stands above it and what hangs below, in parts of the font's size.
constexpr double kAscent = 0.78;
constexpr double kDescent = 0.22;

}  // namespace

Rect text_room(Pixel at, const std::string& text, const std::string& style) {
  const Font& font = font_of(style);
  const double width = text_width(text, font);
  const double before = has(style, "\"middle\"") ? 0.5 * width : (has(style, "\"end\"") ? width : 0.0);
  return {at.x - before, at.y - kAscent * font.size, width, (kAscent + kDescent) * font.size};
}

std::string escape(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        if (static_cast<unsigned char>(c) >= 0x20) out += c;
    }
  }
  return out;
}

void Canvas::rect(const Rect& rect, const std::string& style, double corner_radius) {
  body_ += "<rect" + box_attributes(rect) + (corner_radius > 0.0 ? attribute("rx", corner_radius) : "") + " " + style +
           "/>\n";
}

void Canvas::line(Pixel from, Pixel to, const std::string& style) {
  body_ += "<line" + attribute("x1", from.x) + attribute("y1", from.y) + attribute("x2", to.x) + attribute("y2", to.y) +
           " " + style + "/>\n";
}

void Canvas::polyline(const std::vector<Pixel>& points, const std::string& style) {
  body_ += "<polyline" + point_list(points) + " fill=\"none\" " + style + "/>\n";
}

void Canvas::polygon(const std::vector<Pixel>& points, const std::string& style) {
  body_ += "<polygon" + point_list(points) + " " + style + "/>\n";
}

void Canvas::circle(Pixel center, double radius, const std::string& style) {
  body_ +=
      "<circle" + attribute("cx", center.x) + attribute("cy", center.y) + attribute("r", radius) + " " + style + "/>\n";
}

void Canvas::text(Pixel at, const std::string& text, const std::string& style) {
  texts_.push_back(text_room(at, text, style));
  body_ += "<text" + attribute("x", at.x) + attribute("y", at.y) + " " + style + ">" + escape(text) + "</text>\n";
}

void Canvas::upward_text(Pixel at, const std::string& text, const std::string& style) {
  const std::string turned = " transform=\"rotate(-90 " + fixed(at.x, 2) + " " + fixed(at.y, 2) + ")\"";
  this->text(at, text, style + " text-anchor=\"middle\"" + turned);
  const Rect level = texts_.back();
  texts_.back() = {at.x + level.y - at.y, at.y - 0.5 * level.width, level.height, level.width};
}

bool Canvas::clear_of_text(const Rect& rect) const {
  return std::none_of(texts_.begin(), texts_.end(), [&](const Rect& text) { return text.overlaps(rect); });
}

void Canvas::begin_clipped(const Rect& rect) {
  const std::string id = "clip" + std::to_string(++clips_);
  body_ += "<clipPath id=\"" + id + "\"><rect" + box_attributes(rect) + "/></clipPath>\n<g clip-path=\"url(#" + id +
           ")\">\n";
}

void Canvas::end_group() {
  body_ += "</g>\n";
}

void Canvas::raw(const std::string& element) {
  body_ += element;
}

std::string Canvas::document(double width, double height, const std::string& style_sheet) const {
  const std::string size = fixed(width, 0) + " " + fixed(height, 0);
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + size + "\" font-family=\"Inter, 'Helvetica " +
         "Neue', Helvetica, Arial, 'DejaVu Sans', sans-serif\">\n<style>\n" + style_sheet + "</style>\n" + body_ +
         "</svg>\n";
}

}  // namespace tern_host
