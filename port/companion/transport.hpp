// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How MAVLink's bytes travel: UDP or a serial port.
#ifndef TERN_COMPANION_TRANSPORT_HPP
#define TERN_COMPANION_TRANSPORT_HPP

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace tern_companion {

class Transport {
 public:
  virtual ~Transport() = default;
  /// To wait for with poll().
  virtual int descriptor() const = 0;
  /// What has come; never waits. 0: nothing more.
  virtual std::size_t receive(std::uint8_t* bytes, std::size_t room) = 0;
  /// The sender of what receive() gave last is the autopilot: send() goes there.
  virtual void keep_peer() {}
  /// Never waits. False if the bytes could not be sent whole, or nobody is known yet.
  virtual bool send(const std::vector<std::uint8_t>& bytes) = 0;
};

/// udp:PORT listens, and answers the autopilot that is heard there. udp:HOST:PORT sends to that address first.
/// serial:DEVICE:BAUD is 8N1 without flow control. Throws std::runtime_error that says what was wrong and what to do.
std::unique_ptr<Transport> open_transport(const std::string& address);

}  // namespace tern_companion

#endif
