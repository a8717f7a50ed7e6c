#include "sim/view/serve/job_manager.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <limits.h>
#include <poll.h>
#include <stdlib.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>

#include "sim/base/child.h"
#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/build/sketch.h"

extern char** environ;

namespace robosim::serve {
namespace {

namespace fs = std::filesystem;

constexpr int kLook_ms = 200;                    // period of checks for a listener
constexpr std::size_t kMostText = 1 << 20;       // bytes of a run's output
constexpr std::size_t kLongestLine = 16 << 20;   // bytes from a watched run: a line may contain a floor
constexpr std::size_t kLongestPage = 64u << 20;  // bytes

constexpr const char* kFolders = "robosim-serve-";

/// Locks a folder until the descriptor is closed or the process is killed. Returns a closed descriptor if
/// another server has locked the folder.
Descriptor hold(const fs::path& folder) {
  Descriptor held(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
  if (held.is_open() && ::flock(held.get(), LOCK_EX | LOCK_NB) != 0) held.close();
  return held;
}

/// Removes the folders of killed servers of this user.
void remove_abandoned(const fs::path& place) {
  std::error_code error;
  for (fs::directory_iterator entry(place, error), end; !error && entry != end; entry.increment(error)) {
    struct stat info {};
    if (!entry->path().filename().string().starts_with(kFolders)) continue;
    if (::lstat(entry->path().c_str(), &info) != 0 || info.st_uid != ::geteuid()) continue;
    std::error_code ignored;
    if (const Descriptor held = hold(entry->path()); held.is_open()) fs::remove_all(entry->path(), ignored);
  }
}

fs::path page_file(const fs::path& folder, int number) { return folder / fmt::format("{}.html", number); }
/// Returns the file of a script. If there are several robots, `robot` names the one that the script controls.
fs::path script_file(const fs::path& folder, int number, const std::string& robot = "") {
  return folder / fmt::format("{}", number) / (robot + ".txt");
}

std::vector<std::string> environment_with(const std::string& variable) {
  std::vector<std::string> all;
  const std::string_view name(variable.data(), variable.find('=') + 1);
  for (char** one = environ; *one; ++one)
    if (!std::string_view(*one).starts_with(name)) all.emplace_back(*one);
  all.push_back(variable);
  return all;
}

}  // namespace

PageFolder::PageFolder() {
  const fs::path place = fs::temp_directory_path();
  remove_abandoned(place);
  struct stat info {};
  do {  // another server may remove the folder before it is locked
    std::string name = (place / fmt::format("{}XXXXXX", kFolders)).string();
    if (!::mkdtemp(name.data()))
      throw InputError({name}, std::string("cannot create the folder: ") + std::strerror(errno));
    path_ = name;
    held_ = hold(path_);
  } while (!held_.is_open() || ::fstat(held_.get(), &info) != 0 || info.st_nlink == 0);
}

PageFolder::~PageFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

/// Reserves one of the places for simultaneous runs; converts to false if none was free.
class JobManager::Place {
 public:
  explicit Place(JobManager& jobs) : jobs_(jobs) {
    const std::lock_guard lock(jobs.mutex_);
    has_ = jobs.running_ < kAtOnce;
    if (has_) ++jobs.running_;
  }
  ~Place() {
    const std::lock_guard lock(jobs_.mutex_);
    if (has_) --jobs_.running_;
  }
  explicit operator bool() const { return has_; }

 private:
  JobManager& jobs_;
  bool has_ = false;
};

/// Lets a run receive requests as long as this object exists.
class JobManager::Listening {
 public:
  Listening(JobManager& jobs, int number, int descriptor) : jobs_(jobs), number_(number) {
    const std::lock_guard lock(jobs.mutex_);
    jobs.inputs_[number] = descriptor;
  }
  ~Listening() {
    const std::lock_guard lock(jobs_.mutex_);
    jobs_.inputs_.erase(number_);
  }

 private:
  JobManager& jobs_;
  const int number_;
};

JobManager::JobManager(fs::path robosim, fs::path folder)
    : robosim_(std::move(robosim)), folder_(fs::canonical(folder)) {}

ChildStart JobManager::start_of(const RunForm& form, int number) const {
  ChildStart start;
  start.words = {robosim_.string(), "run", form.sketch};
  const auto option = [&](const char* name, const std::string& value) {
    if (!value.empty()) start.words.insert(start.words.end(), {name, value});
  };
  if (!is_image(form.sketch)) option("--target", form.target);
  option("--seed", std::to_string(form.seed));
  option("--for", fmt::format("{}s", form.for_s));
  option("--record", page_file(pages_.path(), number).string());
  option("--robot", form.robot);
  option("--map", form.map);
  option("--goal", form.goal);
  fs::create_directory(script_file(pages_.path(), number).parent_path());
  if (!form.script.empty()) {
    const fs::path script = script_file(pages_.path(), number);
    write_file(script, form.script);
    option("--script", script.string());
  }
  for (const auto& [robot, text] : form.scripts) {
    const fs::path script = script_file(pages_.path(), number, robot);
    write_file(script, text);
    option("--script", robot + "=" + script.string());
  }
  start.folder = folder_.path();
  start.environment =
      environment_with(file_scope_variable({folder_.path(), pages_.path(), build::cache_folder()}));
  start.own_group = true;
  start.input = ChildStart::kNothing;
  return start;
}

JobManager::Done JobManager::follow(Child& child, const std::vector<Source>& sources,
                                    double longest_s) const {
  Done done;
  const auto stop = [&](std::string sentence) {
    done.sentence = std::move(sentence);
    child.send(SIGKILL);
  };
  const auto begin = std::chrono::steady_clock::now();
  std::vector<pollfd> waits;
  for (const Source& source : sources) waits.push_back({source.pipe->get(), POLLIN, 0});
  for (std::size_t open = waits.size(); open > 0;) {
    const bool quiet = ::poll(waits.data(), waits.size(), kLook_ms) <= 0;
    for (std::size_t i = 0; i < waits.size(); ++i) {
      std::string text;
      if (!quiet && waits[i].revents == 0) continue;
      if (!quiet) {
        char buffer[16384];
        const ssize_t got = ::read(waits[i].fd, buffer, sizeof buffer);
        if (got <= 0) {
          waits[i].fd = -1;  // excluded from poll()
          --open;
          continue;
        }
        text.assign(buffer, static_cast<std::size_t>(got));
      }
      if (done.sentence.empty() && !sources[i].take(text)) stop("the browser has stopped listening");
      if (done.sentence.empty() && ending_) stop("the server has ended");
    }
    if (done.sentence.empty() &&
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() > longest_s)
      stop(fmt::format("the run took more than {} s", longest_s));
  }
  done.status = child.wait().status;
  return done;
}

void JobManager::put_away(int number, Done& done) const {
  std::error_code ignored;
  fs::remove_all(script_file(pages_.path(), number).parent_path(), ignored);
  if (fs::exists(page_file(pages_.path(), number), ignored)) done.recording = number;
  fs::remove(page_file(pages_.path(), number - static_cast<int>(kKept)), ignored);
}

std::optional<JobManager::Done> JobManager::run(const RunForm& form,
                                                const std::function<bool(const std::string&)>& say) {
  const Place place(*this);
  if (!place) return std::nullopt;
  const int number = next_number();
  ChildStart start = start_of(form, number);
  Pipe pipe;
  start.output = start.errors = pipe.write.get();
  Child child(start);
  pipe.write = Descriptor();
  std::size_t printed = 0;
  Done done = follow(child,
                     {{&pipe.read,
                       [&](const std::string& text) {
                         printed += text.size();
                         return printed <= kMostText && say(text);
                       }}},
                     kLongest_s);
  if (printed > kMostText) done.sentence = "the run printed more than 1 MB";
  put_away(number, done);
  return done;
}

int JobManager::prepare(const RunForm& form) {
  const int number = next_number();
  const std::lock_guard lock(mutex_);
  prepared_[number] = form;
  if (prepared_.size() > kKept) prepared_.erase(prepared_.begin());
  return number;
}

std::optional<JobManager::Done> JobManager::watch(int number, const Tell& tell) {
  const Place place(*this);
  RunForm form;
  {
    const std::lock_guard lock(mutex_);
    const auto found = prepared_.find(number);
    if (found == prepared_.end()) return std::nullopt;
    if (!place) return busy();
    form = found->second;
    prepared_.erase(found);
  }
  ChildStart start = start_of(form, number);
  start.words.push_back("--live");
  Pipe requests, lines, texts;
  start.input = requests.read.get();
  start.output = lines.write.get();
  start.errors = texts.write.get();
  Child child(start);
  for (Descriptor* given : {&requests.read, &lines.write, &texts.write}) *given = Descriptor();
  ::fcntl(requests.write.get(), F_SETFL, O_NONBLOCK);  // never blocks on a process that does not read
  const Listening listening(*this, number, requests.write.get());

  std::string begun;  // an incomplete line
  std::size_t printed = 0;
  const auto take_lines = [&](const std::string& text) {
    begun += text;
    const std::size_t end = begun.rfind('\n');
    if (end == std::string::npos) return begun.size() <= kLongestLine && tell(Said::lines, "");
    const bool heard = tell(Said::lines, begun.substr(0, end + 1));
    begun.erase(0, end + 1);
    return heard;
  };
  const auto take_text = [&](const std::string& text) {
    printed += text.size();
    return printed <= kMostText && tell(Said::text, text);
  };
  Done done = follow(child, {{&lines.read, take_lines}, {&texts.read, take_text}}, kLongestLive_s);
  put_away(number, done);
  return done;
}

bool JobManager::ask(int number, const std::string& line) {
  const std::lock_guard lock(mutex_);
  const auto found = inputs_.find(number);
  if (found == inputs_.end() || line.size() > PIPE_BUF) return false;  // a pipe may split longer lines
  return ::write(found->second, line.data(), line.size()) == static_cast<ssize_t>(line.size());
}

int JobManager::next_number() {
  const std::lock_guard lock(mutex_);
  return ++last_;
}

std::string JobManager::page_of(int recording) const {
  try {
    return read_file(page_file(pages_.path(), recording), kLongestPage);
  } catch (const InputError&) {
    return "";
  }
}

}  // namespace robosim::serve
