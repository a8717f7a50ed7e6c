#include "sim/run/trace/trace_hash.h"

#define XXH_STATIC_LINKING_ONLY
#include <fmt/format.h>
#include <xxhash.h>
// Uses the widest vector instructions of the processor. The hash does not depend on them. Debian's static
// library cannot choose these instructions at run time.
#if defined(__x86_64__) && __has_include(<xxh_x86dispatch.h>) && !defined(ROBOSIM_STATIC_XXHASH)
#include <xxh_x86dispatch.h>
#endif

#include <bit>

namespace robosim::trace {

static_assert(std::endian::native == std::endian::little, "trace hashes are defined on little-endian words");

struct TraceHash::State {
  XXH3_state_t hash;
};

TraceHash::TraceHash() : state_(std::make_unique<State>()) { XXH3_64bits_reset(&state_->hash); }
TraceHash::TraceHash(const TraceHash& other) : state_(std::make_unique<State>()) { *this = other; }

TraceHash& TraceHash::operator=(const TraceHash& other) {
  *state_ = *other.state_;
  words_ = other.words_;
  used_ = other.used_;
  return *this;
}

TraceHash::~TraceHash() = default;

void TraceHash::serial(std::uint8_t byte, SimTime t) {
  std::uint64_t* const words = take(2);
  words[0] = kSerialTag | byte;
  words[1] = static_cast<std::uint64_t>(t);
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
