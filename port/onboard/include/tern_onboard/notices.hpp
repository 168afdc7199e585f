// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What went wrong: each kind is counted, said once, and said again only after it was good for a second.
#ifndef TERN_ONBOARD_NOTICES_HPP
#define TERN_ONBOARD_NOTICES_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace tern_onboard {

enum class Fault : std::uint8_t {
  kPoseInvalid = 0,  ///< not finite, or its quaternion is no attitude
  kPoseRepeated,     ///< the stamp of the last one again
  kPoseBackward,     ///< a stamp before the last one's
  kPoseAhead,        ///< a stamp ahead of the clock
  kPoseOld,          ///< it came too late to be used
  kPoseJump,         ///< the estimate jumped; the flight goes on around the jump
  kHeadingJump,      ///< the estimated heading jumped; the flight ends
  kPoseLost,         ///< no pose came for too long
  kFrameInvalid,     ///< empty, of another size than announced, or of a kind that is not read
  kFrameUnready,     ///< the sensor's lens or mounting is not known yet
  kFrameRepeated,    ///< as for poses
  kFrameBackward,
  kFrameAhead,
  kFrameOld,       ///< it came, or waited, too long to be used
  kFrameNoPose,    ///< there is no pose at its stamp
  kFrameReplaced,  ///< a newer frame of the sensor came first; normal on a slow computer, and not said
  kFrameRefused,   ///< the map refused it
  kTicksSkipped,   ///< ticks came too late and were left out
  kClockBack,      ///< the clock went back
  kStrayed,        ///< the vehicle is further off the command than tracking_margin
  kLost,           ///< it is further off than `stray`: the flight ended
  kRefused,        ///< a goal, mission or beginning was refused
  kThingInvalid,   ///< something that moves has no name, or a number that is none
  kThingBackward,  ///< it was sighted at the time of its last sighting, or before; not said
  kThingAhead,     ///< it was sighted ahead of the clock
  kThingOld,       ///< it was sighted longer ago than thing_memory
  kThingsFull,     ///< more things are near than a flight can know, or more move in a frame than its detector can hold
};
constexpr std::size_t kFaults = 27;

/// "pose_invalid" and so on, as diagnostics carry it; static strings.
const char* fault_name(Fault fault);

/// "0.50 m", and "20 ms".
std::string metres(double value);
std::string milliseconds(std::int64_t ns);

/// A line for the operator's log.
struct Notice {
  bool bad;  ///< false: it is good again, or plain information
  std::string text;
};

/// Not thread-safe. A subject is a sensor's index, or kNoSubject.
class Notices {
 public:
  static constexpr int kNoSubject = -1;

  /// Counts a fault; says `text` if that was not said yet.
  void bad(Fault fault, int subject, std::int64_t now, const std::string& text);
  /// Counts a fault that nobody needs to read of.
  void count(Fault fault) { ++counts_[static_cast<std::size_t>(fault)]; }
  /// Faults of the subject from `first` to `last` have ended. A second later it is said, if they were.
  void good(Fault first, Fault last, int subject, std::int64_t now, const char* text);
  void say(const std::string& text, bool bad = false) { lines_.push_back({bad, text}); }
  /// The lines since the last call.
  std::vector<Notice> take();
  const std::array<std::uint64_t, kFaults>& counts() const { return counts_; }

 private:
  struct Said {
    Fault fault;
    int subject;
    std::int64_t last;  // time of the last fault
  };

  std::array<std::uint64_t, kFaults> counts_{};
  std::vector<Said> said_;
  std::vector<Notice> lines_;
};

}  // namespace tern_onboard

#endif
