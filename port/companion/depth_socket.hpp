// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The socket to which drivers send frames of depth (senders/depth_format.h).
#ifndef TERN_COMPANION_DEPTH_SOCKET_HPP
#define TERN_COMPANION_DEPTH_SOCKET_HPP

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "companion/senders/depth_format.h"

namespace tern_companion {

constexpr std::uint32_t kMostSensors = 8;

/// Empty; or what is wrong with a header, and what to do.
std::string depth_header_fault(const tern_depth_header& header);

/// Never waits. A connection that sends what is no frame is closed, since the next one cannot be found in it.
class DepthSocket {
 public:
  using Take = std::function<void(const tern_depth_header&, const std::uint8_t* payload)>;
  using Say = std::function<void(const std::string&)>;

  /// Listens at `path`; a socket that is left there from before is replaced. Throws std::runtime_error.
  DepthSocket(const std::string& path, Take take, Say say);
  ~DepthSocket();
  DepthSocket(const DepthSocket&) = delete;
  DepthSocket& operator=(const DepthSocket&) = delete;

  /// To wait for with poll().
  std::vector<int> descriptors() const;
  /// Takes all that has come.
  void read();

 private:
  struct Connection {
    int descriptor;
    std::vector<std::uint8_t> waiting;
  };
  void accept_all();
  bool read(Connection& connection);
  bool take_frames(Connection& connection);

  std::string path_;
  Take take_;
  Say say_;
  int listener_ = -1;
  std::vector<Connection> connections_;
};

}  // namespace tern_companion

#endif
