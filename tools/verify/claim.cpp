// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "verify/claim.hpp"

#include <algorithm>

namespace tern_verify {
namespace {

constexpr std::size_t kVerdictWidth = 9;
constexpr std::size_t kWhatWidth = 35;

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(text.size() + 1, width), ' ');
  return text;
}

}  // namespace

const char* verdict_word(Verdict verdict) {
  switch (verdict) {
    case Verdict::kProven:
      return "proven";
    case Verdict::kRefuted:
      return "REFUTED";
    case Verdict::kOpen:
      break;
  }
  return "OPEN";
}

Verdict verdict_of(const Claims& claims) {
  Verdict worst = claims.empty() ? Verdict::kOpen : Verdict::kProven;
  for (const Claim& claim : claims) {
    const Verdict verdict = claim.verdict();
    if (verdict == Verdict::kRefuted) return verdict;
    if (verdict == Verdict::kOpen) worst = verdict;
  }
  return worst;
}

std::string line_of(const Claim& claim) {
  const Verdict verdict = claim.verdict();
  std::string line = padded(verdict_word(verdict), kVerdictWidth) + padded(claim.what, kWhatWidth);
  line += "margin " + text_below(claim.least) + " " + claim.unit;
  if (verdict == Verdict::kRefuted) {
    line += ", beyond the tolerance by " + text_below(-claim.most - claim.tolerance) + " " + claim.unit;
  }
  if (verdict == Verdict::kOpen) line += " is what is proven, and may be " + text_above(claim.most) + " " + claim.unit;
  if (claim.tolerance > 0) line += ", tolerance " + text_below(claim.tolerance);
  if (!claim.place.empty()) line += "; " + claim.place;
  return line;
}

}  // namespace tern_verify
