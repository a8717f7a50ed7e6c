// Runs firmware on a second stack, and switches between this stack and the stack of the simulation.
//
// Uses Boost.Context's fcontext instead of its fiber class. The fiber class unwinds an abandoned stack by an
// exception. Exceptions must not reach firmware, which is compiled without exceptions and may have crashed.
#pragma once

#include <cstddef>
#include <cstdint>

namespace robosim::exec {

/// Memory between two guard pages. Throws std::bad_alloc if allocation fails.
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

/// Makes stack canaries constant while this object exists. With -fstack-protector, each function stores a
/// canary in its stack frame to detect overflows. The C library's canary is random. With a constant canary,
/// firmware that reads unwritten bytes of its stack reads the same values in each run. Has an effect only on
/// x86-64, because the C library protects the canary on ARM.
class ConstantCanary {
 public:
  ConstantCanary() : before_(exchange(0)) {}
  ~ConstantCanary() { exchange(before_); }
  ConstantCanary(const ConstantCanary&) = delete;
  ConstantCanary& operator=(const ConstantCanary&) = delete;

 private:
  static std::uintptr_t exchange(std::uintptr_t value) {
#ifdef __x86_64__
    std::uintptr_t before = 0;
    asm volatile("mov %%fs:0x28, %0\n\tmov %1, %%fs:0x28" : "=&r"(before) : "r"(value) : "memory");
    return before;
#else
    return value;
#endif
  }
  std::uintptr_t before_;
};

/// Runs `body` on `stack`. A fiber may be destroyed at any time, because its destructor does not unwind the
/// stack.
class Fiber {
 public:
  using Body = void (*)(void* argument);

  /// Prepares the fiber. The first resume() starts `body`, which must not return.
  Fiber(const GuardedMemory& stack, Body body, void* argument);
  /// Continues the fiber until the fiber calls suspend(). Must be called outside the fiber.
  void resume();
  /// Returns to the caller of resume(). Must be called on the fiber.
  void suspend();

 private:
  struct Start;
  Body body_;
  void* argument_;
  void* inside_;
  void* outside_ = nullptr;
};

}  // namespace robosim::exec
