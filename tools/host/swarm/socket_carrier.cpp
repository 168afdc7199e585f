// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/swarm/socket_carrier.hpp"

#include <fcntl.h>
#include <sys/socket.h>

#include <stdexcept>
#include <utility>

namespace tern_host {
namespace {

constexpr std::size_t kLargestPacket = 65536;

}  // namespace

LoopbackSocket open_loopback_socket() {
  LoopbackSocket made;
  made.descriptor = socket(AF_INET, SOCK_DGRAM, 0);
  made.address.sin_family = AF_INET;
  made.address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  auto* const address = reinterpret_cast<sockaddr*>(&made.address);
  socklen_t size = sizeof made.address;
  const bool is_open = made.descriptor >= 0 && fcntl(made.descriptor, F_SETFL, O_NONBLOCK) == 0 &&
                       bind(made.descriptor, address, size) == 0 && getsockname(made.descriptor, address, &size) == 0;
  if (!is_open) throw std::runtime_error("no UDP socket on the loopback interface");
  return made;
}

SocketCarrier::SocketCarrier(const LinkSettings& settings, std::vector<LoopbackSocket> sockets, std::uint64_t seed)
    : air_(settings, static_cast<int>(sockets.size()), seed), sockets_(std::move(sockets)) {}

/// Hands over to the network what has been on its way long enough. A full buffer is a loss like any other.
void SocketCarrier::release(int from, std::int64_t now) {
  for (std::size_t to = 0; to < sockets_.size(); ++to) {
    for (const Packet& packet : air_.receive(static_cast<int>(to), now)) {
      sendto(sockets_[static_cast<std::size_t>(from)].descriptor, packet.data(), packet.size(), 0,
             reinterpret_cast<const sockaddr*>(&sockets_[to].address), sizeof sockets_[to].address);
    }
  }
}

void SocketCarrier::send(int from, const Packet& packet, std::int64_t now) {
  air_.send(from, packet, now);
  release(from, now);
}

std::vector<Packet> SocketCarrier::receive(int to, std::int64_t now) {
  release(to, now);
  std::vector<Packet> arrived;
  std::vector<std::uint8_t> packet(kLargestPacket);
  for (;;) {
    const ssize_t size = recv(sockets_[static_cast<std::size_t>(to)].descriptor, packet.data(), packet.size(), 0);
    if (size <= 0) return arrived;
    arrived.emplace_back(std::vector<std::uint8_t>(packet.begin(), packet.begin() + size));
  }
}

}  // namespace tern_host
