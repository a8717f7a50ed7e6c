#include "sim/exec/host/fiber.h"

#include <sys/mman.h>
#include <unistd.h>

#include <boost/context/detail/fcontext.hpp>
#include <new>

#include "sim/exec/host/asan_build.h"

namespace robosim::exec {

namespace context = boost::context::detail;

GuardedMemory::GuardedMemory(std::size_t bytes) : page_(static_cast<std::size_t>(sysconf(_SC_PAGESIZE))) {
  bytes_ = (bytes + page_ - 1) / page_ * page_;
  void* const all =
      mmap(nullptr, bytes_ + 2 * page_, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (all == MAP_FAILED) throw std::bad_alloc();
  begin_ = static_cast<std::byte*>(all) + page_;
  if (mprotect(begin_, bytes_, PROT_READ | PROT_WRITE) != 0) {
    munmap(all, bytes_ + 2 * page_);
    throw std::bad_alloc();
  }
#ifdef ROBOSIM_ASAN
  // Clears AddressSanitizer's marks. Earlier memory at this address may have contained stack frames of a
  // destroyed fiber.
  ASAN_UNPOISON_MEMORY_REGION(begin_, bytes_);
#endif
}

GuardedMemory::~GuardedMemory() {
#ifdef ROBOSIM_ASAN
  // Clears the marks of stack frames, since an image may be mapped at this address next.
  ASAN_UNPOISON_MEMORY_REGION(begin_, bytes_);
#endif
  munmap(begin_ - page_, bytes_ + 2 * page_);
}

bool GuardedMemory::in_guard_before(const void* address) const {
  return address >= begin_ - page_ && address < begin_;
}

struct Fiber::Start {
  static void run(context::transfer_t from) {
    auto* const fiber = static_cast<Fiber*>(from.data);
    fiber->outside_ = from.fctx;
    fiber->body_(fiber->argument_);
  }
};

Fiber::Fiber(const GuardedMemory& stack, Body body, void* argument)
    : body_(body),
      argument_(argument),
      inside_(context::make_fcontext(stack.end(), stack.size(), &Start::run)) {}

void Fiber::resume() { inside_ = context::jump_fcontext(inside_, this).fctx; }

void Fiber::suspend() { outside_ = context::jump_fcontext(outside_, nullptr).fctx; }

}  // namespace robosim::exec
