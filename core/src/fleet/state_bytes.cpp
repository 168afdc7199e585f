// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fleet/state_bytes.hpp"

namespace tern {
namespace {

Answer read_answer(ByteReader& in) {
  Answer answer{};
  std::uint8_t consent = 0;
  std::uint8_t lacks = 0;
  in.get(answer.id);
  in.get(answer.incarnation);
  in.get(answer.number);
  in.get(consent);
  in.get(lacks);
  // What is neither yes nor no counts as no answer.
  answer.consent = consent == 1 ? Consent::kYes : consent == 2 ? Consent::kNo : Consent::kNone;
  answer.lacks_flown = lacks != 0;
  return answer;
}

}  // namespace

void write_state(const StateHead& state, std::uint16_t answers, ByteWriter& out) noexcept {
  out.put(form_of(MessageKind::kState));
  out.put(state.id);
  out.put(state.incarnation);
  out.put(state.counter);
  out.put(state.stamp);
  out.put(state.flown);
  out.put(state.open);
  out.put(state.radius);
  out.put(state.priority);
  out.put(static_cast<std::uint8_t>(state.has_left));
  out.put(answers);
}

void append_answer(const Answer& answer, ByteWriter& out) noexcept {
  out.put(answer.id);
  out.put(answer.incarnation);
  out.put(answer.number);
  out.put(static_cast<std::uint8_t>(answer.consent));
  out.put(static_cast<std::uint8_t>(answer.lacks_flown));
}

bool read_state(const std::uint8_t* bytes, std::int32_t size, std::uint16_t to, StateHead& state,
                Answer& answer) noexcept {
  if (size < kStateHeadBytes || bytes[0] != form_of(MessageKind::kState)) return false;
  ByteReader in(bytes, size);
  std::uint8_t form = 0;
  std::uint8_t left = 0;
  std::uint16_t answers = 0;
  in.get(form);
  in.get(state.id);
  in.get(state.incarnation);
  in.get(state.counter);
  in.get(state.stamp);
  in.get(state.flown);
  in.get(state.open);
  in.get(state.radius);
  in.get(state.priority);
  in.get(left);
  in.get(answers);
  state.has_left = left != 0;
  answer = Answer{};
  if (size != state_bytes(answers) || state.incarnation == 0 || state.flown == 0) return false;
  for (std::int32_t k = 0; k < answers; ++k) {
    const Answer next = read_answer(in);
    if (next.id == to) answer = next;
  }
  return true;
}

}  // namespace tern
