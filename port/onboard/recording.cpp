// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tern_onboard/recording.hpp"

#include <utility>

namespace tern_onboard {

void Recording::begin(std::int64_t now) {
  if (buffer_.empty()) return;
  put_away();
  begun_ = now;
  recorder_.begin(buffer_.data(), buffer_.size());
}

void Recording::end() {
  put_away();
  recorder_ = {};
}

std::vector<RecordPart> Recording::take() {
  put_away();
  return std::exchange(parts_, {});
}

void Recording::put_away() {
  std::size_t bytes = 0;
  if (recorder_.pending() == 0 || recorder_.close(&bytes) != tern::Status::kOk) return;
  parts_.push_back({begun_, {buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(bytes)}});
  recorder_.clear();
}

}  // namespace tern_onboard
