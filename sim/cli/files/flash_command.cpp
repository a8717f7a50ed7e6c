#include "sim/cli/files/flash_command.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <termios.h>

#include <chrono>
#include <thread>

#include "sim/base/child.h"
#include "sim/base/file.h"
#include "sim/base/shell_word.h"
#include "sim/build/process.h"
#include "sim/cli/files/build_command.h"
#include "sim/cli/output.h"
#include "sim/launch/client/runner.h"
#include "sim/launch/launch.h"
#include "sim/launch/names.h"

namespace robosim::cli {
namespace fs = std::filesystem;

namespace {

BuildArguments build_arguments(const FlashArguments& arguments) {
  BuildArguments build;
  build.sketch = arguments.sketch;
  build.robot = arguments.robot;
  build.target = "avr";
  build.environment = arguments.environment;
  build.libraries = arguments.libraries;
  return build;
}

std::string command_line(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + shell_word(word);
  return text;
}

/// Ignores Ctrl-C while avrdude runs: Ctrl-C also reaches avrdude, and this process waits for avrdude's end.
class LeftToAvrdude {
 public:
  LeftToAvrdude() {
    struct sigaction ignore {};
    ignore.sa_handler = SIG_IGN;
    ::sigaction(SIGINT, &ignore, &before_);
  }
  ~LeftToAvrdude() { ::sigaction(SIGINT, &before_, nullptr); }
  LeftToAvrdude(const LeftToAvrdude&) = delete;
  LeftToAvrdude& operator=(const LeftToAvrdude&) = delete;

 private:
  struct sigaction before_ {};
};

/// Runs avrdude with this process's input, output and environment.
Ending run_avrdude(const fs::path& program, std::vector<std::string> words) {
  const LeftToAvrdude guard;
  ChildStart start;
  start.words = std::move(words);
  start.words[0] = program.string();
  start.default_signals = {SIGINT};
  return Child(start).wait();
}

/// Starts the boot loader of a board whose sketch itself handles USB. For this, opens the port at 1200 baud
/// and closes it. The port disappears, and appears again when the boot loader runs. Ignores a port that
/// cannot be opened, because avrdude reports the error.
void touch(const std::string& port) {
  const Descriptor line(::open(port.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
  termios settings{};
  if (line.get() < 0 || ::tcgetattr(line.get(), &settings) != 0) return;
  ::cfsetspeed(&settings, B1200);
  settings.c_cflag |= HUPCL;
  ::tcsetattr(line.get(), TCSANOW, &settings);
}

/// Waits until the port has disappeared and appeared again, with a time limit for each.
void await_boot_loader(const std::string& port) {
  constexpr auto kLook = std::chrono::milliseconds(100);
  constexpr int kLeaves = 20, kReturns = 80;
  for (int i = 0; i < kLeaves && fs::exists(port); ++i) std::this_thread::sleep_for(kLook);
  for (int i = 0; i < kReturns && !fs::exists(port); ++i) std::this_thread::sleep_for(kLook);
  std::this_thread::sleep_for(5 * kLook);  // gives udev time to grant access to the port
}

/// Returns a hint for boards that may have an older boot loader.
std::string older_boot_loaders() {
  std::string text;
  for (int i = 0; const BoardSpec* board = board_at(i); ++i)
    if (board->upload_baud_old)
      text += fmt::format(" The {} with the old boot loader needs --baud {}.", board->name,
                          board->upload_baud_old);
  return text;
}

/// Returns the board for a finished image: the board of the named robot. Without a robot, returns the
/// project's board, or else the first AVR board.
const BoardSpec& board_of_image(const std::string& robot, const project::Project& project) {
  if (robot.empty() && project.board) return *project.board;
  if (robot.empty()) return *find_board(build::boards_of("avr").front().c_str());
  const launch::Choice choice = launch::choose_robot(robot, ".", "avr");
  const auto description = client::Runner("host").describe_robot(choice.path.string());
  const BoardSpec& board = launch::board_of(description);
  if (board.upload_protocol) return board;
  throw InputError(
      fmt::format("{}: robosim flash cannot write to the robot's board, the {}", robot, board.name));
}

ExitStatus judge(const Ending& ending, const FlashArguments& arguments) {
  if (ending.signal == SIGINT) return ExitStatus::interrupted;
  if (ending.ok()) return ExitStatus::ok;
  complain(fmt::format(
      "robosim: avrdude failed ({}). Is the board at {}? May you write there (group dialout)? Does "
      "another program hold it?{}\n",
      ending.signal > 0 ? fmt::format("signal {}", ending.signal)
                        : fmt::format("exit status {}", ending.status),
      arguments.port, older_boot_loaders()));
  return ExitStatus::failed;
}

}  // namespace

std::vector<std::string> avrdude_words(const FlashArguments& arguments, const BoardSpec& board,
                                       const fs::path& file) {
  return {"avrdude",
          "-p",
          board.chip->avrdude_name,
          "-c",
          board.upload_protocol,
          "-b",
          std::to_string(arguments.baud.value_or(board.upload_baud)),
          "-P",
          arguments.port,
          "-D",
          "-U",
          "flash:w:" + file.string() + (file.extension() == ".elf" ? ":e" : ":i")};
}

int flash_command(const FlashArguments& arguments) {
  const launch::SketchChoice sketch = launch::choose_sketch(arguments.sketch, arguments.environment);
  if (!sketch.elf_target.empty() && sketch.elf_target != "avr")
    throw InputError({sketch.name},
                     fmt::format("expected an image for avr, got one for {}", sketch.elf_target));
  const fs::path program = build::find_program("avrdude");
  if (program.empty() && !arguments.dry_run)
    throw ToolMissing("avrdude is missing: sudo apt install avrdude");

  const BoardSpec* board = nullptr;
  fs::path file = sketch.path;  // a finished image is passed to avrdude unchanged
  if (sketch.elf_target.empty()) {
    const Built built = build_sketch(build_arguments(arguments), Boards::own);
    if (const ExitStatus status = check_size(built); status != ExitStatus::ok)
      return static_cast<int>(status);
    board = &built.board;
    file = built.image.products.at(0);
    print(size_report(built.image, "avr", built.board, {built.image.image, file}) +
          fmt::format("image_sha256: {}, of the image from which the .hex is made; see robosim run --json\n",
                      sha256_of_file(built.image.image)));
  } else {
    board = &board_of_image(arguments.robot, sketch.project);
    print(fmt::format("image_sha256: {}, the same as in robosim run --json\n", sha256_of_file(file)));
  }
  if (!board->upload_protocol)
    throw InputError(fmt::format("{}: robosim flash cannot write to a {}; use the board's programmer",
                                 file.string(), board->name));
  const std::vector<std::string> words = avrdude_words(arguments, *board, file);
  if (board->upload_by_touch)
    print(fmt::format("{} is opened with 1200 baud and closed first, which starts the boot loader\n",
                      arguments.port));
  print(command_line(words) + "\n");
  if (arguments.dry_run) return static_cast<int>(ExitStatus::ok);
  if (board->upload_by_touch && fs::exists(arguments.port)) {
    touch(arguments.port);
    await_boot_loader(arguments.port);
  }
  return static_cast<int>(judge(run_avrdude(program, words), arguments));
}

}  // namespace robosim::cli
