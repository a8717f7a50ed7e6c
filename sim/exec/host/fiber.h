// A second stack for firmware, and the switch between it and the simulation.
//
// Boost.Context's fcontext is used, not its fiber class: that one unwinds an abandoned stack by an exception,
// which firmware (compiled without exceptions, possibly crashed) must not see.
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
  /// Whether `address` lies in the page before the memory: where a stack that overflows arrives.
  bool in_guard_before(const void* address) const;

 private:
  std::size_t page_;
  std::size_t bytes_;
  std::byte* begin_;
};

/// Runs `body` on `stack`. Abandoning it at any moment is allowed: destroying it unwinds nothing.
class Fiber {
 public:
  using Body = void (*)(void* argument);

  /// `body` must not return. It starts with the first resume().
  Fiber(const GuardedMemory& stack, Body body, void* argument);
  /// Called from outside: continues the fiber until it suspends.
  void resume();
  /// Called on the fiber: returns to whoever resumed it.
  void suspend();

 private:
  struct Start;
  Body body_;
  void* argument_;
  void* inside_;
  void* outside_ = nullptr;
};

}  // namespace robosim::exec
