// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "companion/transport.hpp"

#include <fcntl.h>
#include <netdb.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace tern_companion {
namespace {

[[noreturn]] void refuse(const std::string& address, const std::string& why) {
  throw std::runtime_error(address + ": " + why);
}

/// A number in a text of digits, 1 .. most; 0 for anything else.
long number(const std::string& text, long most) {
  if (text.empty() || text.size() > 9 || text.find_first_not_of("0123456789") != std::string::npos) return 0;
  const long value = std::stol(text);
  return value <= most ? value : 0;
}

class Udp : public Transport {
 public:
  Udp(const std::string& address, const std::string& host, long port) {
    socket_ = socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    if (host.empty()) {
      sockaddr_in own{};
      own.sin_family = AF_INET;
      own.sin_port = htons(static_cast<std::uint16_t>(port));
      own.sin_addr.s_addr = INADDR_ANY;
      if (::bind(socket_, reinterpret_cast<const sockaddr*>(&own), sizeof own) != 0) {
        refuse(address, std::string("cannot listen: ") + std::strerror(errno) + ". Does another program use the port?");
      }
      return;
    }
    addrinfo hints{};
    hints.ai_family = AF_INET;
    hints.ai_socktype = SOCK_DGRAM;
    addrinfo* found = nullptr;
    if (getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &found) != 0) {
      refuse(address, "there is no host " + host);
    }
    std::memcpy(&peer_, found->ai_addr, sizeof peer_);
    freeaddrinfo(found);
  }
  ~Udp() override { ::close(socket_); }
  Udp(const Udp&) = delete;
  Udp& operator=(const Udp&) = delete;

  int descriptor() const override { return socket_; }
  std::size_t receive(std::uint8_t* bytes, std::size_t room) override {
    socklen_t length = sizeof last_;
    const ssize_t got = recvfrom(socket_, bytes, room, 0, reinterpret_cast<sockaddr*>(&last_), &length);
    return got > 0 ? static_cast<std::size_t>(got) : 0;
  }
  void keep_peer() override { peer_ = last_; }
  bool send(const std::vector<std::uint8_t>& bytes) override {
    if (peer_.sin_port == 0) return false;
    const ssize_t sent =
        sendto(socket_, bytes.data(), bytes.size(), 0, reinterpret_cast<const sockaddr*>(&peer_), sizeof peer_);
    return sent == static_cast<ssize_t>(bytes.size());
  }

 private:
  int socket_ = -1;
  sockaddr_in last_{};
  sockaddr_in peer_{};  // port 0: nobody yet
};

struct Baud {
  long rate;
  speed_t code;
};
constexpr Baud kBauds[] = {{57600, B57600},     {115200, B115200},  {230400, B230400},   {460800, B460800},
                           {500000, B500000},   {921600, B921600},  {1000000, B1000000}, {1500000, B1500000},
                           {2000000, B2000000}, {3000000, B3000000}};

class Serial : public Transport {
 public:
  Serial(const std::string& address, const std::string& device, long rate) {
    const Baud* chosen = nullptr;
    for (const Baud& baud : kBauds) {
      if (baud.rate == rate) chosen = &baud;
    }
    if (chosen == nullptr) refuse(address, "no such rate; 57600 to 3000000 baud are known, such as 921600");
    port_ = ::open(device.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    if (port_ < 0) {
      refuse(address, std::string("cannot open ") + device + ": " + std::strerror(errno) +
                          ". On Debian, users of serial ports are in the group dialout");
    }
    termios mode{};
    if (tcgetattr(port_, &mode) != 0) refuse(address, device + " is no serial port");
    cfmakeraw(&mode);
    mode.c_cflag |= CLOCAL | CREAD;
    mode.c_cflag &= ~static_cast<tcflag_t>(CSTOPB | CRTSCTS);
    cfsetispeed(&mode, chosen->code);
    cfsetospeed(&mode, chosen->code);
    if (tcsetattr(port_, TCSANOW, &mode) != 0) refuse(address, device + " refuses this rate");
  }
  ~Serial() override { ::close(port_); }
  Serial(const Serial&) = delete;
  Serial& operator=(const Serial&) = delete;

  int descriptor() const override { return port_; }
  std::size_t receive(std::uint8_t* bytes, std::size_t room) override {
    const ssize_t got = ::read(port_, bytes, room);
    return got > 0 ? static_cast<std::size_t>(got) : 0;
  }
  /// What the port has no room for is dropped: half a frame costs the frame, never the next one.
  bool send(const std::vector<std::uint8_t>& bytes) override {
    return ::write(port_, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size());
  }

 private:
  int port_ = -1;
};

}  // namespace

std::unique_ptr<Transport> open_transport(const std::string& address) {
  const std::size_t colon = address.find(':');
  const std::string kind = address.substr(0, colon);
  const std::string rest = colon == std::string::npos ? "" : address.substr(colon + 1);
  const std::size_t last = rest.rfind(':');
  const std::string first = last == std::string::npos ? "" : rest.substr(0, last);
  const std::string second = last == std::string::npos ? rest : rest.substr(last + 1);
  if (kind == "udp") {
    const long port = number(second, 65535);
    if (port > 0) return std::make_unique<Udp>(address, first, port);
  }
  if (kind == "serial" && !first.empty()) return std::make_unique<Serial>(address, first, number(second, 4000000));
  refuse(address, "not an address; write udp:PORT, udp:HOST:PORT or serial:DEVICE:BAUD");
}

}  // namespace tern_companion
