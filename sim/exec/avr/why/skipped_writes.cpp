#include <algorithm>
#include <set>

#include "sim/exec/avr/why/branches.h"

// Finds the writes that a branch has skipped.

namespace robosim::exec::avr {
namespace {

using robosim::avr::Instruction;
using robosim::avr::Op;

constexpr std::size_t kMostReached = 400, kMostCalled = 3000;
constexpr std::uint8_t kPointerX = 26, kPointerY = 28, kPointerZ = 30;
constexpr std::uint32_t kScratch = 3;            // r0 and r1
constexpr std::uint32_t kOfCalls = 0xFFu << 18;  // r18 to r25, in which functions return their results
constexpr std::uint32_t kNowhere = ~0u;

constexpr std::uint32_t pair_of(unsigned reg) { return 3u << reg; }

bool stores_at_address(Op op) { return op == Op::sts || op == Op::out || op == Op::sbi || op == Op::cbi; }

}  // namespace

std::vector<std::uint32_t> Branches::reached(std::uint32_t from, std::uint32_t end,
                                             std::uint32_t stop) const {
  if (from == end || from == stop) return {};
  std::set<std::uint32_t> seen{from, end, stop};
  std::vector<std::uint32_t> places{from};
  for (std::size_t i = 0; i < places.size() && places.size() < kMostReached; ++i)
    for (const std::uint32_t way : ways_on(places[i]))
      if (seen.insert(way).second) places.push_back(way);
  return places;
}

/// Returns whether a path from `from` leaves the function without passing `pc`. Paths back to the branch do
/// not count.
bool Branches::leaves(std::uint32_t from, std::uint32_t branch, std::uint32_t pc) const {
  const std::vector<std::uint32_t> places = reached(from, branch, pc);
  return std::any_of(places.begin(), places.end(), [&](std::uint32_t at) { return ways_on(at).empty(); });
}

std::uint32_t Branches::meeting(std::uint32_t branch, std::uint32_t next, std::uint32_t other) const {
  const std::vector<std::uint32_t> others = reached(other, branch, kNowhere);
  const std::set<std::uint32_t> also(others.begin(), others.end());
  for (const std::uint32_t at : reached(next, branch, kNowhere))
    if (also.contains(at) && !leaves(other, branch, at) && !leaves(next, branch, at)) return at;
  // If the other path cannot leave the function, the path is the body of a loop. It returns to the branch,
  // and the branch then leads to `next`.
  return leaves(other, branch, kNowhere) ? SkippedWrites::kInCaller : next;
}

const Branches::SkippedWrites& Branches::skipped_writes(std::uint32_t branch, std::uint32_t next) {
  const auto [known, fresh] = skipped_writes_.try_emplace({branch, next});
  SkippedWrites& skipped_writes = known->second;
  if (!fresh) return skipped_writes;
  for (const std::uint32_t way : ways_on(branch)) {
    if (way == next) continue;
    skipped_writes.meets = meeting(branch, next, way);
    add_writes(reached(way, branch, skipped_writes.meets), skipped_writes);
  }
  std::sort(skipped_writes.bytes.begin(), skipped_writes.bytes.end());
  return skipped_writes;
}

void Branches::add_writes(const std::vector<std::uint32_t>& places, SkippedWrites& skipped_writes) {
  for (const std::uint32_t at : places) {
    const Instruction& i = cpu_.instruction(at);
    // Ignores POP, because a function restores the registers that it has saved.
    if (i.op != Op::pop) skipped_writes.registers |= writes_[at] & ~kScratch;
    if (stores_at_address(i.op)) skipped_writes.bytes.push_back(static_cast<std::uint16_t>(i.k));
    const auto called = called_at(at);
    if (!called) continue;
    skipped_writes.registers |= kOfCalls;
    const std::vector<std::uint16_t>& bytes = bytes_of(*called);
    skipped_writes.bytes.insert(skipped_writes.bytes.end(), bytes.begin(), bytes.end());
  }
  add_bytes_by_pointer(places, skipped_writes);
}

/// Adds the bytes that the path writes through pointers. Skips a pointer that the path has changed, except by
/// a copy from registers that the path has not changed.
void Branches::add_bytes_by_pointer(const std::vector<std::uint32_t>& places, SkippedWrites& skipped_writes) {
  // For each pointer that the path has changed, the register pair from which the path has copied the pointer.
  // nullopt = the pointer's value is unknown.
  std::map<std::uint8_t, std::optional<std::uint8_t>> copied;
  for (const std::uint32_t at : places)
    for (const std::uint8_t pair : {kPointerX, kPointerY, kPointerZ}) {
      if ((writes_[at] & pair_of(pair)) == 0) continue;
      const Instruction& i = cpu_.instruction(at);
      const bool copies = i.op == Op::movw && i.a == pair && (skipped_writes.registers & pair_of(i.b)) == 0;
      const bool again = copied.contains(pair) && copied[pair] != i.b;
      copied[pair] = copies && !again ? std::optional(i.b) : std::nullopt;
    }
  for (const std::uint32_t at : places) {
    const Instruction& i = cpu_.instruction(at);
    if (i.op != Op::std_y && i.op != Op::std_z && i.op != Op::st_x) continue;
    const std::uint8_t pair = i.op == Op::std_y ? kPointerY : i.op == Op::std_z ? kPointerZ : kPointerX;
    const auto from = copied.contains(pair) ? copied[pair] : pair;
    if (from) skipped_writes.bytes_by_pointer[*from].push_back(i.op == Op::st_x ? std::uint8_t{0} : i.b);
  }
}

const std::vector<std::uint16_t>& Branches::bytes_of(std::uint32_t function) {
  const auto [known, fresh] = bytes_of_.try_emplace(function);
  if (!fresh) return known->second;
  std::set<std::uint16_t> bytes;
  std::set<std::uint32_t> seen{function};
  std::vector<std::uint32_t> open{function};
  while (!open.empty() && seen.size() < kMostCalled) {
    const std::uint32_t here = open.back();
    open.pop_back();
    const Instruction& i = cpu_.instruction(here);
    if (stores_at_address(i.op)) bytes.insert(static_cast<std::uint16_t>(i.k));
    std::vector<std::uint32_t> ways = ways_on(here);
    if (const auto called = called_at(here)) ways.push_back(*called);
    for (const std::uint32_t way : ways)
      if (seen.insert(way).second) open.push_back(way);
  }
  known->second.assign(bytes.begin(), bytes.end());
  return known->second;
}

}  // namespace robosim::exec::avr
