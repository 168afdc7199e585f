// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Packets over UDP on the loopback interface, as lossy and late as the settings of links say.
#ifndef TERN_HOST_SWARM_SOCKET_CARRIER_HPP
#define TERN_HOST_SWARM_SOCKET_CARRIER_HPP

#include <netinet/in.h>

#include <vector>

#include "host/swarm/links.hpp"

namespace tern_host {

/// A socket at a free port of the loopback interface, which is not waited for.
struct LoopbackSocket {
  int descriptor = -1;
  sockaddr_in address{};
};
/// Throws std::runtime_error if there is none.
LoopbackSocket open_loopback_socket();

/// One vehicle's end: it sends to the sockets of all others.
class SocketCarrier : public Carrier {
 public:
  SocketCarrier(const LinkSettings& settings, std::vector<LoopbackSocket> sockets, std::uint64_t seed);
  void send(int from, const Packet& packet, std::int64_t now) override;
  std::vector<Packet> receive(int to, std::int64_t now) override;
  const Links& air() const { return air_; }

 private:
  void release(int from, std::int64_t now);

  Links air_;  ///< what is lost on the way, and what is still on it
  std::vector<LoopbackSocket> sockets_;
};

}  // namespace tern_host

#endif
