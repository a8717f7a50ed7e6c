// Formats a map's graph as text, as JSON and for Graphviz: `robosim map graph`.
#pragma once

#include <string>

#include "sim/map/map.h"
#include "sim/map/true_graph.h"

namespace robosim::cli {

class JsonLines;

/// Returns a table of stations, and a table of junctions with their slots.
std::string graph_text(const map::Map& map, const map::Start& start, const map::TrueGraph& graph);

/// Formats the graph as robosim.graph/1, see docs/reference/maps.md.
std::string graph_json(const map::Start& start, const map::TrueGraph& graph);

/// Adds the graph's members `stations`, `junctions` and `unreachable`.
void add_graph(JsonLines& lines, const map::TrueGraph& graph);
/// Returns only the tables of graph_text.
std::string graph_tables(const map::TrueGraph& graph);

/// Returns an undirected graph for `dot -Tsvg`, laid out like the map; lines are labelled with their moves.
std::string graph_dot(const map::Map& map, const map::TrueGraph& graph);

}  // namespace robosim::cli
