#include "sim/cli/files/map_import.h"

#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <ostream>
#include <sstream>
#include <system_error>

#include "sim/base/file.h"
#include "sim/cli/files/map_command.h"
#include "sim/course/import.h"
#include "sim/grid/map_writer.h"

namespace robosim::cli {
namespace fs = std::filesystem;

ExitStatus import_map(const ImportArguments& arguments, std::ostream& out) {
  constexpr std::size_t kMostCourse_bytes = std::size_t{16} << 20;
  const fs::path file = arguments.file;
  const std::string text = read_file(file, kMostCourse_bytes);
  const course::Imported imported = course::import_course(text, file.string(), file.stem().string());
  for (const std::string& remark : imported.remarks) std::cerr << "robosim: note: " << remark << '\n';
  const std::string written = grid::write_map(imported.map);
  // What cannot be read again is not written.
  try {
    grid::parse_map(written, file.string());
  } catch (const InputError& error) {
    std::size_t segments = 0;
    for (const grid::Path& path : imported.map.course.paths) segments += path.pieces().size();
    throw InputError({file.string()},
                     fmt::format("its map, of {} segments and {} KB, cannot be read again: {}", segments,
                                 written.size() / 1000, error.message()));
  }
  if (arguments.out.empty()) {
    out << written;
    return ExitStatus::ok;
  }
  std::error_code error;
  if (fs::exists(fs::symlink_status(arguments.out, error)))
    throw InputError({arguments.out},
                     "exists already, so nothing was written; remove it, or name another --out");
  write_file(arguments.out, written);
  return check_maps({arguments.out}, "", out, std::cerr);
}

int import_command(const ImportArguments& arguments) {
  std::ostringstream text;
  const ExitStatus status = import_map(arguments, text);
  print(text.str());
  return static_cast<int>(status);
}

}  // namespace robosim::cli
