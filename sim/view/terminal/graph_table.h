// Formats a graph of stations and junctions as lines of text.
#pragma once

#include <string>
#include <vector>

#include "sim/map/true_graph.h"
#include "sim/view/terminal/frame.h"

namespace robosim::terminal {

/// Returns a word such as "east".
const char* direction_word(map::Direction d);

/// Returns "7 stations, 5 junctions, 11 links; 1 cycle; unreachable: 2 dead ends (3,4 5,6)".
std::string graph_summary(const map::TrueGraph& graph);

/// Returns the tree of a depth-first walk of the graph, from station 1, or from junction 1 if there are no
/// stations. Each link has its initial direction and its number of moves:
///
///   S1 at 3,10
///   `- east 8: J1 at 11,10
///      |- south 9: S2 at 6,15
///      `- north 12: J2 at 15,10
///
/// A junction that already appears above is only named. If the tree is wider than `columns`, returns a table
/// of neighbours, one node per line. Example: "J1 at 11,10: west 8 S1, south 9 S2, east 4 J2".
std::vector<std::string> graph_lines(const map::TrueGraph& graph, int columns, Look look);

/// Returns "S3", or "S3 dock" if the map names the station.
std::string station_name(const map::TrueGraph& graph, int number);
/// Returns the number of the station that `answer` names, by its number ("3", "S3") or its name; 0 = none.
int find_station(const map::TrueGraph& graph, const std::string& answer);

}  // namespace robosim::terminal
