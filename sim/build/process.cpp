#include "sim/build/process.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <thread>

#include "sim/base/child.h"
#include "sim/base/error.h"
#include "sim/build/walls.h"

extern char** environ;

namespace robosim::build {
namespace fs = std::filesystem;

namespace {

std::vector<std::string> clean_environment() {
  static constexpr const char* kDropped[] = {"LC_",
                                             "LANG=",
                                             "LANGUAGE=",
                                             "CPATH=",
                                             "C_INCLUDE_PATH=",
                                             "CPLUS_INCLUDE_PATH=",
                                             "OBJC_INCLUDE_PATH=",
                                             "LIBRARY_PATH=",
                                             "COMPILER_PATH=",
                                             "GCC_",
                                             "SOURCE_DATE_EPOCH=",
                                             "DEPENDENCIES_OUTPUT=",
                                             "SUNPRO_DEPENDENCIES=",
                                             "LD_PRELOAD="};
  std::vector<std::string> kept;
  for (char** variable = environ; *variable; ++variable) {
    const std::string_view text = *variable;
    if (std::none_of(std::begin(kDropped), std::end(kDropped),
                     [&](const char* name) { return text.substr(0, std::strlen(name)) == name; }))
      kept.emplace_back(text);
  }
  kept.emplace_back("LC_ALL=C");
  kept.emplace_back("SOURCE_DATE_EPOCH=0");
  return kept;
}

/// Returns the folders of $PATH without relative ones: a sketch's folder is the compiler's working folder.
std::vector<fs::path> program_folders() {
  const char* path = std::getenv("PATH");
  std::string_view rest = path && *path ? path : "/usr/local/bin:/usr/bin:/bin";
  std::vector<fs::path> folders;
  while (!rest.empty()) {
    const std::size_t colon = std::min(rest.find(':'), rest.size());
    if (fs::path folder = rest.substr(0, colon); folder.is_absolute()) folders.push_back(std::move(folder));
    rest.remove_prefix(std::min(colon + 1, rest.size()));
  }
  return folders;
}

/// Removes the user's environment except the path: a sketch can make a compiler print the rest.
std::vector<std::string> walled_environment(const fs::path& scratch) {
  std::string path;
  for (const fs::path& folder : program_folders()) path += (path.empty() ? "" : ":") + folder.string();
  return {
      "PATH=" + path,        "HOME=" + scratch.string(), "TMPDIR=" + scratch.string(), "LC_ALL=C",
      "SOURCE_DATE_EPOCH=0", "CCACHE_DISABLE=1"};  // if the compiler is ccache, which cannot see its folder
}

std::vector<char*> null_ended(const std::vector<std::string>& texts) {
  std::vector<char*> result;
  for (const std::string& text : texts) result.push_back(const_cast<char*>(text.c_str()));
  result.push_back(nullptr);
  return result;
}

/// Starts a confined ChildStart, like Child. After the fork, only async-signal-safe calls.
Child start_within(const Walls& walls, const ChildStart& start) {
  constexpr int kCannotStart = 127;
  const std::vector<std::string> settings = walled_environment(walls.scratch());
  const std::vector<char*> words = null_ended(start.words), environment = null_ended(settings);
  return Child([&] {
    const int input = start.input >= 0 ? start.input : ::open("/dev/null", O_RDONLY | O_CLOEXEC);
    const bool ready =
        ::dup2(input, STDIN_FILENO) == STDIN_FILENO && ::dup2(start.output, STDOUT_FILENO) == STDOUT_FILENO &&
        ::dup2(start.errors, STDERR_FILENO) == STDERR_FILENO && walls.enter(start.folder.c_str());
    if (ready) ::execve(words[0], words.data(), environment.data());
    return kCannotStart;
  });
}

struct Running {
  std::size_t index;
  Descriptor output;
  Child child;
};

Running start(const Command& command, std::size_t index, const std::vector<std::string>& environment) {
  for (const std::string& word : command.words)
    if (word.starts_with('@'))
      throw InputError({word}, "cannot be compiled: expected a name that does not begin with '@'; rename it");
  Pipe pipe;
  Descriptor input;
  ChildStart start;
  start.words = command.words;
  start.folder = command.folder;
  start.environment = environment;
  start.input = ChildStart::kNothing;
  if (!command.input.empty()) {
    input = Descriptor(::open(command.input.c_str(), O_RDONLY | O_CLOEXEC));
    if (input.get() < 0)
      throw std::system_error(errno, std::generic_category(), command.input.string() + " cannot be read");
    start.input = input.get();
  }
  start.output = start.errors = pipe.write.get();
  return {index, std::move(pipe.read), command.walls ? start_within(*command.walls, start) : Child(start)};
}

/// Returns false at the end of the output.
bool read_some(int descriptor, std::string& output) {
  char buffer[16384];
  const ssize_t n = ::read(descriptor, buffer, sizeof buffer);
  if (n > 0) output.append(buffer, static_cast<std::size_t>(n));
  return n > 0 || (n < 0 && errno == EINTR);
}

}  // namespace

std::vector<CommandResult> run(const std::vector<Command>& commands) {
  const std::vector<std::string> environment = clean_environment();
  // Each compiler takes some 100 MB: at most four, so that 1 GB of memory is enough.
  const std::size_t at_once = std::clamp(std::thread::hardware_concurrency(), 1u, 4u);
  std::vector<CommandResult> results(commands.size());
  std::vector<Running> running;
  std::size_t next = 0;
  while (next < commands.size() || !running.empty()) {
    while (next < commands.size() && running.size() < at_once) {
      running.push_back(start(commands[next], next, environment));
      ++next;
    }
    std::vector<pollfd> waiting;
    for (const Running& one : running) waiting.push_back({one.output.get(), POLLIN, 0});
    if (::poll(waiting.data(), waiting.size(), -1) < 0) continue;
    for (std::size_t i = running.size(); i-- > 0;) {
      if (!waiting[i].revents) continue;
      CommandResult& result = results[running[i].index];
      if (result.output.size() < commands[running[i].index].most_output) {
        if (read_some(running[i].output.get(), result.output)) continue;
      } else {
        running[i].child.send(SIGKILL);
        result.output.insert(0, std::string(kTooMuchOutput) + "\n");
      }
      const Ending ending = running[i].child.wait();
      result.status = ending.signal > 0 ? 128 + ending.signal : ending.status;
      running.erase(running.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }
  for (const CommandResult& result : results)
    if (result.status == 128 + SIGINT || result.status == 128 + SIGTERM)
      throw std::runtime_error("interrupted");
  return results;
}

CommandResult run(const Command& command) { return std::move(run(std::vector<Command>{command})[0]); }

std::vector<CommandResult> run_within(const std::vector<fs::path>& read, std::vector<Command> commands) {
  std::deque<Walls> walls;
  for (Command& command : commands) command.walls = &walls.emplace_back(read, command.scratch);
  return run(commands);
}

fs::path find_program(const std::string& name) {
  for (const fs::path& folder : program_folders())
    if (fs::path candidate = folder / name; ::access(candidate.c_str(), X_OK) == 0) return candidate;
  return {};
}

}  // namespace robosim::build
