#include "sim/cells/growing_network.h"

#include <algorithm>
#include <utility>

namespace robosim::cells {
namespace {

constexpr std::uint32_t kLongest = (1u << 24) - 1;

// Places of one block of 16 x 16 cells share a cache line of the index, as a walk meets them soon after each
// other.
std::size_t hash(const nav::Place& place) {
  const std::uint64_t block = static_cast<std::uint64_t>(static_cast<std::uint32_t>(place.y >> 4)) << 32 |
                              static_cast<std::uint32_t>(place.x >> 4);
  const std::uint64_t line = block * 0x9E3779B97F4A7C15u >> 32;
  return static_cast<std::size_t>(line * 16 + (static_cast<std::uint32_t>(place.x + 5 * place.y) & 15));
}

}  // namespace

void GrowingNetwork::clear() {
  nodes_.clear();
  junctions_.clear();
  index_.clear();
  is_tree_ = true;
}

std::size_t GrowingNetwork::slot_of(const nav::Place& wanted) const {
  const std::size_t mask = index_.size() - 1;
  std::size_t slot = hash(wanted) & mask;
  while (index_[slot] != kNone) {
    const nav::Place& found = place(index_[slot]);
    if (found.x == wanted.x && found.y == wanted.y) break;
    slot = (slot + 1) & mask;
  }
  return slot;
}

GrowingNetwork::Id GrowingNetwork::find(const nav::Place& place) const {
  return index_.empty() ? kNone : index_[slot_of(place)];
}

void GrowingNetwork::index(Id node, const nav::Place& at) {
  if (2 * junctions_.size() > index_.size()) {
    index_.assign(std::max<std::size_t>(64, 4 * index_.size()), kNone);
    for (Id other = 0; other < node; ++other)
      if (!isStation(other)) index_[slot_of(place(other))] = other;
  }
  index_[slot_of(at)] = node;
}

void GrowingNetwork::connect(Id a, std::uint8_t slot_a, Id b, std::uint8_t slot_b, std::uint32_t cost) {
  cost = std::min(cost, kLongest);
  line(a, slot_a) = {b, cost, slot_b};
  line(b, slot_b) = {a, cost, slot_a};
}

GrowingNetwork::Id GrowingNetwork::add(Id from, std::uint8_t slot, std::uint8_t arms, nav::Heading entry,
                                       std::uint32_t cost, Id junction) {
  const Id node = size();
  nodes_.push_back({from, junction, arms, entry, {}});
  if (from != kNone) connect(from, slot, node, 0, cost);
  return node;
}

GrowingNetwork::Id GrowingNetwork::addStation(Id from, std::uint8_t slot, std::uint8_t arms,
                                              nav::Heading entry, std::uint32_t cost) {
  return add(from, slot, arms, entry, cost, kNone);
}

GrowingNetwork::Id GrowingNetwork::addJunction(Id from, std::uint8_t slot, std::uint8_t arms,
                                               nav::Heading entry, const nav::Place& place,
                                               std::uint32_t cost) {
  junctions_.push_back({{}, place});
  const Id node = add(from, slot, arms, entry, cost, static_cast<Id>(junctions_.size() - 1));
  index(node, place);
  return node;
}

bool GrowingNetwork::join(Id a, std::uint8_t slot_a, Id b, std::uint8_t slot_b, std::uint32_t cost) {
  is_tree_ = false;
  connect(a, slot_a, b, slot_b, cost);
  return true;
}

bool GrowingNetwork::block(Id node, std::uint8_t slot) {
  const Line there = line(node, slot);
  if (there.to != kNone && there.to != kBlocked)
    line(there.to, static_cast<std::uint8_t>(there.back)).to = kBlocked;
  line(node, slot).to = kBlocked;
  return true;
}

}  // namespace robosim::cells
