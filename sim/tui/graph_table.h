// A graph of stations and junctions for people to read: lines of text.
#pragma once

#include <string>
#include <vector>

#include "sim/grid/true_graph.h"
#include "sim/tui/frame.h"

namespace robosim::tui {

/// "east".
const char* direction_word(grid::Direction d);

/// "7 stations, 5 junctions, 11 links; 1 cycle; 2 dead ends cannot be reached".
std::string graph_summary(const grid::TrueGraph& graph);

/// The tree that a depth-first walk makes of the graph, from station 1 on (else from junction 1). Links are
/// named by the direction in which they leave, and their moves:
///
///   S1 at 3,10
///   `- east 8: J1 at 11,10
///      |- south 9: S2 at 6,15
///      `- north 12: J2 at 15,10
///
/// A junction that stands above already is only named. Where that gets wider than `columns`, a table: who is
/// beside whom, one node a line, "J1 at 11,10: west 8 S1, south 9 S2, east 4 J2".
std::vector<std::string> graph_lines(const grid::TrueGraph& graph, int columns, Look look);

/// "S3", or "S3 dock" if the map names it.
std::string station_name(const grid::TrueGraph& graph, int number);
/// The station that a person means by its number ("3", "S3") or name; 0 = none.
int find_station(const grid::TrueGraph& graph, const std::string& answer);

}  // namespace robosim::tui
