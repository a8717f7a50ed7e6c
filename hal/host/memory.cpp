// Implements malloc() and free() in the memory at FirmwareState::heap. Guard pages follow this memory. Like
// avr-libc, malloc() uses the first free block that is large enough, and adjacent free blocks are joined.
#include <stdlib.h>
#include <string.h>

#include "hal/host/addresses.h"
#include "hal/host/clock.h"

namespace host = robosim::host;

namespace {

/// The header before each block. Blocks follow each other without gaps.
struct Block {
  uint32_t bytes;  ///< bytes of the payload
  uint32_t use;
  uint32_t asked;  ///< size requested from malloc()
};

/// The states of a block. kResting: the block was freed, but is reused only if there is no other free block.
/// With address checks, freed blocks rest, so that later accesses are detected.
enum Use : uint32_t { kFree, kUsed, kResting };

constexpr size_t kAlign = 16;
static_assert(sizeof(Block) <= kAlign, "the header must leave payloads aligned");

uint8_t* arena() { return host::state.heap; }
uint8_t* arena_end() { return host::state.heap + host::state.heap_bytes; }
uint8_t* payload(uint8_t* block) { return block + kAlign; }
Block* header(uint8_t* block) { return reinterpret_cast<Block*>(block); }
uint8_t* next(uint8_t* block) { return payload(block) + header(block)->bytes; }

bool ready;

__attribute__((noreturn)) void fail(const char* reason) {
  host::executor->crash(reason, nullptr, 0, host::state.place);
  __builtin_unreachable();
}

/// Fails if the header is inconsistent: the sketch wrote outside of a block.
void check(uint8_t* block) {
  const Block* head = header(block);
  const auto room = static_cast<size_t>(arena_end() - payload(block));
  if (head->use <= kResting && head->bytes <= room && head->bytes % kAlign == 0) return;
  fail("the heap is damaged (something was written outside of a block)");
}

void join_free(uint8_t* block) {
  for (;;) {
    uint8_t* const after = next(block);
    if (after >= arena_end()) return;
    check(after);
    if (header(after)->use != kFree) return;
    header(block)->bytes += static_cast<uint32_t>(kAlign) + header(after)->bytes;
  }
}

uint8_t* block_of(void* memory) {
  auto* const address = static_cast<uint8_t*>(memory);
  if (address < arena() + kAlign || address >= arena_end())
    fail("free() or realloc() of memory that malloc() did not return");
  return address - kAlign;
}

/// Marks `size` bytes of the block as used by the sketch.
void give(uint8_t* block, size_t size) {
  const auto end = static_cast<size_t>(next(block) - arena());
  if (end > host::state.heap_used) host::state.heap_used = end;
  header(block)->use = kUsed;
  header(block)->asked = static_cast<uint32_t>(size);
  host::forbid(payload(block), header(block)->bytes, host::kHeapGap);
  host::allow(payload(block), size);
}

void* take(size_t size) {
  const auto bytes = static_cast<uint32_t>((size + kAlign - 1) / kAlign * kAlign);
  for (uint8_t* block = arena(); block < arena_end(); block = next(block)) {
    check(block);
    if (header(block)->use != kFree) continue;
    join_free(block);
    const uint32_t found = header(block)->bytes;
    if (found < bytes) continue;
    if (found >= bytes + 2 * kAlign) {
      header(block)->bytes = bytes;
      *header(next(block)) = {static_cast<uint32_t>(found - bytes - kAlign), kFree, 0};
    }
    give(block, size);
    host::fill_unset(payload(block), size);
    return payload(block);
  }
  return nullptr;
}

/// Makes all resting blocks free. Returns false if no block rests.
bool wake_resting() {
  bool any = false;
  for (uint8_t* block = arena(); block < arena_end(); block = next(block)) {
    if (header(block)->use != kResting) continue;
    *header(block) = {header(block)->bytes, kFree, 0};
    any = true;
  }
  return any;
}

}  // namespace

namespace robosim {
namespace host {

HeapBlock block_around(uintptr_t address) {
  HeapBlock found = {0, 0};
  if (!ready) return found;
  const auto* const at = reinterpret_cast<const uint8_t*>(address);
  for (uint8_t* block = arena(); block < arena_end() && block <= at; block = next(block))
    if (header(block)->asked > 0) found = {reinterpret_cast<uintptr_t>(payload(block)), header(block)->asked};
  return found;
}

}  // namespace host
}  // namespace robosim

extern "C" {

void* malloc(size_t size) {
  host::spend(host::cost::kAllocate);
  if (!ready) {
    ready = true;
    *header(arena()) = {static_cast<uint32_t>(host::state.heap_bytes - kAlign), kFree, 0};
    host::forbid(arena(), host::state.heap_bytes, host::kHeapGap);
  }
  if (size == 0) size = 1;
  if (size > host::state.heap_bytes) return nullptr;
  void* const memory = take(size);
  return memory || !wake_resting() ? memory : take(size);
}

void free(void* memory) {
  host::spend(host::cost::kAllocate);
  if (!memory) return;
  uint8_t* const block = block_of(memory);
  check(block);
  if (header(block)->use == kResting) fail("free() or delete of memory that was already freed");
  header(block)->use = host::kShadow ? kResting : kFree;
  host::forbid(payload(block), header(block)->bytes, host::kHeapFreed);
  if (header(block)->use == kFree) join_free(block);
}

void* calloc(size_t count, size_t size) {
  if (size != 0 && count > host::state.heap_bytes / size) return nullptr;
  void* const memory = malloc(count * size);
  if (memory) memset(memory, 0, count * size);
  return memory;
}

void* realloc(void* memory, size_t size) {
  if (!memory) return malloc(size);
  uint8_t* const block = block_of(memory);
  check(block);
  const size_t had = header(block)->bytes;
  if (size <= had && size > 0) {
    give(block, size);
    return memory;
  }
  void* const moved = malloc(size);
  if (!moved) return nullptr;
  memcpy(moved, memory, header(block)->asked < size ? header(block)->asked : size);
  free(memory);
  return moved;
}

}  // extern "C"
