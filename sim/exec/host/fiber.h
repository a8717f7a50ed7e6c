// A second stack for firmware, and the switch between it and the simulation.
//
// Uses Boost.Context's fcontext instead of its fiber class. That class unwinds an abandoned stack by an
// exception, which must not reach firmware (compiled without exceptions, possibly crashed).
#pragma once

#include <cstddef>

namespace robosim::exec {

/// Memory between two guard pages. Throws std::bad_alloc if there is none.
class GuardedMemory {
 public:
  explicit GuardedMemory(std::size_t bytes);
  ~GuardedMemory();
  GuardedMemory(const GuardedMemory&) = delete;
  GuardedMemory& operator=(const GuardedMemory&) = delete;

  std::byte* begin() const { return begin_; }
  std::byte* end() const { return begin_ + bytes_; }
  std::size_t size() const { return bytes_; }
  bool contains(const void* address) const { return address >= begin() && address < end(); }
  /// Returns whether `address` is in the page before the memory, which an overflowing stack reaches.
  bool in_guard_before(const void* address) const;

 private:
  std::size_t page_;
  std::size_t bytes_;
  std::byte* begin_;
};

/// Runs `body` on `stack`. It may be abandoned at any moment: its destructor unwinds nothing.
class Fiber {
 public:
  using Body = void (*)(void* argument);

  /// `body` must not return. It starts with the first resume().
  Fiber(const GuardedMemory& stack, Body body, void* argument);
  /// Continues the fiber until it suspends. Called from outside.
  void resume();
  /// Returns to the caller of resume(). Called on the fiber.
  void suspend();

 private:
  struct Start;
  Body body_;
  void* argument_;
  void* inside_;
  void* outside_ = nullptr;
};

}  // namespace robosim::exec
