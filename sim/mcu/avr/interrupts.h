// Stores the requested interrupts by vector; the lowest vector has priority (data sheet, chapter 12).
//
// A peripheral requests a vector while its flag and its enable bit are both set. Clearing the flag or the
// enable bit withdraws the request. A flag that was set earlier therefore requests its interrupt as soon as
// the enable bit is set.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace robosim::avr {

class Interrupts {
 public:
  static constexpr int kMost = 64;

  /// Returns `vector` as a bit if `wanted`, else 0.
  static constexpr std::uint64_t bit(int vector, bool wanted = true) {
    return wanted ? std::uint64_t{1} << vector : 0;
  }

  void request(int vector, bool requested) { state = requested ? state | bit(vector) : state & ~bit(vector); }
  bool is_requested(int vector) const { return state >> vector & 1; }
  bool any() const { return state != 0; }
  int first() const { return std::countr_zero(state); }

  /// Registers void Owner::Method(int vector), which is called when the processor enters the vector. The
  /// method clears the flag if the data sheet says that the hardware clears it.
  template <auto Method, typename Owner>
  void on_entry(int vector, Owner* owner) {
    entries_[static_cast<std::size_t>(vector)] = {
        [](void* self, int number) { (static_cast<Owner*>(self)->*Method)(number); }, owner};
  }
  void entered(int vector) const {
    const Entry& entry = entries_[static_cast<std::size_t>(vector)];
    if (entry.call) entry.call(entry.self, vector);
  }

  std::uint64_t state = 0;  ///< one bit per vector

 private:
  struct Entry {
    void (*call)(void* self, int vector) = nullptr;
    void* self = nullptr;
  };
  std::array<Entry, kMost> entries_{};
};

}  // namespace robosim::avr
