// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <uORB/uORB.h>

namespace uORB {

class Subscription {
 public:
  explicit Subscription(const orb_metadata* topic, uint8_t instance = 0) : topic_(topic), instance_(instance) {}
  bool copy(void* message) { return orb_copy(topic_, instance_, message); }
  /// Copies a message that is new to this subscription.
  bool update(void* message) {
    const unsigned sent = orb_sent(topic_, instance_);
    if (sent == seen_) return false;
    seen_ = sent;
    return copy(message);
  }

 private:
  const orb_metadata* topic_;
  uint8_t instance_;
  unsigned seen_ = 0;
};

}  // namespace uORB
