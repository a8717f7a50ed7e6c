// Formats a map's graph as text, as JSON and for Graphviz: `robosim map graph`.
#pragma once

#include <string>

#include "sim/grid/map.h"
#include "sim/grid/true_graph.h"

namespace robosim::cli {

class JsonLines;

/// Returns a table of stations, and a table of junctions with their slots.
std::string graph_text(const grid::Map& map, const grid::Start& start, const grid::TrueGraph& graph);

/// Formats the graph as robosim.graph/1, see docs/reference/maps.md.
std::string graph_json(const grid::Start& start, const grid::TrueGraph& graph);

/// Adds the graph's members `stations`, `junctions` and `unreachable`.
void add_graph(JsonLines& lines, const grid::TrueGraph& graph);
/// Returns only the tables of graph_text.
std::string graph_tables(const grid::TrueGraph& graph);

/// Returns an undirected graph for `dot -Tsvg`, laid out like the map; lines are labelled with their moves.
std::string graph_dot(const grid::Map& map, const grid::TrueGraph& graph);

}  // namespace robosim::cli
