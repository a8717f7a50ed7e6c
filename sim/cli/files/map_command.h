// `robosim map check|show|graph|generate`: checks, draws and generates maps.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "sim/base/error.h"
#include "sim/cli/arguments.h"
#include "sim/map/picture.h"

namespace robosim::cli {

/// Reads each map (a path, or the name of a sample) and reports size, line, start, goal, stations, and
/// oddities. Errors go to `errors`, and the other maps are still checked. `start` has the form of --start;
/// "" = the map's start. With `json`, reports one JSON object for each map. Returns ok, or bad_input if any
/// map is invalid.
ExitStatus check_maps(const std::vector<std::string>& maps, const std::string& start, std::ostream& out,
                      std::ostream& errors, bool json = false);

/// Draws one map. The numbers of its stations depend on `start` ("" = the map's start). Throws InputError.
ExitStatus show_map(const std::string& map, const std::string& start, const map::PictureOptions& options,
                    std::ostream& out);

/// Returns the true graph of one map as text, JSON or for Graphviz. Throws InputError.
std::string graph_of_map(const MapArguments& arguments);

/// Performs the action of `arguments` and prints the result. A drawing fits the terminal. Returns the exit
/// status. Throws InputError.
int map_command(const MapArguments& arguments);
int generate_command(const GenerateArguments& arguments);

}  // namespace robosim::cli
