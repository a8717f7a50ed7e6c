// robosim_random_bugs: reports the share of small random bugs in firmware/ that the suite of tests/firmware
// finds. docs/explanation/museum.md has the program's output.
//
//   robosim_random_bugs [--count N] [--seed N] [--targets host,avr,stm32] [--jobs N]
//
// Tries N bugs (default 20) that compile and change a run. The suite runs on the host against a copy of the
// firmware with the bug. If no test fails, the suite runs on each chip. If still no test fails, the library's
// unit tests run. Prints one line per bug to standard error, and the totals to standard output. The same seed
// draws the same bugs.
#include <fmt/format.h>
#include <stdlib.h>

#include <iostream>
#include <map>
#include <mutex>
#include <sstream>
#include <thread>

#include "sim/base/error.h"
#include "sim/campaign/mutate/draw.h"
#include "tests/museum/random_bugs.h"

namespace {

using namespace robosim;
using namespace robosim::museum;
namespace fs = std::filesystem;

struct Arguments {
  std::size_t count = 20;
  std::uint64_t seed = 1;
  std::string targets = "host,avr";
  std::size_t jobs = std::max(1u, std::thread::hardware_concurrency());
};

Arguments read_arguments(int argc, char** argv) {
  Arguments arguments;
  for (int i = 1; i < argc; i += 2) {
    const std::string word = argv[i], value = i + 1 < argc ? argv[i + 1] : "";
    const unsigned long long number = std::strtoull(value.c_str(), nullptr, 10);
    if (value.empty() || (word != "--targets" && number == 0))
      throw InputError(word + " needs a value, a number from 1 or targets");
    if (word == "--count")
      arguments.count = number;
    else if (word == "--seed")
      arguments.seed = number;
    else if (word == "--jobs")
      arguments.jobs = number;
    else if (word == "--targets")
      arguments.targets = value;
    else
      throw InputError(word + " is unknown; there are --count, --seed, --targets and --jobs");
  }
  return arguments;
}

/// Several threads draw bugs from one list until enough bugs were tried. The number of threads does not
/// change which bugs are drawn.
class Campaign {
 public:
  explicit Campaign(const Arguments& arguments)
      : arguments_(arguments),
        library_(fs::path(ROBOSIM_MUSEUM_WORK) / "library_tests"),
        bugs_(mutate::shuffled(bugs_of_firmware(), arguments.seed, "bugs")) {
    std::istringstream words(arguments.targets);
    for (std::string word; std::getline(words, word, ',');) targets_.push_back(word);
  }

  void run() {
    Stage first(folder(0));
    unchanged_ = first.test({"host", {}});
    if (!unchanged_.failed.empty())
      throw InputError("without any bug " + unchanged_.failed + " fails:\n" + unchanged_.message);
    std::vector<std::thread> workers;
    for (std::size_t i = 1; i < arguments_.jobs; ++i)
      workers.emplace_back([this, i] {
        Stage stage(folder(i));
        work(stage);
      });
    work(first);
    for (std::thread& worker : workers) worker.join();
  }

  std::string summary() const {
    std::vector<Attempt> attempts;
    for (const auto& [number, one] : attempts_) {
      if (observed(attempts) == arguments_.count) break;
      attempts.push_back(one);
    }
    return summary_of(attempts, arguments_.seed, bugs_.size(), arguments_.targets);
  }

 private:
  static fs::path folder(std::size_t i) { return fs::path(ROBOSIM_MUSEUM_WORK) / fmt::format("random{}", i); }

  static std::size_t observed(const std::vector<Attempt>& attempts) {
    std::size_t count = 0;
    for (const Attempt& one : attempts) count += counts(one);
    return count;
  }
  static bool counts(const Attempt& one) {
    return one.ending != Attempt::Ending::unobserved && one.ending != Attempt::Ending::not_compiled;
  }

  void work(Stage& stage) {
    for (;;) {
      std::size_t number = 0;
      {
        const std::lock_guard lock(mutex_);
        if (counted_ >= arguments_.count || next_ == bugs_.size()) return;
        number = next_++;
      }
      Attempt result = attempt(stage, library_, bugs_[number], targets_, unchanged_);
      const std::lock_guard lock(mutex_);
      counted_ += counts(result);
      std::cerr << fmt::format("{} {}: {} {}", number + 1, mutate::described(result.bug), word(result.ending),
                               result.by + result.library)
                << std::endl;
      attempts_.emplace(number, std::move(result));
    }
  }

  Arguments arguments_;
  LibraryTests library_;
  std::vector<std::string> targets_;
  std::vector<mutate::Mutation> bugs_;
  TestRun unchanged_;
  std::mutex mutex_;
  std::size_t next_ = 0, counted_ = 0;
  std::map<std::size_t, Attempt> attempts_;
};

}  // namespace

int main(int argc, char** argv) try {
  const Arguments arguments = read_arguments(argc, argv);
  take_environment();
  Campaign campaign(arguments);
  campaign.run();
  std::cout << campaign.summary();
  return 0;
} catch (const std::exception& error) {
  std::cerr << "robosim_random_bugs: " << error.what() << '\n';
  return 2;
}
