#include "sim/cli/files/map_import.h"

#include <fmt/format.h>

#include <filesystem>
#include <ostream>
#include <sstream>
#include <system_error>

#include "sim/base/file.h"
#include "sim/cli/files/map_command.h"
#include "sim/cli/output.h"
#include "sim/map/course/import.h"
#include "sim/map/floor_image.h"
#include "sim/map/map_writer.h"

namespace robosim::cli {
namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMostCourse_bytes = std::size_t{32} << 20;

void check_picture(const ImportArguments& arguments) {
  if (!(arguments.pixel_m > 0.0))
    throw InputError({arguments.file}, "a picture requires the size of its pixels, as in --pixel 0.5mm");
  const auto folder_of = [](const std::string& file) { return fs::absolute(file).parent_path(); };
  std::error_code error;
  if (!arguments.out.empty() && !fs::equivalent(folder_of(arguments.out), folder_of(arguments.file), error))
    throw InputError({arguments.out}, fmt::format("expected --out next to the picture, in {}",
                                                  folder_of(arguments.file).string()));
}

}  // namespace

ExitStatus import_map(const ImportArguments& arguments, std::ostream& out) {
  const fs::path file = arguments.file;
  const std::string text = read_file(file, kMostCourse_bytes);
  const bool is_picture = course::is_picture(text);
  if (is_picture) check_picture(arguments);
  if (!is_picture && arguments.pixel_m > 0.0)
    throw InputError({file.string()}, "--pixel requires a picture in PNG format");
  if (is_picture && arguments.walls_m > 0.0)
    throw InputError({file.string()}, "--walls requires a maze, got a picture");
  const std::string name = file.stem().string();
  const course::Imported imported = is_picture
                                        ? course::import_picture(text, file.string(), name, arguments.pixel_m)
                                        : course::import_course(text, file.string(), name, arguments.walls_m);
  for (const std::string& remark : imported.remarks) complain(fmt::format("robosim: note: {}\n", remark));
  const std::string written = map::write_map(imported.map);
  // Refuses to write a map that cannot be read again.
  try {
    map::parse_map(written, file.string());
  } catch (const InputError& error) {
    std::size_t segments = 0;
    for (const map::Path& path : imported.map.course.paths) segments += path.pieces().size();
    throw InputError({file.string()},
                     fmt::format("the resulting map, of {} segments and {} KB, cannot be read again: {}",
                                 segments, written.size() / 1000, error.message()));
  }
  if (arguments.out.empty()) {
    out << written;
    return ExitStatus::ok;
  }
  std::error_code error;
  if (fs::exists(fs::symlink_status(arguments.out, error)))
    throw InputError({arguments.out},
                     "exists already; nothing was written; remove it, or name another --out");
  write_file(arguments.out, written);
  if (imported.map.image) {
    out << fmt::format("wrote {}: a floor of {:.10g} x {:.10g} mm\n", arguments.out,
                       1e3 * imported.map.image->wide_m(), 1e3 * imported.map.image->high_m());
    return ExitStatus::ok;
  }
  std::ostringstream problems;
  const ExitStatus status = check_maps({arguments.out}, "", out, problems);
  complain(problems.str());
  return status;
}

int import_command(const ImportArguments& arguments) {
  std::ostringstream text;
  const ExitStatus status = import_map(arguments, text);
  print(text.str());
  return static_cast<int>(status);
}

}  // namespace robosim::cli
