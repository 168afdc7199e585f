// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/picture/canvas.hpp"

#include "host/number.hpp"

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

}  // namespace

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
  body_ += "<text" + attribute("x", at.x) + attribute("y", at.y) + " " + style + ">" + escape(text) + "</text>\n";
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
