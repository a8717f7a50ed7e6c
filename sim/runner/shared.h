// Memory that a process shares with its forks.
#pragma once

#include <sys/mman.h>

#include <cerrno>
#include <new>
#include <system_error>

namespace robosim::runner {

/// An object of type `T` in shared memory. The default constructor of `T` creates the object; the destructor
/// of `T` is never called. Untouched pages use no memory.
template <class T>
class Shared {
 public:
  /// Creates the object. Throws std::system_error.
  Shared() {
    void* const pages = ::mmap(nullptr, sizeof(T), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (pages == MAP_FAILED) throw std::system_error(errno, std::generic_category(), "mmap");
    value_ = new (pages) T;
  }
  ~Shared() { ::munmap(value_, sizeof(T)); }
  Shared(const Shared&) = delete;
  Shared& operator=(const Shared&) = delete;

  /// Removes the object from this process permanently: nothing in the process can write to it any more. Other
  /// processes still have it.
  void leave() const { ::munmap(value_, sizeof(T)); }

  T* get() const { return value_; }
  T* operator->() const { return value_; }

 private:
  T* value_;
};

}  // namespace robosim::runner
