#include "sim/cli/files/build_command.h"

#include <fmt/format.h>

#include <cstdint>
#include <utility>

#include "sim/base/file.h"
#include "sim/cli/launching.h"
#include "sim/cli/output.h"
#include "sim/launch/client/runner.h"
#include "sim/launch/launch.h"
#include "sim/view/terminal/progress.h"

namespace robosim::cli {
namespace fs = std::filesystem;

namespace {

build::Warnings warnings_of(const std::string& level) {
  if (level == "none") return build::Warnings::none;
  if (level == "more") return build::Warnings::more;
  if (level == "all") return build::Warnings::all;
  return build::Warnings::standard;
}

/// Returns the files of the image: in the cache, or copied to `folder` if it is given.
std::vector<fs::path> put_files(const build::Image& image, const std::string& folder) {
  std::vector<fs::path> files{image.image};
  files.insert(files.end(), image.products.begin(), image.products.end());
  if (folder.empty()) return files;
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw InputError({folder, 0, 0}, "--out: the folder cannot be created: " + error.message());
  for (fs::path& file : files) {
    const fs::path copy = fs::path(folder) / (image.name + file.extension().string());
    write_file(copy, read_file(file));
    file = copy;
  }
  return files;
}

bool is_product(const fs::path& file) { return file.extension() == ".hex" || file.extension() == ".bin"; }

std::string host_sizes(const build::Image& image, const BoardSpec& board) {
  return fmt::format(
      "{}: {} bytes of code and {} bytes of variables on this machine ({}{})\n"
      "To see its share of the {}'s {} bytes of flash and {} bytes of RAM, build with --target {}.\n",
      image.name, image.text_bytes, image.data_bytes, image.compiler,
      image.from_cache ? ", unchanged since it was last compiled" : "", board.name, board.flash_bytes,
      board.ram_bytes, board.chip->target);
}

// Arduino warns if variables occupy more than this share of the RAM.
constexpr std::uint64_t kMuch_percent = 75;

std::string chip_sizes(const build::Image& image, const BoardSpec& board) {
  const std::int64_t left =
      static_cast<std::int64_t>(board.ram_bytes) - static_cast<std::int64_t>(image.data_bytes);
  return fmt::format(
             "{} for the {} ({}{})\n"
             "Sketch uses {} bytes ({}%) of program storage space. Maximum is {} bytes.\n"
             "Global variables use {} bytes ({}%) of dynamic memory, leaving {} bytes for local variables. "
             "Maximum "
             "is {} bytes.\n",
             image.name, board.name, image.compiler,
             image.from_cache ? ", unchanged since it was last compiled" : "", image.text_bytes,
             image.text_bytes * 100 / board.flash_bytes, board.flash_bytes, image.data_bytes,
             image.data_bytes * 100 / board.ram_bytes, left, board.ram_bytes) +
         (image.data_bytes * 100 > kMuch_percent * board.ram_bytes
              ? "Low memory available, stability problems may occur.\n"
              : "");
}

void check_fits(const build::Image& image, const BoardSpec& board) {
  if (image.text_bytes > board.flash_bytes)
    throw build::CompileError(
        fmt::format("{} does not fit: it uses {} bytes of flash, and the {} has {} for a sketch", image.name,
                    image.text_bytes, board.name, board.flash_bytes));
  if (image.data_bytes > board.ram_bytes)
    throw build::CompileError(
        fmt::format("{} does not fit: its variables use {} bytes, and the {} has {} of RAM", image.name,
                    image.data_bytes, board.name, board.ram_bytes));
}

}  // namespace

std::string size_report(const build::Image& image, const std::string& target, const BoardSpec& board,
                        const std::vector<fs::path>& files) {
  std::string text = target == "host" ? host_sizes(image, board) : chip_sizes(image, board);
  std::vector<std::string> limits;
  for (const build::Limit& limit : build::stated_limits(image))
    limits.push_back(
        fmt::format("{} {}{}", limit.value, limit.what,
                    limit.bytes_each ? fmt::format(" (at {} bytes of RAM each)", limit.bytes_each) : ""));
  if (!limits.empty()) text += fmt::format("Limits: {}\n", fmt::join(limits, ", "));
  if (!image.libraries.empty()) text += fmt::format("libraries: {}\n", fmt::join(image.libraries, ", "));
  for (const fs::path& file : files)
    text += fmt::format("{}: {}\n", is_product(file) ? file.extension().string().substr(1) : "image",
                        file.string());
  return text;
}

std::vector<std::string> over_budget(const build::Image& image, const wire::RobotInfo& robot) {
  std::vector<std::string> sentences;
  const auto check = [&](std::uint64_t used, std::int64_t allowed, const char* what) {
    if (allowed > 0 && used > static_cast<std::uint64_t>(allowed))
      sentences.push_back(
          fmt::format("{} is over the budget: it uses {} bytes of {}, and the robot {} allows {}", image.name,
                      used, what, robot.name, allowed));
  };
  check(image.text_bytes, robot.budget.flash_bytes, "flash");
  check(image.data_bytes, robot.budget.ram_bytes, "RAM for variables");
  return sentences;
}

Built build_sketch(const BuildArguments& arguments, Boards boards) {
  launch::check_build_target(arguments.target);
  if (arguments.sanitize)
    launch::name_flag("--sanitize", [&] { build::check_can_sanitize(arguments.target); });
  const launch::SketchChoice sketch = launch::choose_sketch(arguments.sketch, arguments.environment);
  if (!sketch.elf_target.empty())
    throw InputError({sketch.name, 0, 0}, "expected a sketch, got a compiled image; robosim run runs it");
  const launch::Choice choice = launch::choose_robot(arguments.robot, sketch, arguments.target);
  // Uses the host's runner, which is always installed. A robot's description is the same for all targets.
  client::Runner describer("host");
  const auto describe = [&](const std::string& name) { return describer.describe_robot(name); };
  launch::Carrier carrier = boards == Boards::own ? on_its_board(choice, describe)
                                                  : fit_to_target(choice, arguments.target, describe);
  terminal::Progress progress(true);
  const launch::Listener listener = listener_of(progress, {.all_warnings = true});
  for (const std::string& sentence : remarks_on_project(sketch, arguments.libraries))
    listener.chosen(sentence);
  if (!carrier.announcement.empty()) listener.chosen(carrier.announcement);
  wire::RobotInfo& robot = carrier.info;
  const BoardSpec& board = launch::board_of(robot);
  build::Request request = request_of(sketch, board, arguments.target, arguments.libraries);
  request.warnings = warnings_of(arguments.warnings);
  request.sanitize = arguments.sanitize;
  request.all_messages = true;
  return {image_of(sketch, request, listener), board, std::move(robot)};
}

ExitStatus check_size(const Built& built) {
  check_fits(built.image, built.board);
  const auto sentences = over_budget(built.image, built.robot);
  for (const std::string& sentence : sentences) complain(fmt::format("robosim: {}\n", sentence));
  return sentences.empty() ? ExitStatus::ok : ExitStatus::failed;
}

int build_command(const BuildArguments& arguments) {
  const Built built = build_sketch(arguments, Boards::fitting);
  if (arguments.sanitize && arguments.target != "host") {
    print(fmt::format(
        "{} for the {}, with checks ({})\n"
        "This image runs only in robosim run, and need not fit the chip: {} bytes of code, {} of variables.\n"
        "image: {}\n",
        built.image.name, built.board.name, built.image.compiler, built.image.text_bytes,
        built.image.data_bytes, put_files(built.image, arguments.out)[0].string()));
    return static_cast<int>(ExitStatus::ok);
  }
  print(size_report(built.image, arguments.target, built.board, put_files(built.image, arguments.out)));
  return static_cast<int>(arguments.target == "host" ? ExitStatus::ok : check_size(built));
}

}  // namespace robosim::cli
