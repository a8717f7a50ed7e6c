// Implements an allocator for large arrays with random access. It requests large pages from the system, so
// that a few pages suffice instead of thousands. A vector that is smaller than two large pages is allocated
// as usual.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace robosim::cells {

template <class T>
class LargePages {
 public:
  using value_type = T;

  LargePages() = default;
  template <class U>
  LargePages(const LargePages<U>&) {}

  T* allocate(std::size_t count) {
    std::size_t size = count * sizeof(T);
    void* memory = nullptr;
    if (size >= 2 * kPage) {
      size = (size + kPage - 1) / kPage * kPage;
      memory = std::aligned_alloc(kPage, size);
#ifdef MADV_HUGEPAGE
      if (memory) ::madvise(memory, size, MADV_HUGEPAGE);  // without large pages, access is only slower
#endif
    } else {
      memory = std::malloc(size);
    }
    if (!memory) throw std::bad_alloc();
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t) { std::free(memory); }
  bool operator==(const LargePages&) const { return true; }

 private:
  static constexpr std::size_t kPage = std::size_t{2} << 20;
};

}  // namespace robosim::cells
