// Runs one path planner of firmware/src/nav on an ATmega328P, for all pairs of stations of one tree. This
// program is compiled once for each planner; a macro such as PLANNER_bfs selects the planner. PLANNER_none
// compiles the program without a planner, once with each kind of table (see TABLE_parents). The flash of a
// planner is the difference in size from the program without a planner.
//
// The program exchanges data with planners.cpp through general-purpose registers. Each read of GPIOR1 returns
// the next byte of the tree (size, then the parents of nodes 1, 2, …). Each write to GPIOR2 sends a byte of
// the result. GPIOR0 = 1 begins a measurement, and GPIOR0 = 2 ends it.
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>

#include "firmware/src/nav/Dijkstra.h"
#include "firmware/src/nav/LinkTable.h"
#include "firmware/src/nav/PrunedBfs.h"
#include "firmware/src/nav/Search.h"
#include "firmware/src/nav/TreeWay.h"

static constexpr uint8_t kNodes = 200;

#if defined(TABLE_parents)
typedef nav::ParentTable<kNodes> Table;
#else
typedef nav::LinkTable<kNodes, 3> Table;
#endif

#if defined(PLANNER_dijkstra)
typedef nav::FixedDijkstraWork<kNodes> Work;
static constexpr uint16_t kWorkBytes = sizeof(Work);
#elif defined(PLANNER_none) || defined(PLANNER_climb)
#define NEEDS_NO_WORK
static constexpr uint16_t kWorkBytes = 0;
#else
typedef nav::FixedWork<kNodes> Work;
static constexpr uint16_t kWorkBytes = sizeof(Work);
#endif

static Table table;
static nav::FixedPath<kNodes> path;
#if !defined(NEEDS_NO_WORK)
static Work work;
#endif

static void prepare() {
#if defined(PLANNER_interval)
  nav::intervals(table, work.room(kNodes));
#endif
}

__attribute__((noinline)) static nav::Plan plan(uint8_t from, uint8_t to) {
#if defined(PLANNER_bfs)
  return nav::bfs(table, from, to, path, work);
#elif defined(PLANNER_dfs)
  return nav::dfs(table, from, to, path, work);
#elif defined(PLANNER_iterative)
  return nav::iterative(table, from, to, path, work);
#elif defined(PLANNER_pruned)
  return nav::prunedSearch(table, from, to, path, work);
#elif defined(PLANNER_climb)
  return nav::climb(table, from, to, path);
#elif defined(PLANNER_interval)
  return nav::intervalWay(table, from, to, path, work.room(kNodes));
#elif defined(PLANNER_dijkstra)
  return nav::dijkstra(table, from, to, path, work);
#else
  path.setSize(from == to);
  return nav::Plan::no_way;
#endif
}

static uint8_t stations[kNodes];  // not packed into bits, because the RAM of this array is not measured

static void readTree() {
  const uint8_t size = GPIOR1;
#if defined(TABLE_parents)
  table.add(Table::kNone);
#else
  table.clear(size);
#endif
  for (uint8_t node = 0; node < size; ++node) stations[node] = node != 0;
  for (uint8_t node = 1; node < size; ++node) {
    const uint8_t parent = GPIOR1;
#if defined(TABLE_parents)
    table.add(parent);
#else
    uint8_t slot = parent != 0;  // the root is a station: its only child is in slot 0
    while (table.link(parent, slot) != Table::kNone) ++slot;
    table.setLink(parent, slot, node);
    table.setLink(node, 0, parent);
#endif
    stations[parent] = 0;
  }
  stations[0] = 1;
}

static void send16(uint16_t value) {
  GPIOR2 = static_cast<uint8_t>(value);
  GPIOR2 = static_cast<uint8_t>(value >> 8);
}

int main() {
  readTree();
  prepare();
  send16(sizeof(Table));
  send16(kWorkBytes);
  GPIOR0 = 1;  // an empty measurement: planners.cpp subtracts its time from the other times
  GPIOR0 = 2;
  for (uint8_t from = 0; from < table.size(); ++from) {
    for (uint8_t to = 0; to < table.size(); ++to) {
      if (from == to || !stations[from] || !stations[to]) continue;
      GPIOR0 = 1;
      const nav::Plan result = plan(from, to);
      GPIOR0 = 2;
      GPIOR2 = from;
      GPIOR2 = to;
      GPIOR2 = static_cast<uint8_t>(result);
      GPIOR2 = path.size();
      for (uint8_t i = 0; i < path.size(); ++i) GPIOR2 = path[i];
    }
  }
  cli();
  sleep_enable();
  sleep_cpu();
}
