// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "companion/frame.hpp"

#include <algorithm>

namespace tern_companion {
namespace {

constexpr std::uint8_t kMagic = 0xFD, kMagicOfVersion1 = 0xFE;
constexpr std::uint8_t kSignedFlag = 1;
constexpr std::size_t kHeader = 10, kHeaderOfVersion1 = 6, kChecksum = 2, kSignature = 13;

/// CRC-16/MCRF4XX, which MAVLink calls X.25.
std::uint16_t checksum(const std::uint8_t* bytes, std::size_t count, std::uint8_t extra) {
  std::uint16_t crc = 0xFFFF;
  const auto accumulate = [&crc](std::uint8_t byte) {
    auto t = static_cast<std::uint8_t>(byte ^ (crc & 0xFF));
    t = static_cast<std::uint8_t>(t ^ (t << 4));
    crc = static_cast<std::uint16_t>((crc >> 8) ^ (t << 8) ^ (t << 3) ^ (t >> 4));
  };
  for (std::size_t i = 0; i < count; ++i) accumulate(bytes[i]);
  accumulate(extra);
  return crc;
}

template <class... Known>
bool find_extra(std::uint32_t id, std::uint8_t& extra, std::tuple<Known...>* /*list*/) {
  return ((id == Known::kId && ((extra = Known::kCrcExtra), true)) || ...);
}

/// False for a message that is not in the table.
bool crc_extra(std::uint32_t id, std::uint8_t& extra) {
  return find_extra(id, extra, static_cast<Messages*>(nullptr));
}

}  // namespace

bool FrameReader::next(Frame& frame) {
  std::size_t at = 0;
  bool found = false;
  while (!found && at < waiting_.size()) {
    if (waiting_[at] != kMagic && waiting_[at] != kMagicOfVersion1) {
      ++at;
      continue;
    }
    std::size_t taken = 0;
    found = read(at, taken, frame);
    if (taken == 0) break;  // not whole yet
    at += taken;
  }
  waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(at));
  return found;
}

/// Looks at the frame at `at`. `taken`: the bytes to go on by; one after a wrong checksum, or after an unknown frame
/// that no other follows, because a frame may begin within what looked like one; none if more bytes must come first.
bool FrameReader::read(std::size_t at, std::size_t& taken, Frame& frame) {
  const std::uint8_t* const bytes = waiting_.data() + at;
  const std::size_t left = waiting_.size() - at;
  const bool is_version_1 = bytes[0] == kMagicOfVersion1;
  const std::size_t header = is_version_1 ? kHeaderOfVersion1 : kHeader;
  if (left < header) return false;
  const bool has_signature = !is_version_1 && (bytes[2] & kSignedFlag) != 0;
  const std::size_t checked = header + bytes[1];
  const std::size_t size = checked + kChecksum + (has_signature ? kSignature : 0);
  if (left < size) return false;
  const std::uint32_t id =
      is_version_1 ? bytes[5] : static_cast<std::uint32_t>(bytes[7] | bytes[8] << 8 | bytes[9] << 16);
  std::uint8_t extra = 0;
  taken = size;
  if (!crc_extra(id, extra)) {
    ++counts_.unknown;
    const bool goes_on = left == size || bytes[size] == kMagic || bytes[size] == kMagicOfVersion1;
    if (!goes_on) taken = 1;
    return false;
  }
  const std::uint16_t crc = checksum(bytes + 1, checked - 1, extra);
  const bool is_good = bytes[checked] == (crc & 0xFF) && bytes[checked + 1] == crc >> 8;
  if (!is_good || (!is_version_1 && (bytes[2] & ~kSignedFlag) != 0)) {
    ++counts_.bad_checksum;
    taken = 1;
    return false;
  }
  if (is_version_1 || has_signature) {
    ++(is_version_1 ? counts_.version_1 : counts_.with_signature);
    return false;
  }
  ++counts_.frames;
  frame = Frame{bytes[4], bytes[5], bytes[6], id, {}};
  std::copy(bytes + header, bytes + checked, frame.payload.begin());
  return true;
}

std::vector<std::uint8_t> frame_bytes(Sender& sender, std::uint32_t id, const std::uint8_t* payload, std::size_t size) {
  while (size > 1 && payload[size - 1] == 0) --size;  // MAVLink 2 leaves zeros at the end out
  std::uint8_t extra = 0;
  crc_extra(id, extra);
  std::vector<std::uint8_t> bytes{
      kMagic, static_cast<std::uint8_t>(size), 0, 0, sender.sequence++, sender.system, sender.component};
  for (int k = 0; k < 3; ++k) bytes.push_back(static_cast<std::uint8_t>(id >> (8 * k)));
  bytes.insert(bytes.end(), payload, payload + size);
  const std::uint16_t crc = checksum(bytes.data() + 1, bytes.size() - 1, extra);
  bytes.push_back(static_cast<std::uint8_t>(crc & 0xFF));
  bytes.push_back(static_cast<std::uint8_t>(crc >> 8));
  return bytes;
}

}  // namespace tern_companion
