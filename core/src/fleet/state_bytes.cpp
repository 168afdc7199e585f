// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fleet/state_bytes.hpp"

namespace tern {
namespace {

template <typename Bytes, typename Head>
void list_state(Bytes& bytes, Head& state, bool by_range) {
  bytes(state.id, state.incarnation, state.counter, state.stamp, state.flown, state.open, state.radius, state.priority,
        state.has_left);
  if (by_range) bytes(state.until);
}

template <typename Bytes, typename Entry>
void list_answer(Bytes& bytes, Entry& answer, bool by_range) {
  bytes(answer.id, answer.incarnation, answer.number, answer.consent, answer.lacks_flown);
  if (by_range) bytes(answer.link, answer.its, answer.promises);
}

}  // namespace

void write_state(const StateHead& state, bool by_range, std::uint16_t answers, ByteWriter& out) noexcept {
  out.put(form_of(by_range ? MessageKind::kRangeState : MessageKind::kState));
  list_state(out, state, by_range);
  out.put(answers);
}

void append_answer(const Answer& answer, bool by_range, ByteWriter& out) noexcept {
  list_answer(out, answer, by_range);
}

bool read_state(const std::uint8_t* bytes, std::int32_t size, std::uint16_t to, StateHead& state, bool& by_range,
                Answer& answer) noexcept {
  if (size < 1 || (bytes[0] != form_of(MessageKind::kState) && bytes[0] != form_of(MessageKind::kRangeState)))
    return false;
  by_range = bytes[0] == form_of(MessageKind::kRangeState);
  if (size < state_head_bytes(by_range)) return false;
  ByteReader in(bytes, size);
  std::uint16_t answers = 0;
  in.skip(1);
  list_state(in, state, by_range);
  in.get(answers);
  answer = Answer{};
  if (size != state_bytes(answers, by_range) || state.incarnation == 0 || state.flown == 0) return false;
  for (std::int32_t k = 0; k < answers; ++k) {
    Answer next{};
    list_answer(in, next, by_range);
    if (next.id == to) answer = next;
  }
  // What is neither yes nor no counts as no answer.
  if (answer.consent != Consent::kYes && answer.consent != Consent::kNo) answer.consent = Consent::kNone;
  return true;
}

}  // namespace tern
