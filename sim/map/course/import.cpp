#include "sim/map/course/import.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "sim/base/error.h"
#include "sim/base/utf8.h"
#include "sim/map/course/formats.h"

namespace robosim::course {
namespace {

// Reads all course formats except mazes.
Imported read_lines(std::string_view text, const std::string& file, const std::vector<NumberedLine>& lines) {
  const std::string_view first = lines.front().text;
  if (first.front() == '{' || first.front() == '[') {
    const nlohmann::json json = json_of(text, file);
    return json.is_object() && json.contains("tiles") ? read_rescue(json, file) : read_robotrace(json, file);
  }
  if (first.starts_with("#length")) return read_curvature(text, file);
  if (numbers_in(lines.front(), file).size() == 2)
    return first.find(',') == first.npos ? read_points(text, file) : read_curvature(text, file);
  throw InputError(
      {file, lines.front().number},
      "unknown kind of line: expected two numbers (a point, or a segment's length and curvature) or six (a "
      "maze's cell with its walls)");
}

Imported read_any(std::string_view text, const std::string& file, double walls_m) {
  if (text.find('\0') != text.npos)
    throw InputError({file}, "not a text file: expected a course as text, got zero bytes");
  const std::vector<NumberedLine> lines = lines_of(text);
  if (lines.empty()) throw InputError({file}, "the file is empty");
  const std::string_view first = lines.front().text;
  const bool is_json = first.front() == '{' || first.front() == '[';
  // A line without digits, such as the first line of a maze (+ and - alone), is not a number.
  const bool are_numbers = first.find_first_not_of("0123456789+-.eE,; \t") == first.npos &&
                           first.find_first_of("0123456789") != first.npos;
  if (!is_json && !are_numbers && !first.starts_with("#length")) return read_maze(text, file, walls_m);
  if (are_numbers && numbers_in(lines.front(), file).size() == 6)
    return read_maze_numbers(text, file, walls_m);
  if (walls_m > 0.0) throw InputError({file}, "walls require a maze, got another kind of course");
  return read_lines(text, file, lines);
}

}  // namespace

Imported import_course(std::string_view text, const std::string& file, const std::string& name,
                       double walls_m) {
  text = without_byte_order_mark(text);
  try {
    Imported imported = read_any(text, file, walls_m);
    imported.map.name = name;
    return imported;
  } catch (const InputError& error) {
    if (!error.place().file.empty()) throw;
    throw InputError({file}, error.message());  // an error of the whole course, without a line number
  }
}

}  // namespace robosim::course
