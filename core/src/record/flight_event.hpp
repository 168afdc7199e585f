// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// One event of a flight's record while it is written: whole, or not at all.
#ifndef TERN_RECORD_FLIGHT_EVENT_HPP
#define TERN_RECORD_FLIGHT_EVENT_HPP

#include "record/envelope.hpp"
#include "record/flight_fields.hpp"
#include "record/words.hpp"
#include "tern/flight_record.hpp"

namespace tern {

class FlightRecorder::Event {
 public:
  /// Opens an event. Nothing is written if the recorder takes no more, or if the call was refused.
  Event(FlightRecorder& recorder, FlightEventKind kind, Status answer)
      : recorder_(recorder),
        is_open_(recorder.status_ == Status::kOk && (answer == Status::kOk || answer == Status::kRunning)),
        words_(is_open_ ? recorder.bytes_ + kWordBytes * recorder.used_ : nullptr, is_open_ ? room() : 0) {
    head_ = static_cast<std::uint64_t>(kind) | static_cast<std::uint64_t>(answer) << kAnswerShift;
    words_.word(head_);
  }

  bool is_open() const { return is_open_; }
  WordWriter& words() { return words_; }

  /// Completes the event; does nothing if it is not open.
  Status end() {
    if (!is_open_) return recorder_.status_;
    if (words_.full()) return recorder_.status_ = Status::kRecordFull;
    words_.replace(0, head_ | static_cast<std::uint64_t>(words_.count() - 1) << kEventLengthShift);
    append(recorder_, words_.count());
    return Status::kOk;
  }

  /// Counts words that were written behind the others.
  static void append(FlightRecorder& recorder, std::size_t words) {
    const std::uint8_t* const begin = recorder.bytes_ + kWordBytes * recorder.used_;
    recorder.checksum_ = checksum(begin, kWordBytes * words, recorder.checksum_);
    recorder.used_ += words;
    recorder.total_ += words;
  }

 private:
  /// Bytes left for events: close() needs the rest.
  std::size_t room() const {
    const std::size_t taken = recorder_.used_ + kTrailerWords;
    return recorder_.room_ > taken ? kWordBytes * (recorder_.room_ - taken) : 0;
  }

  FlightRecorder& recorder_;
  bool is_open_;
  WordWriter words_;
  std::uint64_t head_ = 0;
};

}  // namespace tern

#endif
