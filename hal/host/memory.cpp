// malloc and free on an arena of the image's own: a sketch that overruns its heap meets the arena's guard
// pages. First fit over blocks in address order, neighbours joined when freed, as avr-libc does it.
#include <stdlib.h>
#include <string.h>

#include "hal/host/clock.h"

namespace host = robosim::host;

namespace {

/// Stands before every block; blocks follow each other without gaps.
struct Block {
  uint32_t bytes;  ///< of the payload
  uint32_t used;
};

constexpr size_t kAlign = 16;
static_assert(sizeof(Block) <= kAlign, "the header must leave payloads aligned");

uint8_t* arena() { return host::state.heap; }
uint8_t* arena_end() { return host::state.heap + host::state.heap_bytes; }
uint8_t* payload(uint8_t* block) { return block + kAlign; }
Block* header(uint8_t* block) { return reinterpret_cast<Block*>(block); }
uint8_t* next(uint8_t* block) { return payload(block) + header(block)->bytes; }

bool ready;

/// A header that no longer makes sense has been overwritten: the sketch wrote past the end of a block.
void check(uint8_t* block) {
  const Block* head = header(block);
  const auto room = static_cast<size_t>(arena_end() - payload(block));
  if (head->used <= 1 && head->bytes <= room && head->bytes % kAlign == 0) return;
  host::executor->crash("the heap is damaged (something was written past the end of a block)", nullptr, 0,
                        host::state.place);
  __builtin_unreachable();
}

void join_free(uint8_t* block) {
  for (;;) {
    uint8_t* const after = next(block);
    if (after >= arena_end()) return;
    check(after);
    if (header(after)->used) return;
    header(block)->bytes += static_cast<uint32_t>(kAlign) + header(after)->bytes;
  }
}

}  // namespace

extern "C" {

void* malloc(size_t size) {
  host::spend(host::cost::kAllocate);
  if (!ready) {
    ready = true;
    *header(arena()) = {static_cast<uint32_t>(host::state.heap_bytes - kAlign), 0};
  }
  if (size == 0) size = 1;
  if (size > host::state.heap_bytes) return nullptr;
  const auto bytes = static_cast<uint32_t>((size + kAlign - 1) / kAlign * kAlign);
  for (uint8_t* block = arena(); block < arena_end(); block = next(block)) {
    check(block);
    if (header(block)->used) continue;
    join_free(block);
    const uint32_t found = header(block)->bytes;
    if (found < bytes) continue;
    if (found >= bytes + 2 * kAlign) {
      header(block)->bytes = bytes;
      *header(next(block)) = {static_cast<uint32_t>(found - bytes - kAlign), 0};
    }
    header(block)->used = 1;
    return payload(block);
  }
  return nullptr;
}

void free(void* memory) {
  host::spend(host::cost::kAllocate);
  if (!memory) return;
  auto* const address = static_cast<uint8_t*>(memory);
  if (address < arena() + kAlign || address >= arena_end()) {
    host::executor->crash("free() of something that malloc() did not give", nullptr, 0,
                          __builtin_return_address(0));
    __builtin_unreachable();
  }
  uint8_t* const block = address - kAlign;
  check(block);
  header(block)->used = 0;
  join_free(block);
}

void* calloc(size_t count, size_t size) {
  if (size != 0 && count > host::state.heap_bytes / size) return nullptr;
  void* const memory = malloc(count * size);
  if (memory) memset(memory, 0, count * size);
  return memory;
}

void* realloc(void* memory, size_t size) {
  if (!memory) return malloc(size);
  uint8_t* const block = static_cast<uint8_t*>(memory) - kAlign;
  check(block);
  const size_t had = header(block)->bytes;
  if (size <= had && size > 0) return memory;
  void* const moved = malloc(size);
  if (!moved) return nullptr;
  memcpy(moved, memory, had < size ? had : size);
  free(memory);
  return moved;
}

}  // extern "C"
