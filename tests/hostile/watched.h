// Observes a command from outside: its duration, the memory of all its processes, the processes that it
// leaves running, and the files that it touches.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "sim/base/descriptor.h"
#include "tests/hostile/input.h"

namespace robosim::hostile {

/// Measures the memory of a process and all its descendants: resident pages, with shared pages counted for
/// each process.
class MemoryOfTree {
 public:
  explicit MemoryOfTree(pid_t root) : root_(root) {}
  void look();
  std::size_t largest_kb() const { return largest_kb_; }  ///< highest peak of a single process
  std::size_t sum_kb() const { return sum_kb_; }          ///< highest sum over all processes at one moment

 private:
  pid_t root_;
  std::size_t largest_kb_ = 0, sum_kb_ = 0;
};

/// Makes this process the parent of all processes whose parents end from now on.
void adopt_orphans();
/// Ends the descendants of this process except the server `known`. Returns "PID NAME" of each.
std::vector<std::string> end_processes_left(pid_t known = 0);

struct Watched {
  int status = -1;  ///< exit status, or 128 + the signal that ended the command
  bool endless = false;
  std::string out, err;  ///< only their beginnings; on a terminal, both are in `out`
  double wall_s = 0.0, processor_s = 0.0;
  std::size_t largest_kb = 0, sum_kb = 0;
  std::vector<std::string> left;
};

/// Runs a command until it ends, but at most for `most_s` seconds.
Watched watch(const std::vector<std::string>& words, const std::filesystem::path& folder, bool on_terminal,
              double most_s);

/// Watches some folders, and records which of their files are opened or changed by any process.
class Canaries {
 public:
  explicit Canaries(const std::vector<std::filesystem::path>& folders);
  std::vector<std::string> take();

 private:
  Descriptor notices_;
  std::map<int, std::filesystem::path> folders_;
};

/// A port of this machine that no program should connect to.
class QuietPort {
 public:
  QuietPort();
  int number() const { return number_; }
  bool was_reached() const;

 private:
  Descriptor socket_;
  int number_ = 0;
};

/// Describes all files below a folder: names, kinds, sizes and times of change.
std::map<std::string, std::string> state_of(const std::filesystem::path& folder,
                                            const std::vector<std::string>& except = {});

std::string written_out(const std::string& text);

/// Creates the entries below `folder`. Returns false if this user may not create one of them.
bool make(const std::filesystem::path& folder, const std::vector<Entry>& entries,
          const std::map<std::string, std::string>& replaced);

std::string replace_all(std::string text, const std::map<std::string, std::string>& replaced);

}  // namespace robosim::hostile
