#include "sim/trace/trace_hash.h"

#define XXH_STATIC_LINKING_ONLY
#include <fmt/format.h>
#include <xxhash.h>
// By the widest vectors that the processor has: the same hash.
#if defined(__x86_64__) && __has_include(<xxh_x86dispatch.h>)
#include <xxh_x86dispatch.h>
#endif

#include <bit>
#include <cstring>

namespace robosim::trace {

static_assert(std::endian::native == std::endian::little, "trace hashes are defined on little-endian words");

struct TraceHash::State {
  XXH3_state_t hash;
};

namespace {
// Tags keep records of different kinds apart. A pose needs none: it comes once a tick.
constexpr std::uint64_t kPinTag = 0x50494E0000000000u;
constexpr std::uint64_t kSerialTag = 0x5345520000000000u;

std::uint64_t bits_of(double value) {
  std::uint64_t bits = 0;
  static_assert(sizeof bits == sizeof value);
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

}  // namespace

TraceHash::TraceHash() : state_(std::make_unique<State>()) { XXH3_64bits_reset(&state_->hash); }
TraceHash::TraceHash(const TraceHash& other) : state_(std::make_unique<State>()) { *this = other; }

TraceHash& TraceHash::operator=(const TraceHash& other) {
  *state_ = *other.state_;
  words_ = other.words_;
  used_ = other.used_;
  return *this;
}

TraceHash::~TraceHash() = default;

void TraceHash::pin(Pin pin, const PinDrive& drive, SimTime t) {
  const std::uint64_t how =
      kPinTag | static_cast<std::uint64_t>(pin) << 16 | static_cast<std::uint64_t>(drive.mode) << 8 |
      static_cast<std::uint64_t>(drive.level) << 1 | static_cast<std::uint64_t>(drive.pwm);
  add({how, static_cast<std::uint64_t>(t), bits_of(drive.duty), drive.tone_hz});
}

void TraceHash::serial(std::uint8_t byte, SimTime t) {
  add({kSerialTag | byte, static_cast<std::uint64_t>(t)});
}

void TraceHash::flush() {
  XXH3_64bits_update(&state_->hash, words_.data(), used_ * sizeof words_[0]);
  used_ = 0;
}

std::string TraceHash::text() {
  flush();
  return fmt::format("1:{:016x}", XXH3_64bits_digest(&state_->hash));
}

}  // namespace robosim::trace
