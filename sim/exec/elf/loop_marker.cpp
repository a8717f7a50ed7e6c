#include "sim/exec/elf/loop_marker.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

namespace robosim::exec {
namespace {

using Addresses = std::set<std::uint32_t>;

const Step& at(const Steps& function, std::uint32_t address) {
  static const Step kNone;
  const auto step = function.find(address);
  return step == function.end() ? kNone : step->second;
}

Addresses reachable(const Steps& function, std::uint32_t from) {
  Addresses found;
  std::vector<std::uint32_t> open{from};
  while (!open.empty()) {
    const std::uint32_t address = open.back();
    open.pop_back();
    if (!function.contains(address) || !found.insert(address).second) continue;
    for (const std::uint32_t next : at(function, address).next) open.push_back(next);
  }
  return found;
}

/// Returns the cycles among `nodes`. In a cycle, each instruction can reach all other instructions. Uses
/// Tarjan's algorithm with an explicit stack, since recursion could be too deep for long functions.
std::vector<Addresses> cycles(const Steps& function, const Addresses& nodes) {
  struct Node {
    std::uint32_t address;
    const std::vector<std::uint32_t>* next;
    std::size_t index = 0, low = 0;  // numbered from 1; 0 = not visited
    bool on_path = false;
  };
  struct Visit {
    std::size_t node;
    std::size_t child = 0;
  };
  std::vector<Node> all;  // sorted by address
  all.reserve(nodes.size());
  for (const std::uint32_t address : nodes) all.push_back({address, &at(function, address).next});
  const auto place_of = [&](std::uint32_t address) {
    const auto place =
        std::lower_bound(all.begin(), all.end(), address,
                         [](const Node& node, std::uint32_t wanted) { return node.address < wanted; });
    return place != all.end() && place->address == address ? static_cast<std::size_t>(place - all.begin())
                                                           : all.size();
  };
  std::size_t visited = 0;
  std::vector<std::size_t> path;
  std::vector<Visit> visits;
  std::vector<Addresses> found;
  const auto close = [&](const Node& root) {
    const auto first =
        std::find(path.rbegin(), path.rend(), static_cast<std::size_t>(&root - all.data())).base() - 1;
    const bool is_cycle = path.end() - first > 1 ||
                          std::find(root.next->begin(), root.next->end(), root.address) != root.next->end();
    Addresses members;
    for (auto member = first; member != path.end(); ++member) {
      all[*member].on_path = false;
      if (is_cycle) members.insert(all[*member].address);
    }
    path.erase(first, path.end());
    if (is_cycle) found.push_back(std::move(members));
  };
  for (std::size_t start = 0; start < all.size(); ++start) {
    if (all[start].index != 0) continue;
    visits.push_back({start});
    while (!visits.empty()) {
      Visit& visit = visits.back();
      Node& node = all[visit.node];
      if (visit.child == 0 && node.index == 0) {
        node.index = node.low = ++visited;
        path.push_back(visit.node);
        node.on_path = true;
      }
      if (visit.child < node.next->size()) {
        const std::size_t to = place_of((*node.next)[visit.child++]);
        if (to == all.size()) continue;
        if (all[to].index == 0) {
          visits.push_back({to});
        } else if (all[to].on_path) {
          node.low = std::min(node.low, all[to].index);
        }
        continue;
      }
      if (node.low == node.index) close(node);
      const std::size_t low = node.low;
      visits.pop_back();
      if (!visits.empty()) {
        Node& before = all[visits.back().node];
        before.low = std::min(before.low, low);
      }
    }
  }
  return found;
}

/// Returns whether a cycle has no effect, because it contains only jumps.
bool is_idle(const Steps& function, const Addresses& cycle) {
  return std::all_of(cycle.begin(), cycle.end(),
                     [&](std::uint32_t address) { return at(function, address).kind == Step::Kind::jump; });
}

/// Returns whether a cycle has an exit, or has no effect.
bool is_left(const Steps& function, const Addresses& cycle) {
  return is_idle(function, cycle) || std::any_of(cycle.begin(), cycle.end(), [&](std::uint32_t address) {
           const auto& next = at(function, address).next;
           return std::any_of(next.begin(), next.end(),
                              [&](std::uint32_t to) { return !cycle.contains(to); });
         });
}

/// Returns the instructions at which a cycle is entered.
Addresses heads_of(const Steps& function, const Addresses& reached, std::uint32_t entry,
                   const Addresses& cycle) {
  Addresses heads;
  if (cycle.contains(entry)) heads.insert(entry);
  for (const std::uint32_t from : reached) {
    if (cycle.contains(from)) continue;
    for (const std::uint32_t to : at(function, from).next)
      if (cycle.contains(to)) heads.insert(to);
  }
  return heads;
}

Addresses without(Addresses set, std::uint32_t address) {
  set.erase(address);
  return set;
}

bool meet(const Addresses& a, const Addresses& b) {
  return std::any_of(a.begin(), a.end(), [&](std::uint32_t address) { return b.contains(address); });
}

std::optional<std::uint32_t> mark_by_code_outside(const Steps& function, const Addresses& cycle,
                                                  const Addresses& heads, const Addresses& outside) {
  Addresses inner, within;
  for (const std::uint32_t address : cycle)
    if (!outside.contains(address)) within.insert(address);
  for (const Addresses& loop : cycles(function, within)) inner.insert(loop.begin(), loop.end());
  const auto is_mark = [&](std::uint32_t address) {
    if (inner.contains(address)) return false;
    const auto rest = cycles(function, without(cycle, address));
    return std::none_of(rest.begin(), rest.end(), [&](const Addresses& loop) { return meet(loop, outside); });
  };
  for (const Addresses& candidates : {heads, outside}) {
    const auto mark = std::find_if(candidates.begin(), candidates.end(), is_mark);
    if (mark != candidates.end()) return *mark;
  }
  return std::nullopt;
}

std::optional<std::uint32_t> mark_by_shape(const Steps& function, const Addresses& cycle,
                                           const Addresses& heads, const LineOf& line) {
  if (heads.size() != 1) return std::nullopt;
  const std::uint32_t head = *heads.begin();
  const auto back = std::count_if(cycle.begin(), cycle.end(), [&](std::uint32_t from) {
    const auto& next = at(function, from).next;
    return std::find(next.begin(), next.end(), head) != next.end();
  });
  if (back != 1) return std::nullopt;
  const auto lines = [&](const Addresses& of) {
    std::pair<int, int> span{0, 0};
    for (const std::uint32_t address : of) {
      const int here = line ? line(address) : 0;
      if (here == 0) continue;
      span.first = span.first == 0 ? here : std::min(span.first, here);
      span.second = std::max(span.second, here);
    }
    return span;
  };
  const auto loops = cycles(function, without(cycle, head));
  if (loops.empty()) return head;
  const auto all = lines(cycle);
  const bool wide =
      std::any_of(loops.begin(), loops.end(), [&](const Addresses& loop) { return lines(loop) == all; });
  return wide ? std::nullopt : std::optional(head);
}

struct Loop {
  Addresses cycle;
  Addresses outside;  ///< calls and branches of the cycle that are outside loop()
};

/// An inlined loop() may contain loops that never return to main(), such as a final `for (;;) {}`. Drops
/// these loops. Returns false if they cannot be distinguished from main()'s loop.
bool keep_those_of_main(const Steps& function, std::vector<Loop>& loops) {
  const auto erase_if_others = [&](const auto& is) {
    if (!std::all_of(loops.begin(), loops.end(), is)) std::erase_if(loops, is);
  };
  erase_if_others([](const Loop& loop) { return loop.outside.empty(); });
  erase_if_others([&](const Loop& loop) { return is_idle(function, loop.cycle); });
  return std::none_of(loops.begin(), loops.end(), [&](const Loop& from) {
    const Addresses behind = reachable(function, *from.cycle.begin());
    return std::any_of(loops.begin(), loops.end(), [&](const Loop& to) {
      return &to != &from && to.outside.empty() && behind.contains(*to.cycle.begin());
    });
  });
}

}  // namespace

LoopMarks loop_marks_of(const Steps& function, std::uint32_t entry, const Inside& inside,
                        const LineOf& line) {
  const Addresses reached = reachable(function, entry);
  std::vector<Loop> loops;
  for (Addresses& cycle : cycles(function, reached)) {
    if (inside ? std::none_of(cycle.begin(), cycle.end(), inside) : is_left(function, cycle)) continue;
    Loop& loop = loops.emplace_back(Loop{std::move(cycle), {}});
    for (const std::uint32_t address : loop.cycle)
      if (inside && !inside(address) && at(function, address).kind == Step::Kind::call_or_branch)
        loop.outside.insert(address);
  }
  if (inside && !keep_those_of_main(function, loops)) return {};
  LoopMarks rounds;
  for (const auto& [cycle, outside] : loops) {
    const Addresses heads = heads_of(function, reached, entry, cycle);
    const auto mark = outside.empty() ? mark_by_shape(function, cycle, heads, line)
                                      : mark_by_code_outside(function, cycle, heads, outside);
    if (!mark) return {};
    rounds.first.insert(rounds.first.end(), heads.begin(), heads.end());
    rounds.each.push_back(*mark);
  }
  return rounds;
}

}  // namespace robosim::exec
