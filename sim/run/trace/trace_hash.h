// Computes the fingerprint of a run. Equal runs have equal hashes; different runs practically never do.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>

#include "hal/board/board.h"
#include "sim/base/vec.h"

namespace robosim::trace {

/// Hashes the events of a run: the bits of every pose, every change of a pin or its PWM, every sent byte.
/// Does not hash observations, so recording more never changes the hash. The hash is XXH3-64 over 64-bit
/// little-endian words.
class TraceHash {
 public:
  TraceHash();
  TraceHash(const TraceHash& other);
  TraceHash& operator=(const TraceHash& other);
  ~TraceHash();

  /// Adds the pose at the end of a tick. Call it once per tick: the hash does not include the time of a pose.
  void pose(const Pose& pose) {
    static_assert(sizeof pose == kPoseWords * sizeof(std::uint64_t), "two Vec2 and nothing between");
    std::memcpy(take(kPoseWords), &pose, sizeof pose);
  }
  void pin(Pin pin, const PinDrive& drive, SimTime t);
  void serial(std::uint8_t byte, SimTime t);

  /// Returns "1:" and 16 hexadecimal digits; 1 is the version of this definition.
  std::string text();

 private:
  struct State;

  static constexpr std::size_t kPoseWords = 4;
  // Tags distinguish kinds of records. A pose needs no tag, because it comes once per tick.
  static constexpr std::uint64_t kPinTag = 0x50494E0000000000u;
  static constexpr std::uint64_t kSerialTag = 0x5345520000000000u;

  /// Returns room for `count` more words, which the caller writes.
  std::uint64_t* take(std::size_t count) {
    if (used_ + count > words_.size()) [[unlikely]]
      flush();
    used_ += count;
    return &words_[used_ - count];
  }
  void flush();

  std::unique_ptr<State> state_;
  std::array<std::uint64_t, 512> words_;
  std::size_t used_ = 0;
};

inline void TraceHash::pin(Pin pin, const PinDrive& drive, SimTime t) {
  const std::uint64_t how =
      kPinTag | static_cast<std::uint64_t>(pin) << 16 | static_cast<std::uint64_t>(drive.mode) << 8 |
      static_cast<std::uint64_t>(drive.level) << 1 | static_cast<std::uint64_t>(drive.pwm);
  std::uint64_t* const words = take(4);
  words[0] = how;
  words[1] = static_cast<std::uint64_t>(t);
  static_assert(sizeof drive.duty == sizeof words[2]);
  std::memcpy(&words[2], &drive.duty, sizeof words[2]);
  words[3] = drive.tone_hz;
}

}  // namespace robosim::trace
