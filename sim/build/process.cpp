#include "sim/build/process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <deque>
#include <fstream>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <thread>

#include "sim/base/child.h"
#include "sim/base/error.h"
#include "sim/base/process_state.h"
#include "sim/base/program_sandbox.h"
#include "sim/base/wall_clock.h"

extern char** environ;

namespace robosim::build {
namespace fs = std::filesystem;

namespace {

constexpr int kLook_ms = 1000;  ///< period of the checks for idle programs

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

double processor_s_of_children() {
  rusage used{};
  ::getrusage(RUSAGE_CHILDREN, &used);
  return static_cast<double>(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
         1e-6 * static_cast<double>(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
}

bool has_failed_with(const CommandResult& result, std::string_view text) {
  return result.status != 0 && result.output.find(text) != std::string::npos;
}

bool exceeds_time(const CommandResult& result) {
  return has_failed_with(result, kTimeExceeded) || has_failed_with(result, kTooMuchTime) ||
         has_failed_with(result, kWaits);
}

std::string list_of_children(pid_t process) { return fmt::format("/proc/{0}/task/{0}/children", process); }

/// Returns the descendants of a process: gcc's own children do the work, and may outlive gcc. Returns nothing
/// if the kernel does not list children.
std::vector<pid_t> descendants(pid_t process) {
  std::vector<pid_t> all;
  std::ifstream list(list_of_children(process));
  for (pid_t child = 0; list >> child;) {
    all.push_back(child);
    const std::vector<pid_t> more = descendants(child);
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

void end_with_descendants(const Child& child) {
  child.send(SIGSTOP);  // prevents the child from starting more processes
  for (const pid_t one : descendants(child.pid())) ::kill(one, SIGKILL);
  child.send(SIGKILL);
}

double processor_s_of(pid_t process) {
  clockid_t clock{};
  timespec time{};
  if (::clock_getcpuclockid(process, &clock) != 0 || ::clock_gettime(clock, &time) != 0) return 0.0;
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Detects a program that has hardly used a processor for some time, because it waits forever. For example, a
/// compiler waits for a writer of a pipe that the sketch includes.
struct Idleness {
  bool look(pid_t process, int most_s) {
    static const bool can_tell = std::ifstream(list_of_children(::getpid())).is_open();
    constexpr double kBusyMachine = 20.0;  // a working program gets at least 1/20 of a processor
    double now_s = processor_s_of(process);
    bool is_runnable = process_state(process) == 'R';
    for (const pid_t one : descendants(process)) {
      now_s += processor_s_of(one);
      is_runnable |= process_state(one) == 'R';
    }
    const double passed_s = 1e-6 * static_cast<double>(wall_us() - since_us);
    const bool works = is_runnable || now_s < worked_s || now_s - worked_s > passed_s / kBusyMachine;
    if (works) *this = {now_s, wall_us()};
    return can_tell && !works && passed_s > most_s;
  }
  double worked_s = 0.0;
  std::int64_t since_us = wall_us();
};

std::size_t programs_at_once() { return std::clamp(std::thread::hardware_concurrency(), 1u, 4u); }

struct Running {
  std::size_t index;
  Descriptor output;
  Child child;
  Idleness idleness;
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
      throw std::system_error(errno, std::generic_category(), "cannot read " + command.input.string());
    start.input = input.get();
  }
  start.output = start.errors = pipe.write.get();
  return {index,
          std::move(pipe.read),
          command.walls
              ? start_within(*command.walls, start, command.most_memory ? command.most_memory : kCompileBytes)
              : Child(start),
          {}};
}

/// Adds the number of bytes read to `total`. Returns false at the end of the output.
bool read_some(int descriptor, std::string& output, std::size_t& total) {
  char buffer[16384];
  const ssize_t n = ::read(descriptor, buffer, sizeof buffer);
  if (n > 0) {
    output.append(buffer, static_cast<std::size_t>(n));
    total += static_cast<std::size_t>(n);
  }
  return n > 0 || (n < 0 && errno == EINTR);
}

}  // namespace

std::vector<CommandResult> run(const std::vector<Command>& commands) {
  const std::vector<std::string> environment = clean_environment();
  const std::size_t at_once = programs_at_once();
  const double begin_s = processor_s_of_children();
  std::vector<CommandResult> results(commands.size());
  std::vector<Running> running;
  std::size_t next = 0, total_output = 0;
  while (next < commands.size() || !running.empty()) {
    while (next < commands.size() && running.size() < at_once) {
      running.push_back(start(commands[next], next, environment));
      ++next;
    }
    std::vector<pollfd> waiting;
    for (const Running& one : running) waiting.push_back({one.output.get(), POLLIN, 0});
    if (::poll(waiting.data(), waiting.size(), kLook_ms) < 0) continue;
    for (std::size_t i = running.size(); i-- > 0;) {
      const bool is_walled = commands[running[i].index].walls != nullptr;
      const bool is_idle = is_walled && running[i].idleness.look(running[i].child.pid(),
                                                                 commands[running[i].index].most_wait_s);
      if (!waiting[i].revents && !is_idle) continue;
      CommandResult& result = results[running[i].index];
      if (is_idle) {
        end_with_descendants(running[i].child);
        result.output.insert(0, std::string(kWaits) + "\n");
      } else if (total_output < commands[running[i].index].most_output) {
        if (read_some(running[i].output.get(), result.output, total_output)) continue;
      } else {
        end_with_descendants(running[i].child);
        result.output.insert(0, std::string(kTooMuchOutput) + "\n");
      }
      const Ending ending = running[i].child.wait();
      result.status = ending.signal > 0 ? 128 + ending.signal : ending.status;
      if (is_walled && processor_s_of_children() - begin_s > kStepSeconds) {
        result.status = std::max(result.status, 1);
        result.output.insert(0, std::string(kTooMuchTime) + "\n");
      }
      if (is_walled && (exceeds_time(result) || has_failed_with(result, kTooMuchOutput)))
        for (; next < commands.size(); ++next) results[next].status = 1;
      running.erase(running.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }
  for (const CommandResult& result : results)
    if (result.status == 128 + SIGINT || result.status == 128 + SIGTERM) throw Interrupted();
  return results;
}

CommandResult run(const Command& command) { return std::move(run(std::vector<Command>{command})[0]); }

bool lacks_memory(const CommandResult& result) {
  constexpr std::string_view kSaid[] = {"out of memory allocating", "virtual memory exhausted",
                                        "memory exhausted", "Cannot allocate memory"};
  return std::any_of(std::begin(kSaid), std::end(kSaid),
                     [&](std::string_view text) { return has_failed_with(result, text); });
}

std::vector<CommandResult> run_within(const std::vector<fs::path>& read, std::vector<Command> commands) {
  std::deque<ProgramSandbox> walls;
  for (Command& command : commands) {
    std::vector<fs::path> readable = read;
    readable.insert(readable.end(), command.read.begin(), command.read.end());
    command.walls = &walls.emplace_back(std::move(readable), command.scratch);
  }
  const std::size_t at_once = std::min(commands.size(), programs_at_once());
  for (Command& command : commands)
    if (command.most_memory == 0) command.most_memory = kCompileBytes / std::max<std::size_t>(at_once, 1);
  std::vector<CommandResult> results = run(commands);
  for (std::size_t i = 0; at_once > 1 && i < commands.size(); ++i) {
    if (commands[i].most_memory >= kCompileBytes || !lacks_memory(results[i])) continue;
    commands[i].most_memory = kCompileBytes;
    results[i] = run(commands[i]);
    if (lacks_memory(results[i]) || exceeds_time(results[i])) break;
  }
  return results;
}

}  // namespace robosim::build
