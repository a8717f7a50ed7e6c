#include "firmware/src/nav/FixedNetwork.h"
#include "firmware/src/nav/FixedTree.h"

#include <gtest/gtest.h>

#include <vector>

#include "firmware/src/nav/Explorer.h"
#include "firmware/src/nav/Search.h"
#include "random_floor.h"

namespace nav_test {
namespace fixed_network_test {

typedef nav::FixedNetwork<60> Map;
typedef nav::FixedTree<> Tree;
typedef std::vector<uint8_t> Bytes;

struct Sink {
  Bytes bytes;
  void put(uint8_t byte) { bytes.push_back(byte); }
};

/// An EEPROM that holds `bytes`, and 0xFF after them.
struct Source {
  const Bytes& bytes;
  size_t at = 0;
  uint8_t get() { return at < bytes.size() ? bytes[at++] : 0xFF; }
};

template <class Network>
Bytes saved(const Network& network) {
  Sink sink;
  network.save(sink);
  return sink.bytes;
}

template <class Network>
bool load(Network& network, const Bytes& bytes) {
  Source source{bytes};
  return network.load(source);
}

template <class Walker, class Network>
nav::ScanState explore(Floor& floor, Stand start, Network& network) {
  Walker walker(floor, start);
  nav::Explorer<Walker, Network> explorer(walker, network);
  while (explorer.step()) {
  }
  return explorer.state();
}

template <class Network>
void expectSame(const Network& a, const Network& b) {
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(a.isTree(), b.isTree());
  EXPECT_EQ(a.allOpen(), b.allOpen());
  for (uint8_t node = 0; node < a.size(); ++node) {
    EXPECT_EQ(a.parent(node), b.parent(node));
    EXPECT_EQ(a.arms(node), b.arms(node));
    EXPECT_EQ(a.entry(node), b.entry(node));
    ASSERT_EQ(a.isStation(node), b.isStation(node));
    for (uint8_t slot = 0; slot < nav::slots(a, node); ++slot) {
      EXPECT_EQ(a.link(node, slot), b.link(node, slot));
      EXPECT_EQ(a.backSlot(node, slot), b.backSlot(node, slot));
      EXPECT_EQ(a.cost(node, slot), b.cost(node, slot));
    }
    if (!a.isStation(node)) {
      EXPECT_EQ(a.place(node).x, b.place(node).x);
      EXPECT_EQ(a.place(node).y, b.place(node).y);
    }
  }
}

/// Returns a ring of junctions. Each junction also has a line to a station of its own.
Floor ring(int junctions) {
  Floor floor;
  for (int i = 0; i < junctions; ++i) floor.addNode();
  for (int i = 0; i < junctions; ++i) floor.join({i, 1}, {(i + 1) % junctions, 3});
  for (int i = 0; i < junctions; ++i) floor.join({i, 0}, {floor.addNode(), 2});
  return floor;
}

/// Returns a row of junctions with a station at each end. Each junction also has a line to its own station.
/// The floor therefore has 2 * junctions + 2 nodes.
Floor comb(int junctions) {
  Floor floor;
  for (int i = 0; i < junctions + 2; ++i) floor.addNode();
  for (int i = 0; i <= junctions; ++i) floor.join({i, 1}, {i + 1, 3});
  for (int i = 1; i <= junctions; ++i) floor.join({i, 0}, {floor.addNode(), 2});
  return floor;
}

TEST(PackedCost, IsExactBelow128AndThreePercentOffAtMostBeyond) {
  uint32_t last = 0;
  for (uint32_t cost = 0; cost <= 31744; ++cost) {
    const uint32_t kept = nav::unpackCost(nav::packCost(cost));
    if (cost < 128) {
      EXPECT_EQ(kept, cost);
    }
    EXPECT_LE(kept > cost ? kept - cost : cost - kept, cost / 32 + 1) << cost;
    EXPECT_GE(kept, last);
    last = kept;
  }
  EXPECT_EQ(nav::unpackCost(nav::packCost(31745)), 31744);
  EXPECT_EQ(nav::unpackCost(nav::packCost(4000000000u)), 31744);
}

TEST(FixedNetwork, HoldsATreeOf200NodesAndRefusesOneMore) {
  Floor full = comb(99);
  ASSERT_EQ(full.nodes.size(), 200u);
  Map map;
  EXPECT_EQ((explore<SeeingWalker>(full, {{0, 1}}, map)), nav::ScanState::complete);
  EXPECT_EQ(map.size(), 200);
  Tree tree;
  EXPECT_EQ((explore<BlindWalker>(full, {{0, 1}}, tree)), nav::ScanState::complete);
  EXPECT_EQ(tree.size(), 200);

  full.join({50, 2}, {full.addNode(), 0});
  EXPECT_EQ((explore<SeeingWalker>(full, {{0, 1}}, map)), nav::ScanState::full);
  EXPECT_EQ(map.size(), 200);
  EXPECT_EQ((explore<BlindWalker>(full, {{0, 1}}, tree)), nav::ScanState::full);
  EXPECT_EQ(tree.size(), 200);
}

TEST(FixedNetwork, Holds64JunctionsInACycleAndRefusesOneMore) {
  Floor full = ring(64);
  Map map;
  EXPECT_EQ((explore<SeeingWalker>(full, {{64, 2}}, map)), nav::ScanState::complete);
  EXPECT_EQ(map.junctions(), 64);
  EXPECT_FALSE(map.isTree());
  Floor more = ring(65);
  EXPECT_EQ((explore<SeeingWalker>(more, {{65, 2}}, map)), nav::ScanState::full);
  EXPECT_TRUE(map.isTree()) << "the line that closes the ring is not known";
}

TEST(FixedNetwork, Holds64JunctionsWithFourArmsAllJoined) {
  // The floor is a torus of 8 by 8 junctions. Of its 128 lines, 63 form the scan's spanning tree, and 65
  // close cycles.
  Floor floor;
  for (int i = 0; i < 64; ++i) floor.addNode({1000 * (i % 8), 1000 * (i / 8)});
  for (int i = 0; i < 64; ++i) {
    floor.join({i, 1}, {i / 8 * 8 + (i + 1) % 8, 3});
    floor.join({i, 2}, {(i + 8) % 64, 0});
  }
  Map map;
  EXPECT_EQ((explore<SeeingWalker>(floor, {{0, 1}}, map)), nav::ScanState::complete);
  EXPECT_EQ(map.size(), 64);
  EXPECT_LE(saved(map).size(), 1024u);
  Map loaded;
  ASSERT_TRUE(load(loaded, saved(map)));
  expectSame(map, loaded);
}

TEST(FixedNetwork, RefusesAPlaceThatItCannotKeep) {
  Map map;
  map.clear();
  EXPECT_EQ(map.addJunction(Map::kNone, 0, 7, 0, {32768, 0}, 0), Map::kNone);
  EXPECT_EQ(map.addJunction(Map::kNone, 0, 7, 0, {0, -32769}, 0), Map::kNone);
  EXPECT_EQ(map.addJunction(Map::kNone, 0, 7, 0, {32767, -32768}, 0), 0);
  EXPECT_EQ(map.find({32767, -32768}), 0);
  EXPECT_EQ(map.find({-2147483647 - 1, 2147483647}), Map::kNone);
}

TEST(FixedNetwork, FindsTheNearestPlaceLessThanTheToleranceAway) {
  Map map;
  map.clear();
  map.addJunction(Map::kNone, 0, 7, 0, {0, 0}, 0);
  map.addJunction(0, 1, 7, 0, {100, 0}, 1);
  EXPECT_EQ(map.find({40, 10}), 0);
  EXPECT_EQ(map.find({60, 10}), 1);
  EXPECT_EQ(map.find({0, 60}), Map::kNone);
  EXPECT_EQ(map.find({-59, 59}), 0);
}

TEST(FixedTree, KeepsSixteenBlockedArms) {
  Floor floor = comb(40);
  Tree tree;
  for (int blocked : {16, 17}) {
    for (int i = 0; i < blocked; ++i) floor.lines[45 + i].blocked = true;  // lines to stations along the row
    EXPECT_EQ((explore<BlindWalker>(floor, {{0, 1}}, tree)),
              blocked == 16 ? nav::ScanState::complete : nav::ScanState::full);
  }
}

// 0x29B1 is the check value of CRC-16/CCITT-FALSE in catalogues of checksums. With another checksum, stored
// maps would no longer be readable.
TEST(Record, HasTheChecksumThatItSays) {
  std::uint16_t crc = 0xFFFF;
  for (const char c : std::string("123456789")) crc = nav::crc16(crc, static_cast<std::uint8_t>(c));
  EXPECT_EQ(crc, 0x29B1);
}

TEST(Record, BringsBackWhatWasSaved) {
  for (uint32_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    Floor floor = dice.oneIn(2) ? randomTree(dice, 2 + dice.below(199), true)
                                : randomNet(dice, 1 + dice.below(64), dice.below(4) * 10);
    if (dice.oneIn(2)) blockSome(dice, floor, 15);
    Map map, loaded;
    ASSERT_EQ((explore<SeeingWalker>(floor, randomStand(dice, floor), map)), nav::ScanState::complete);
    for (int i = map.size() == 0 ? 0 : dice.below(4); i > 0; --i) {
      const int node = dice.below(map.size());
      if (nav::slots(map, node) > 0) map.block(node, dice.below(nav::slots(map, node)));
    }
    const Bytes bytes = saved(map);
    EXPECT_LE(bytes.size(), 1024u);
    ASSERT_TRUE(load(loaded, bytes));
    expectSame(map, loaded);
    if (HasFailure()) return;
  }
}

TEST(Record, OfATreeBringsBackWhatWasSaved) {
  Floor floor = comb(99);
  floor.lines[120].blocked = true;
  Tree tree, loaded;
  ASSERT_EQ((explore<BlindWalker>(floor, {{0, 1}}, tree)), nav::ScanState::complete);
  ASSERT_TRUE(load(loaded, saved(tree)));
  expectSame(tree, loaded);
  Map map;
  EXPECT_FALSE(load(map, saved(tree))) << "another kind of record";
}

TEST(Record, OfFullStorageFitsAnEeprom) {
  Floor floor = comb(99);
  Map map;
  ASSERT_EQ((explore<SeeingWalker>(floor, {{0, 1}}, map)), nav::ScanState::complete);
  int blocked = 0;
  while (map.addStation(0, 0, 1, 2, 0) != Map::kNone) ADD_FAILURE() << "not full";
  for (uint8_t node = 0; node < 200; ++node)  // as if the scan had met obstacles
    if (!map.isStation(node) && map.block(node, 3)) ++blocked;
  EXPECT_EQ(blocked, 31);
  EXPECT_LE(saved(map).size(), 1024u);
}

TEST(Record, WithAnyByteDamagedIsRefusedAndLeavesNothing) {
  Dice dice(5);
  Floor floor = randomNet(dice, 12, 20);
  Map map, loaded;
  ASSERT_EQ((explore<SeeingWalker>(floor, {{0, 1}}, map)), nav::ScanState::complete);
  const Bytes whole = saved(map);
  for (size_t i = 0; i < whole.size(); ++i) {
    for (int change = 1; change < 256; ++change) {
      Bytes bytes = whole;
      bytes[i] = static_cast<uint8_t>(bytes[i] ^ change);
      ASSERT_FALSE(load(loaded, bytes)) << "byte " << i;
      ASSERT_EQ(loaded.size(), 0);
    }
    ASSERT_FALSE(load(loaded, Bytes(whole.begin(), whole.begin() + i))) << "cut off at " << i;
  }
  EXPECT_FALSE(load(loaded, Bytes(1024, 0xFF))) << "an empty EEPROM";
  EXPECT_FALSE(load(loaded, Bytes(1024, 0)));
  EXPECT_TRUE(load(loaded, whole));
}

/// Expects that a network that was loaded from arbitrary bytes is harmless. Every id must be valid, and every
/// function must return.
template <class Network>
void expectHarmless(const Network& network) {
  nav::FixedPath<200> path;
  nav::FixedWork<200> work;
  ASSERT_LE(network.size(), 200);
  for (uint8_t node = 0; node < network.size(); ++node) {
    if (node > 0) {
      ASSERT_LT(network.parent(node), node);
    }
    for (uint8_t slot = 0; slot < nav::slots(network, node); ++slot) {
      const uint8_t next = network.link(node, slot);
      if (next == Network::kNone || next == Network::kBlocked) continue;
      ASSERT_LT(next, network.size());
      const uint8_t back = network.backSlot(node, slot);
      ASSERT_LT(back, nav::slots(network, next));
      ASSERT_EQ(network.link(next, back), node);
      nav::headingOf(network, node, slot);
      network.cost(node, slot);
    }
  }
  if (network.size() > 0) {
    nav::bfs(network, uint8_t(0), uint8_t(network.size() - 1), path, work);
  }
}

TEST(Record, ThatIsWrongButWellSignedLeadsNobodyAstray) {
  int accepted = 0, refused = 0;
  for (uint32_t seed = 0; seed < 8; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    Floor floor = randomNet(dice, 8, 20);
    blockSome(dice, floor, 6);
    Map map, loaded;
    ASSERT_EQ((explore<SeeingWalker>(floor, {{0, 1}}, map)), nav::ScanState::complete);
    const Bytes whole = saved(map);
    for (size_t i = 0; i + 2 < whole.size(); ++i) {
      for (int change = 1; change < 256; ++change) {
        Bytes bytes = whole;
        bytes[i] = static_cast<uint8_t>(bytes[i] ^ change);
        uint16_t crc = 0xFFFF;
        for (size_t k = 0; k + 2 < bytes.size(); ++k) crc = nav::crc16(crc, bytes[k]);
        bytes[bytes.size() - 2] = static_cast<uint8_t>(crc >> 8);
        bytes[bytes.size() - 1] = static_cast<uint8_t>(crc);
        if (!load(loaded, bytes)) {
          ++refused;
          ASSERT_EQ(loaded.size(), 0);
          continue;
        }
        ++accepted;
        expectHarmless(loaded);
        if (HasFatalFailure()) {
          ADD_FAILURE() << "byte " << i << " is " << +bytes[i] << " instead of " << +whole[i];
          return;
        }
      }
    }
  }
  EXPECT_GT(accepted, 1000);
  EXPECT_GT(refused, 1000);
}

}  // namespace fixed_network_test
}  // namespace nav_test
