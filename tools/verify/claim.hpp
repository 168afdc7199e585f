// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the verifier says of a plan: one claim for each thing that is to be proven.
#ifndef TERN_VERIFY_CLAIM_HPP
#define TERN_VERIFY_CLAIM_HPP

#include <string>
#include <vector>

#include "verify/exact.hpp"

namespace tern_verify {

enum class Verdict { kProven, kRefuted, kOpen };

/// A margin is what is left of a limit, or of a distance beyond what is asked for; below 0, the plan needs a tolerance.
struct Claim {
  std::string what;
  std::string unit;
  Rational least;      ///< the margin is proven to be at least this
  Rational most;       ///< and some point of the plan has no more than this
  Rational tolerance;  ///< >= 0: what docs/proof.md allows the plan to go beyond
  std::string place;   ///< where the margin is least

  /// kOpen only where `most` would keep the tolerance and `least` would not.
  Verdict verdict() const {
    if (least >= -tolerance) return Verdict::kProven;
    return most < -tolerance ? Verdict::kRefuted : Verdict::kOpen;
  }
};

using Claims = std::vector<Claim>;

/// "proven", "REFUTED" or "OPEN".
const char* verdict_word(Verdict verdict);

/// The verdict on all claims together: the worst of them. No claims prove nothing.
Verdict verdict_of(const Claims& claims);

/// One line: verdict, claim, least margin, tolerance and place; and for what is refuted, by how much.
std::string line_of(const Claim& claim);

/// A claim under construction: the tightest of many margins, each with the tolerance that holds for it.
class Tightest {
 public:
  Tightest(std::string what, std::string unit) : claim_{std::move(what), std::move(unit), 0, 0, 0, ""} {}

  /// A margin that is exactly `margin`. `place` makes the text where it is needed.
  template <typename Place>
  void note(const Rational& margin, const Rational& tolerance, Place place) {
    const Rational room = margin + tolerance;
    if (noted_ && room >= room_) return;
    noted_ = true;
    room_ = room;
    claim_.least = claim_.most = margin;
    claim_.tolerance = tolerance;
    claim_.place = place();
  }

  bool noted() const { return noted_; }
  const Claim& claim() const { return claim_; }

 private:
  Claim claim_;
  Rational room_;
  bool noted_ = false;
};

}  // namespace tern_verify

#endif
