// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "companion/depth_socket.hpp"

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace tern_companion {
namespace {

constexpr std::size_t kPortion = 1 << 18;
constexpr std::uint64_t kBytes[] = {0, 2, 4, 12};  // of a number or point, by format

}  // namespace

std::string depth_header_fault(const tern_depth_header& h) {
  if (h.magic != TERN_DEPTH_MAGIC) return "no frame begins here: the sender is out of step, or speaks another format";
  if (h.version != TERN_DEPTH_VERSION || h.header_bytes != sizeof h) {
    return "the sender has version " + std::to_string(h.version) + " of the format, with headers of " +
           std::to_string(h.header_bytes) + " bytes, and this program has version " +
           std::to_string(TERN_DEPTH_VERSION) + " with " + std::to_string(sizeof h) +
           ": compile the sender with this program's depth_format.h";
  }
  if (h.sensor >= kMostSensors) return "sensor " + std::to_string(h.sensor) + ": sensors are 0 to 7";
  if (h.format < TERN_DEPTH_MILLIMETRES || h.format > TERN_DEPTH_POINTS) {
    return "format " + std::to_string(h.format) + ": known are 1 (millimetres), 2 (metres) and 3 (points)";
  }
  const std::uint64_t bytes = static_cast<std::uint64_t>(h.width) * h.height * kBytes[h.format];
  if (h.width > 65535 || h.height > 65535 || bytes != h.payload_bytes || bytes > TERN_DEPTH_MOST_BYTES || bytes == 0) {
    return "a frame of " + std::to_string(h.width) + " x " + std::to_string(h.height) + " in format " +
           std::to_string(h.format) + " has " + std::to_string(bytes) +
           " bytes, at most 33554432, and payload_bytes is " + std::to_string(h.payload_bytes);
  }
  return "";
}

DepthSocket::DepthSocket(const std::string& path, Take take, Say say)
    : path_(path), take_(std::move(take)), say_(std::move(say)) {
  sockaddr_un own{};
  own.sun_family = AF_UNIX;
  if (path.empty() || path.size() >= sizeof own.sun_path) {
    throw std::runtime_error(path + ": the path of a socket has 1 to 107 bytes");
  }
  std::copy(path.begin(), path.end(), own.sun_path);
  struct stat there {};
  if (stat(path.c_str(), &there) == 0 && S_ISSOCK(there.st_mode)) unlink(path.c_str());
  listener_ = socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  if (bind(listener_, reinterpret_cast<const sockaddr*>(&own), sizeof own) != 0 || listen(listener_, 8) != 0) {
    const std::string why = std::strerror(errno);
    close(listener_);
    throw std::runtime_error(path + ": cannot listen: " + why +
                             ". Does the folder exist, and may this user write there?");
  }
}

DepthSocket::~DepthSocket() {
  for (const Connection& connection : connections_) close(connection.descriptor);
  close(listener_);
  unlink(path_.c_str());
}

std::vector<int> DepthSocket::descriptors() const {
  std::vector<int> all{listener_};
  for (const Connection& connection : connections_) all.push_back(connection.descriptor);
  return all;
}

void DepthSocket::accept_all() {
  for (;;) {
    const int descriptor = accept4(listener_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
    if (descriptor < 0) return;
    connections_.push_back({descriptor, {}});
    say_("a sender of depth has connected");
  }
}

void DepthSocket::read() {
  accept_all();
  const auto ended = std::remove_if(connections_.begin(), connections_.end(), [this](Connection& connection) {
    if (read(connection)) return false;
    close(connection.descriptor);
    return true;
  });
  connections_.erase(ended, connections_.end());
}

/// False if the connection has ended.
bool DepthSocket::read(Connection& connection) {
  for (;;) {
    const std::size_t had = connection.waiting.size();
    connection.waiting.resize(had + kPortion);
    const ssize_t got = ::read(connection.descriptor, connection.waiting.data() + had, kPortion);
    connection.waiting.resize(had + static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
    if (got > 0) {
      if (!take_frames(connection)) return false;
      continue;
    }
    if (got < 0 && (errno == EAGAIN || errno == EINTR)) return true;
    say_("a sender of depth has gone");
    return false;
  }
}

bool DepthSocket::take_frames(Connection& connection) {
  const std::vector<std::uint8_t>& bytes = connection.waiting;
  std::size_t at = 0;
  tern_depth_header header;
  while (bytes.size() - at >= sizeof header) {
    std::memcpy(&header, bytes.data() + at, sizeof header);
    const std::string fault = depth_header_fault(header);
    if (!fault.empty()) {
      say_("a sender of depth is disconnected: " + fault);
      return false;
    }
    if (bytes.size() - at < sizeof header + header.payload_bytes) break;
    take_(header, bytes.data() + at + sizeof header);
    at += sizeof header + header.payload_bytes;
  }
  connection.waiting.erase(connection.waiting.begin(), connection.waiting.begin() + static_cast<std::ptrdiff_t>(at));
  return true;
}

}  // namespace tern_companion
