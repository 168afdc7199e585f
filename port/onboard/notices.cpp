// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tern_onboard/notices.hpp"

#include <algorithm>
#include <cstdio>
#include <utility>

namespace tern_onboard {
namespace {

constexpr std::int64_t kQuiet = 1000000000;  // ns: how long it must be good before it counts as good
constexpr std::size_t kMostLines = 1000;     // if nobody takes them

}  // namespace

std::string metres(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f m", value);
  return text;
}

std::string milliseconds(std::int64_t ns) {
  return std::to_string(ns / 1000000) + " ms";
}

const char* fault_name(Fault fault) {
  static const char* const kNames[kFaults] = {
      "pose_invalid", "pose_repeated", "pose_backward", "pose_ahead",     "pose_old",       "pose_jump",
      "heading_jump", "pose_lost",     "frame_invalid", "frame_unready",  "frame_repeated", "frame_backward",
      "frame_ahead",  "frame_old",     "frame_no_pose", "frame_replaced", "frame_refused",  "ticks_skipped",
      "clock_back",   "strayed",       "lost",          "refused",        "thing_invalid",  "thing_backward",
      "thing_ahead",  "thing_old",     "things_full"};
  return kNames[static_cast<std::size_t>(fault)];
}

void Notices::bad(Fault fault, int subject, std::int64_t now, const std::string& text) {
  count(fault);
  for (Said& said : said_) {
    if (said.fault != fault || said.subject != subject) continue;
    said.last = now;
    return;
  }
  said_.push_back({fault, subject, now});
  if (lines_.size() < kMostLines) lines_.push_back({true, text});
}

void Notices::good(Fault first, Fault last, int subject, std::int64_t now, const char* text) {
  const auto ended = [&](const Said& said) {
    // A clock that went back ends all waiting.
    const bool quiet = now - said.last > kQuiet || now < said.last;
    return said.subject == subject && said.fault >= first && said.fault <= last && quiet;
  };
  const auto from = std::remove_if(said_.begin(), said_.end(), ended);
  if (from == said_.end()) return;
  said_.erase(from, said_.end());
  say(text);
}

std::vector<Notice> Notices::take() {
  return std::exchange(lines_, {});
}

}  // namespace tern_onboard
