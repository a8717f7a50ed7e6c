#include "sim/cli/files/flash_command.h"

#include <fmt/format.h>
#include <signal.h>

#include "sim/base/child.h"
#include "sim/base/file.h"
#include "sim/base/shell_word.h"
#include "sim/build/process.h"
#include "sim/cli/files/build_command.h"
#include "sim/cli/output.h"
#include "sim/launch/names.h"

namespace robosim::cli {
namespace fs = std::filesystem;

namespace {

BuildArguments build_arguments(const FlashArguments& arguments) {
  BuildArguments build;
  build.sketch = arguments.sketch;
  build.robot = arguments.robot;
  build.target = "avr";
  build.libraries = arguments.libraries;
  return build;
}

std::string command_line(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + shell_word(word);
  return text;
}

/// Ctrl-C reaches every process of the terminal. It is avrdude's: this one waits for how it ends.
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

/// Runs it with this process's input, output and environment.
Ending run_avrdude(const fs::path& program, std::vector<std::string> words) {
  const LeftToAvrdude guard;
  ChildStart start;
  start.words = std::move(words);
  start.words[0] = program.string();
  start.default_signals = {SIGINT};
  return Child(start).wait();
}

ExitStatus judge(const Ending& ending, const FlashArguments& arguments) {
  if (ending.signal == SIGINT) return ExitStatus::interrupted;
  if (ending.ok()) return ExitStatus::ok;
  fmt::print(stderr,
             "robosim: avrdude failed ({}). Is the board at {}? May you write there (group dialout)? Does "
             "another program hold it? A Nano with the old boot loader needs --baud 57600\n",
             ending.signal > 0 ? fmt::format("signal {}", ending.signal)
                               : fmt::format("exit status {}", ending.status),
             arguments.port);
  return ExitStatus::failed;
}

}  // namespace

std::vector<std::string> avrdude_words(const FlashArguments& arguments, const fs::path& file) {
  return {"avrdude",
          "-p",
          "atmega328p",
          "-c",
          "arduino",
          "-b",
          std::to_string(arguments.baud),
          "-P",
          arguments.port,
          "-D",
          "-U",
          "flash:w:" + file.string() + (file.extension() == ".elf" ? ":e" : ":i")};
}

int flash_command(const FlashArguments& arguments) {
  const launch::SketchChoice sketch = launch::choose_sketch(arguments.sketch);
  if (!sketch.elf_target.empty() && sketch.elf_target != "avr")
    throw InputError({sketch.name}, fmt::format("is an image for {}; robosim flash writes those for avr",
                                                sketch.elf_target));
  const fs::path program = build::find_program("avrdude");
  if (program.empty() && !arguments.dry_run)
    throw ToolMissing("avrdude is missing: sudo apt install avrdude");

  fs::path file = sketch.path;  // a finished image: avrdude reads it itself
  if (sketch.elf_target.empty()) {
    const Built built = build_sketch(build_arguments(arguments), Boards::own);
    if (const ExitStatus status = check_size(built); status != ExitStatus::ok)
      return static_cast<int>(status);
    file = built.image.products.at(0);
    print(size_report(built.image, "avr", built.board, {built.image.image, file}) +
          fmt::format("image_sha256: {}, of the image that the .hex is made of, as in robosim run --json\n",
                      sha256_of_file(built.image.image)));
  } else {
    print(fmt::format("image_sha256: {}, as in robosim run --json\n", sha256_of_file(file)));
  }
  const std::vector<std::string> words = avrdude_words(arguments, file);
  print(command_line(words) + "\n");
  if (arguments.dry_run) return static_cast<int>(ExitStatus::ok);
  return static_cast<int>(judge(run_avrdude(program, words), arguments));
}

}  // namespace robosim::cli
