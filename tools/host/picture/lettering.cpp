// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/picture/lettering.hpp"

#include <sstream>

namespace tern_host {
namespace {

constexpr double kBoldFactor = 1.12;

struct LetterClass {
  const char* letters;
  double width;  // of the font's size
};

constexpr LetterClass kLetterClasses[] = {
    {"ijl'", 0.28},
    {" .,:;|/!ft", 0.37},
    {"-()r\"", 0.42},
    {"0123456789", 0.64},
    {"mMwW@", 0.99},
    {"%+=<>GOQDHNU&#~^", 0.85},
    {"ABCEFIJKLPRSTVXYZ", 0.70},
};
constexpr double kOtherAscii = 0.62;
constexpr double kTwoByteLetter = 0.65;
constexpr double kLongerLetter = 1.0;

/// Bytes of UTF-8 beyond the first of a letter.
bool continues(char c) {
  return (static_cast<unsigned char>(c) & 0xC0) == 0x80;
}

double letter_width(char c) {
  const unsigned char byte = static_cast<unsigned char>(c);
  if (byte >= 0xE0) return kLongerLetter;
  if (byte >= 0x80) return kTwoByteLetter;
  for (const LetterClass& letters : kLetterClasses) {
    if (std::string(letters.letters).find(c) != std::string::npos) return letters.width;
  }
  return kOtherAscii;
}

}  // namespace

double text_width(const std::string& text, const Font& font) {
  double width = 0.0;
  for (const char c : text) width += continues(c) ? 0.0 : letter_width(c);
  return width * font.size * (font.bold ? kBoldFactor : 1.0);
}

std::string fit_text(const std::string& text, const Font& font, double width) {
  if (text_width(text, font) <= width) return text;
  const std::string ellipsis = "\u2026";
  std::size_t length = text.size();
  while (length > 0 && (continues(text[length]) || text_width(text.substr(0, length) + ellipsis, font) > width)) {
    --length;
  }
  return text.substr(0, length) + ellipsis;
}

std::vector<std::string> wrap_text(const std::string& text, const Font& font, double width) {
  std::vector<std::string> lines;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (!lines.empty() && text_width(lines.back() + " " + word, font) <= width) {
      lines.back() += " " + word;
    } else {
      lines.push_back(fit_text(word, font, width));
    }
  }
  return lines;
}

}  // namespace tern_host
