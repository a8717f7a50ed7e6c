// The fingerprint of a run: two runs are the same run if and only if their hashes are equal.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <memory>
#include <string>

#include "hal/board/board.h"
#include "sim/base/vec.h"

namespace robosim::trace {

/// Hashes what a run did: the bits of every pose, every change of a pin or its PWM, every byte sent. Nothing
/// that is merely observed is hashed, so recording more never changes it. XXH3-64 over 64-bit little-endian
/// words.
class TraceHash {
 public:
  TraceHash();
  TraceHash(const TraceHash& other);
  TraceHash& operator=(const TraceHash& other);
  ~TraceHash();

  /// The pose at the end of a tick. Called once a tick: the hash needs no time for it.
  void pose(const Pose& pose) {
    static_assert(sizeof pose == kPoseWords * sizeof(std::uint64_t), "two Vec2 and nothing between");
    if (used_ + kPoseWords > words_.size()) flush();
    std::memcpy(&words_[used_], &pose, sizeof pose);
    used_ += kPoseWords;
  }
  void pin(Pin pin, const PinDrive& drive, SimTime t);
  void serial(std::uint8_t byte, SimTime t);

  /// "1:" and 16 hexadecimal digits; the number is the version of this definition.
  std::string text();

 private:
  struct State;

  static constexpr std::size_t kPoseWords = 4;

  void add(std::initializer_list<std::uint64_t> values) {
    if (used_ + values.size() > words_.size()) flush();
    for (const std::uint64_t value : values) words_[used_++] = value;
  }
  void flush();

  std::unique_ptr<State> state_;
  std::array<std::uint64_t, 512> words_;
  std::size_t used_ = 0;
};

}  // namespace robosim::trace
