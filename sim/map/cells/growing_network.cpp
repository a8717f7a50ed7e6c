#include "sim/map/cells/growing_network.h"

namespace robosim::cells {
namespace {

// Contains the headings of a node's slots, two bits per slot. The index is 4 * arms + entry.
constexpr auto kHeadings = [] {
  std::array<std::uint8_t, 64> all{};
  for (unsigned arms = 0; arms < 16; ++arms) {
    for (unsigned entry = 0; entry < 4; ++entry) {
      unsigned slot = 0;
      for (unsigned i = 0; i < 4; ++i) {
        const unsigned heading = (entry + 2 - i) & 3;
        if ((arms >> heading & 1) != 0)
          all[arms * 4 + entry] |= static_cast<std::uint8_t>(heading << 2 * slot++);
      }
    }
  }
  return all;
}();

}  // namespace

std::uint8_t GrowingNetwork::headings_of(std::uint8_t arms, nav::Heading entry) {
  return kHeadings[(arms & 15u) * 4u + entry];
}

void GrowingNetwork::clear() {
  nodes_.clear();
  junctions_.clear();
  index_.clear();
  is_tree_ = true;
}

bool GrowingNetwork::join(Id a, std::uint8_t slot_a, Id b, std::uint8_t slot_b, std::uint32_t cost) {
  is_tree_ = false;
  cost = std::min(cost, kLongest);
  line(a, slot_a) = {b, cost, slot_b};
  line(b, slot_b) = {a, cost, slot_a};
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
