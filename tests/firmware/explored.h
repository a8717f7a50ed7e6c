// Reads the graph that AiNavigator has explored.
#pragma once

#include <robosim/testing.h>

#include <cstdint>
#include <vector>

#include "firmware/src/nav/FixedNetwork.h"

namespace robosim::testing {

/// Returns AiNavigator's map from the EEPROM, or an empty one if the map is missing or damaged.
inline nav::FixedNetwork<60> map_in(const std::vector<std::uint8_t>& eeprom) {
  struct Source {
    const std::vector<std::uint8_t>& bytes;
    std::size_t at = 0;
    std::uint8_t get() { return bytes[at++]; }
  } source{eeprom};
  nav::FixedNetwork<60> network;
  network.load(source);
  return network;
}

inline Graph explored(const std::vector<std::uint8_t>& eeprom) {
  const nav::FixedNetwork<60> network = map_in(eeprom);
  Graph graph;
  graph.nodes.resize(network.size());
  for (std::uint8_t node = 0; node < network.size(); ++node) {
    for (std::uint8_t slot = 0; slot < nav::slots(network, node); ++slot) {
      const std::uint8_t other = network.link(node, slot);
      graph.nodes[node].arms.push_back(other == network.kBlocked || other == network.kNone
                                           ? Graph::End{}
                                           : Graph::End{other, network.backSlot(node, slot)});
    }
  }
  return graph;
}

}  // namespace robosim::testing
