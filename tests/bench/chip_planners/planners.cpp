// robosim_bench_planners FOLDER [SEED]: measures each planner of firmware/src/nav on an emulated ATmega328P,
// in cycles, flash and RAM. FOLDER contains one image of chip.cpp for each planner. The build target
// chip_planners compiles the images and runs this program.
//
// A tree of n nodes grows from one line: a station chosen at random becomes a junction with two new stations,
// until there are n nodes. Then the nodes are numbered in preorder. The printed cycles are the mean over all
// ordered pairs of stations. Every path is compared with the true path. A wrong path ends the program with
// status 1.
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "hal/board/atmega328p.h"
#include "tests/conformance/bench.h"

namespace robosim {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// Returns the parents of nodes in preorder. The parent of node 0 is 0.
Bytes randomTree(unsigned nodes, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<std::vector<unsigned>> children = {{1}, {}};
  std::vector<unsigned> leaves = {1};
  while (children.size() < nodes) {
    unsigned& leaf = leaves[random() % leaves.size()];
    const auto first = static_cast<unsigned>(children.size());
    children[leaf] = {first, first + 1};
    children.resize(children.size() + 2);
    leaf = first;
    leaves.push_back(first + 1);
  }
  Bytes parents;
  std::vector<std::pair<unsigned, unsigned>> open = {{0, 0}};  // nodes to visit, and new ids of their parents
  while (!open.empty()) {
    const auto [node, parent] = open.back();
    open.pop_back();
    const auto id = static_cast<unsigned>(parents.size());
    parents.push_back(static_cast<std::uint8_t>(parent));
    for (auto child = children[node].rbegin(); child != children[node].rend(); ++child)
      open.emplace_back(*child, id);
  }
  return parents;
}

Bytes wayToRoot(const Bytes& parents, std::uint8_t node) {
  Bytes way = {node};
  while (node != 0) way.push_back(node = parents[node]);
  return way;
}

Bytes trueWay(const Bytes& parents, std::uint8_t from, std::uint8_t to) {
  Bytes up = wayToRoot(parents, from), down = wayToRoot(parents, to);
  std::uint8_t meet = 0;
  while (!up.empty() && !down.empty() && up.back() == down.back()) {
    meet = up.back();
    up.pop_back();
    down.pop_back();
  }
  up.push_back(meet);
  up.insert(up.end(), down.rbegin(), down.rend());
  return up;
}

/// Runs the chip, and exchanges data with it. The chip reads the tree from GPIOR1 and writes paths to GPIOR2.
/// The chip writes 1 to GPIOR0 when a search begins, and 2 when the search ends.
class Session final {
 public:
  Session(const Bytes& image, const Bytes& parents) : input_(parents), bench_(kAtmega328p, image) {
    input_[0] = static_cast<std::uint8_t>(parents.size());  // uses the root's entry: the root has no parent
    avr::Cpu& cpu = bench_.chip.cpu();
    cpu.on_write<&Session::mark>(kGpior0, this);
    cpu.on_read<&Session::read>(kGpior1, this);
    cpu.on_write<&Session::write>(kGpior2, this);
    if (bench_.run(kLimit) != avr::Chip::Stop::off)
      throw std::runtime_error("the program on the chip did not come to its end");
  }

  Bytes output;
  std::vector<avr::Cycle> spans;

 private:
  static constexpr avr::Cycle kLimit = 20'000'000'000;
  static constexpr avr::Address kGpior0 = 0x3E, kGpior1 = 0x4A, kGpior2 = 0x4B;

  void mark(avr::Address, std::uint8_t value) {
    if (value == 1) begin_ = bench_.chip.cycle();
    if (value == 2) spans.push_back(bench_.chip.cycle() - begin_);
  }
  std::uint8_t read(avr::Address) { return read_ < input_.size() ? input_[read_++] : std::uint8_t{0}; }
  void write(avr::Address, std::uint8_t value) { output.push_back(value); }

  Bytes input_;
  std::size_t read_ = 0;
  avr::Cycle begin_ = 0;
  conformance::Bench bench_;
};

struct Result {
  double cycles = 0, nodes = 0;
  unsigned table_bytes = 0, work_bytes = 0;
};

Result measure(const Bytes& image, const Bytes& parents) {
  const Session session(image, parents);
  const Bytes& out = session.output;
  Result result;
  result.table_bytes = out.at(0) + 256U * out.at(1);
  result.work_bytes = out.at(2) + 256U * out.at(3);
  std::size_t pairs = 0;
  for (std::size_t at = 4; at < out.size(); ++pairs) {
    const std::uint8_t from = out.at(at), to = out.at(at + 1), size = out.at(at + 3);
    const Bytes way = trueWay(parents, from, to);
    if (out[at + 2] != 0 || size != way.size() || at + 4 + size > out.size() ||
        !std::equal(way.begin(), way.end(), out.begin() + static_cast<std::ptrdiff_t>(at) + 4))
      throw std::runtime_error(fmt::format("wrong way from {} to {}", from, to));
    at += 4U + size;
    result.cycles += static_cast<double>(session.spans.at(pairs + 1) - session.spans[0]);
    result.nodes += size;
  }
  const std::size_t stations = parents.size() / 2 + 1;
  if (pairs != stations * (stations - 1)) throw std::runtime_error("pairs of stations are missing");
  result.cycles /= static_cast<double>(pairs);
  result.nodes /= static_cast<double>(pairs);
  return result;
}

Bytes readImage(const std::string& folder, const std::string& name) {
  const std::string path = folder + "/chip_" + name + ".bin";
  std::ifstream file(path, std::ios::binary);
  Bytes image{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (image.empty()) throw std::runtime_error(path + " cannot be read; build the target chip_planners");
  return image;
}

struct Planner {
  const char* name;
  const char* table;
};
constexpr Planner kPlanners[] = {{"bfs", "links"},       {"dfs", "links"},      {"iterative", "links"},
                                 {"pruned", "links"},    {"dijkstra", "links"}, {"climb", "parents"},
                                 {"interval", "parents"}};
constexpr unsigned kSizes[] = {26, 50, 100, 150, 200};
constexpr unsigned kCapacity = 200;  // chip.cpp's kNodes

void run(const std::string& folder, std::uint32_t seed) {
  fmt::print("Planners on an ATmega328P: mean cycles over all pairs of stations, trees of seed {}\n\n", seed);
  fmt::print("{:18} {:8}", "planner", "table");
  for (const unsigned size : kSizes) fmt::print(" {:>8}", fmt::format("n = {}", size));
  fmt::print(" {:>8} {:>19}\n", "flash", "RAM, bytes a node");
  double nodes[std::size(kSizes)] = {};
  for (const Planner& planner : kPlanners) {
    const Bytes image = readImage(folder, planner.name);
    const std::size_t without = readImage(folder, std::string("none_") + planner.table).size();
    fmt::print("{:18} {:8}", planner.name, planner.table);
    Result result;
    for (std::size_t i = 0; i < std::size(kSizes); ++i) {
      result = measure(image, randomTree(kSizes[i], seed));
      fmt::print(" {:8.0f}", result.cycles);
      nodes[i] = result.nodes;
    }
    fmt::print(" {:8} {:>19}\n", image.size() - without,
               fmt::format("{} + {} + 1", result.table_bytes / kCapacity, result.work_bytes / kCapacity));
  }
  fmt::print("{:27}", "nodes of a way, mean");
  for (const double mean : nodes) fmt::print(" {:8.1f}", mean);
  fmt::print(
      "\n\nPublished figures, on eight other trees (not measured here):\n"
      "{0:27} {1:>8} {2:>8} {3:>8} {2:>8} {4:>8} {2:>8} {5:>19}\n"
      "{6:27} {7:>8} {2:>8} {8:>8} {2:>8} {9:>8}\n"
      "{10:27} {11:>8} {2:>8} {12:>8} {2:>8} {13:>8}\n",
      "P-BFS as published", 5071, "", 11116, 13458, "10", "P-BFS tuned", 2587, 5173, 6173,
      "nodes of a way, mean", 6.9, 11.8, 13.6);
  fmt::print(
      "\nFlash: bytes the planner adds. RAM: table + work + path; the path has room for every node.\n"
      "pruned is prunedSearch(), interval is intervalWay(): the numbering was looked through before.\n");
}

}  // namespace
}  // namespace robosim

int main(int argc, char** argv) try {
  if (argc != 2 && argc != 3) {
    fmt::print(stderr, "usage: robosim_bench_planners FOLDER [SEED]\n");
    return 2;
  }
  robosim::run(argv[1], argc == 3 ? static_cast<std::uint32_t>(std::stoul(argv[2])) : 1);
} catch (const std::exception& error) {
  fmt::print(stderr, "robosim_bench_planners: {}\n", error.what());
  return 1;
}
