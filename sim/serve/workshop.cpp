#include "sim/serve/workshop.h"

#include <fmt/format.h>
#include <poll.h>
#include <stdlib.h>
#include <unistd.h>

#include <chrono>
#include <csignal>

#include "sim/base/child.h"
#include "sim/base/error.h"
#include "sim/base/file.h"

namespace robosim::serve {
namespace {

namespace fs = std::filesystem;

constexpr int kLook_ms = 200;                    // how often it is asked whether somebody listens
constexpr std::size_t kMostText = 1 << 20;       // of what a run prints
constexpr std::size_t kLongestPage = 64u << 20;  // bytes

fs::path new_folder() {
  std::string name = (fs::temp_directory_path() / "robosim-serve-XXXXXX").string();
  if (!::mkdtemp(name.data())) throw InputError({name}, "cannot be made");
  return name;
}

fs::path page_file(const fs::path& folder, int number) { return folder / fmt::format("{}.html", number); }

}  // namespace

/// A run's place among those that are under way.
class Workshop::Place {
 public:
  explicit Place(Workshop& workshop) : workshop_(workshop) {
    const std::lock_guard lock(workshop.mutex_);
    if (workshop.running_ == kAtOnce) return;
    ++workshop.running_;
    number_ = ++workshop.last_;
  }
  ~Place() {
    const std::lock_guard lock(workshop_.mutex_);
    if (number_ > 0) --workshop_.running_;
  }
  /// 0: there was none left.
  int number() const { return number_; }

 private:
  Workshop& workshop_;
  int number_ = 0;
};

Workshop::Workshop(fs::path robosim, fs::path folder)
    : robosim_(std::move(robosim)), folder_(fs::canonical(folder)), kept_(new_folder()) {}

Workshop::~Workshop() {
  std::error_code ignored;
  fs::remove_all(kept_, ignored);
}

std::optional<Workshop::Done> Workshop::run(const Wanted& wanted,
                                            const std::function<bool(const std::string&)>& say) {
  const Place place(*this);
  if (place.number() == 0) return std::nullopt;
  const fs::path page = page_file(kept_, place.number()),
                 script = kept_ / fmt::format("{}.txt", place.number());
  ChildStart start;
  start.words = {robosim_.string(),
                 "run",
                 wanted.sketch,
                 "--target",
                 wanted.target,
                 "--seed",
                 std::to_string(wanted.seed),
                 "--for",
                 fmt::format("{}s", wanted.for_s),
                 "--record",
                 page.string()};
  const auto option = [&](const char* name, const std::string& value) {
    if (!value.empty()) start.words.insert(start.words.end(), {name, value});
  };
  option("--robot", wanted.robot);
  option("--map", wanted.map);
  option("--goal", wanted.goal);
  if (!wanted.script.empty()) {
    write_file(script, wanted.script);
    option("--script", script.string());
  }
  start.folder = folder_;
  start.own_group = true;
  Pipe pipe;
  start.input = ChildStart::kNothing;
  start.output = start.errors = pipe.write.get();
  Child child(start);
  pipe.write = Descriptor();

  Done done;
  const auto stop = [&](std::string sentence) {
    done.sentence = std::move(sentence);
    child.send(SIGKILL);
  };
  const auto begin = std::chrono::steady_clock::now();
  std::size_t printed = 0;
  for (;;) {
    pollfd waits{pipe.read.get(), POLLIN, 0};
    const int ready = ::poll(&waits, 1, kLook_ms);
    std::string text;
    if (ready > 0) {
      char buffer[4096];
      const ssize_t got = ::read(pipe.read.get(), buffer, sizeof buffer);
      if (got <= 0) break;
      text.assign(buffer, static_cast<std::size_t>(got));
    }
    printed += text.size();
    if (!done.sentence.empty()) continue;
    if (!say(text)) stop("nobody was listening any more");
    if (printed > kMostText) stop("it printed more than 1 MB");
    if (std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() > kLongest_s)
      stop(fmt::format("it took more than {} s", kLongest_s));
  }
  done.status = child.wait().status;
  std::error_code ignored;
  fs::remove(script, ignored);
  if (fs::exists(page, ignored)) done.recording = place.number();
  fs::remove(page_file(kept_, place.number() - static_cast<int>(kKept)), ignored);
  return done;
}

std::string Workshop::page_of(int recording) const {
  try {
    return read_file(page_file(kept_, recording), kLongestPage);
  } catch (const InputError&) {
    return "";
  }
}

}  // namespace robosim::serve
