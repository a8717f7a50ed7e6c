// Reads arbitrary bytes as a map file. Either the file is rejected with a message that names the place, or it
// is a valid map: it can be written, read again, walked, and converted to a graph and to geometry.
#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

#include "sim/base/error.h"
#include "sim/map/map.h"
#include "sim/map/map_parser.h"
#include "sim/map/map_writer.h"
#include "sim/map/network.h"
#include "sim/map/path_survey.h"
#include "sim/map/picture.h"
#include "sim/map/stripes.h"
#include "sim/map/true_graph.h"
#include "tests/fuzz/require.h"

namespace {

using namespace robosim;
using namespace robosim::map;

std::string outcome(std::string_view text, std::size_t piece) {
  try {
    MapParser parser("fuzz.map", text.size());
    for (std::size_t i = 0; i < text.size(); i += piece) parser.feed(text.substr(i, piece));
    return write_map(parser.finish());
  } catch (const InputError& error) {
    require(error.place().file == "fuzz.map", "errors name the file");
    require(!error.message().empty(), "errors say something");
    return error.what();
  }
}

// Checks that each point of a path is on one of the stripes that the map has for the path.
void use_course(const Map& map, const Start& start) {
  const Path& path = map.course.paths.front();
  if (map.cells.size() > 4096 || map.cell_m < 0.01 || path.length() > 50.0) return;
  const Stripes stripes(map, 0.1);
  require(length(stripes.pose_of(start).heading) < 1.0 + 1e-9, "a direction");
  for (double along = 0.0; along < path.length(); along += path.length() / 16) {
    double nearest = 1e9;
    for (const Stripe& stripe : stripes.all())
      nearest = std::min(nearest, distance(stripe, path.at(along, false).position));
    require(nearest < 1e-6, "every point of a path is on a stripe");
  }
  survey_path(path, map.line_m);
}

void use(const Map& map) {
  require(map.cells.size() == static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height),
          "cells");
  Start start;
  try {
    start = default_start(map);
  } catch (const InputError&) {
    return;  // the map has no line
  }
  const Network network = trace_network(map, start);
  if (start.on_path) return use_course(map, start);
  const TrueGraph graph = true_graph(map, start);
  require(graph.junctions.size() == network.junctions.size(), "the graph has the junctions of the walk");
  require(graph.stations.size() <= network.stations.size(),
          "the graph has no stations but those of the walk");
  require(difference(graph, graph).empty(), "a graph is equal to itself");
  require(!draw(map, network, start, {80, 40, false}).empty(), "a picture");
  if (map.cells.size() > 4096 || map.cell_m < 0.01) return;  // the geometry takes time for each cell
  const Stripes stripes(map, 0.1);
  for (std::size_t i = 0; i < map.cells.size(); ++i) {
    const CellAt cell = map.cell_at(i);
    if (!is_line(map.at(cell))) continue;
    double nearest = 1e9;
    for (const Stripe& stripe : stripes.all())
      nearest = std::min(nearest, distance(stripe, stripes.point_of(cell)));
    require(nearest < 1e-6, "every line cell stands for a point of the line");
    if (i > 64) break;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const std::size_t piece = size ? 1 + data[size / 2] % 61u : 1;
  const std::string whole = outcome(text, size + 1);
  require(outcome(text, piece) == whole, "a map is the same in whatever pieces it arrives");
  try {
    const Map map = parse_map(text, "fuzz.map");
    require(write_map(parse_map(write_map(map), "fuzz.map")) == write_map(map), "a written map is read back");
    use(map);
  } catch (const InputError& error) {
    require(whole == error.what(), "reading and parsing agree");
  }
  return 0;
}
