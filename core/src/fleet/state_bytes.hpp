// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a vehicle says of itself, as the bytes of a message: which of its plans it flies and which one it announces, and
// what it knows of each other member and answers to its announcement.
#ifndef TERN_FLEET_STATE_BYTES_HPP
#define TERN_FLEET_STATE_BYTES_HPP

#include <cstdint>

#include "fleet/packets.hpp"

namespace tern {

enum class Consent : std::uint8_t {
  kNone = 0,  ///< no answer
  kYes = 1,   ///< clear of what I fly and announce, and I will keep clear of it
  kNo = 2,    ///< not clear
};

/// What a vehicle says to another one.
struct Answer {
  std::uint16_t id;           ///< the other one
  std::uint32_t incarnation;  ///< of the other one, the newest that was heard of; 0: none
  std::uint32_t number;       ///< the newest plan of this incarnation that was received; 0: none
  Consent consent;            ///< on that plan
  bool lacks_flown;           ///< the plan that the other one flies was not received
  // Of members by range alone.
  std::uint32_t link;  ///< number of the vehicle's record of the other one
  std::uint32_t its;   ///< number of the other one's record of this vehicle, as it was heard
  bool promises;       ///< until StateHead::until, it asks and tells the other one
};

/// What a vehicle says of itself.
struct StateHead {
  std::uint16_t id;
  std::uint32_t incarnation;
  std::uint32_t counter;  ///< rises with every change of the state
  std::int64_t stamp;     ///< when it changed, ns
  std::uint32_t flown;    ///< number of the plan that is flown
  std::uint32_t open;     ///< number of the plan that is announced; 0: none
  std::uint16_t radius;   ///< mm
  std::uint8_t priority;
  bool has_left;
  std::int64_t until;  ///< ns: of what is promised, where members come by range
};

/// Members by range take more.
constexpr std::int32_t state_head_bytes(bool by_range) {
  return by_range ? 41 : 33;
}
constexpr std::int32_t state_bytes(std::int32_t answers, bool by_range) {
  return state_head_bytes(by_range) + (by_range ? 21 : 12) * answers;
}

/// Writes the head; append_answer() adds the answers, `answers` of them.
void write_state(const StateHead& state, bool by_range, std::uint16_t answers, ByteWriter& out) noexcept;
void append_answer(const Answer& answer, bool by_range, ByteWriter& out) noexcept;

/// False for bytes that are no state. `by_range`: where members come so. `answer` gets the answer to the member `to`;
/// of incarnation 0 if there is none.
bool read_state(const std::uint8_t* bytes, std::int32_t size, std::uint16_t to, StateHead& state, bool& by_range,
                Answer& answer) noexcept;

}  // namespace tern

#endif
