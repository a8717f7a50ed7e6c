// Imports arbitrary bytes as a course of another tool. Either the file is rejected with a message that names
// it, or it becomes a map: the map can be written, read again and driven on.
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "sim/map/course/import.h"
#include "sim/map/map_writer.h"
#include "sim/map/network.h"
#include "sim/map/path_survey.h"
#include "tests/fuzz/require.h"

namespace {

using namespace robosim;

constexpr std::size_t kLargeFloor = 4'000'000;  // in cells; larger floors are allowed, but slow

void drive_on(const map::Map& map) {
  if (map.cells.size() > kLargeFloor) return;
  const std::string written = map::write_map(map);
  const map::Map read = map::parse_map(written, "written.map");
  require(read.cells == map.cells, "the cells are those that were written");
  require(read.course.paths.size() == map.course.paths.size(), "and so are the paths");
  require(read.course.marks.size() == map.course.marks.size(), "and the marks");
  map::trace_network(read, map::default_start(read));
  for (const map::Path& path : read.course.paths)
    if (path.length() < 100.0) map::survey_path(path, read.line_m);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    drive_on(course::import_course({reinterpret_cast<const char*>(data), size}, "fuzzed.txt", "fuzzed").map);
  } catch (const InputError& error) {
    require(error.place().file == "fuzzed.txt" || error.place().file == "written.map",
            "errors name the file");
    require(!error.message().empty(), "errors say something");
  }
  return 0;
}
