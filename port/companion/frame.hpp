// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Frames of MAVLink 2 in a stream of bytes. Signatures are not supported: a signed frame is passed over and counted.
#ifndef TERN_COMPANION_FRAME_HPP
#define TERN_COMPANION_FRAME_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

#include "companion/messages.hpp"

namespace tern_companion {

/// A frame's content. Bytes of the payload that the wire left out are 0.
struct Frame {
  std::uint8_t sequence = 0, system = 0, component = 0;
  std::uint32_t id = 0;
  std::array<std::uint8_t, 255> payload{};
};

/// Who sends, and its next sequence number.
struct Sender {
  std::uint8_t system = 1, component = kCompanionComponent;
  std::uint8_t sequence = 0;
};

/// What a reader met.
struct FrameCounts {
  std::uint64_t frames = 0;        ///< good ones of known messages
  std::uint64_t unknown = 0;       ///< frames of other messages
  std::uint64_t bad_checksum = 0;  ///< frames with a wrong checksum or with a flag that no one knows
  std::uint64_t version_1 = 0;     ///< good frames of MAVLink 1, which are not used
  std::uint64_t with_signature = 0;
};

/// Finds frames in bytes that come in any portions.
class FrameReader {
 public:
  void feed(const std::uint8_t* bytes, std::size_t count) { waiting_.insert(waiting_.end(), bytes, bytes + count); }
  /// The next good frame of a known message. False if there is none yet.
  bool next(Frame& frame);
  const FrameCounts& counts() const { return counts_; }

 private:
  bool read(std::size_t at, std::size_t& taken, Frame& frame);

  std::vector<std::uint8_t> waiting_;
  FrameCounts counts_;
};

/// A frame of `id` for the wire.
std::vector<std::uint8_t> frame_bytes(Sender& sender, std::uint32_t id, const std::uint8_t* payload, std::size_t size);

/// Numbers in little-endian order, one after the other.
class FieldWriter {
 public:
  template <class... Fields>
  void operator()(const Fields&... fields) {
    (put(fields), ...);
  }
  const std::vector<std::uint8_t>& bytes() const { return bytes_; }

 private:
  template <class T>
  void put(const T& value) {
    static_assert(std::is_arithmetic_v<T>);
    std::uint8_t raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    bytes_.insert(bytes_.end(), raw, raw + sizeof value);
  }
  template <class T, std::size_t N>
  void put(const std::array<T, N>& values) {
    for (const T& value : values) put(value);
  }
  std::vector<std::uint8_t> bytes_;
};

class FieldReader {
 public:
  explicit FieldReader(const std::uint8_t* bytes) : at_(bytes) {}
  template <class... Fields>
  void operator()(Fields&... fields) {
    (take(fields), ...);
  }

 private:
  template <class T>
  void take(T& value) {
    std::memcpy(&value, at_, sizeof value);
    at_ += sizeof value;
  }
  template <class T, std::size_t N>
  void take(std::array<T, N>& values) {
    for (T& value : values) take(value);
  }
  const std::uint8_t* at_;
};

// Both copy numbers as the processor has them.
static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "MAVLink is little-endian");

template <class Message>
std::vector<std::uint8_t> pack(Sender& sender, const Message& message) {
  FieldWriter writer;
  Message::fields(message, writer);
  return frame_bytes(sender, Message::kId, writer.bytes().data(), writer.bytes().size());
}

/// The message in the frame; `frame.id` must be its number.
template <class Message>
Message parse(const Frame& frame) {
  Message message;
  FieldReader reader(frame.payload.data());
  Message::fields(message, reader);
  return message;
}

}  // namespace tern_companion

#endif
