#include "tests/hostile/watched.h"

#include <arpa/inet.h>
#include <dirent.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <pty.h>
#include <signal.h>
#include <sys/inotify.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/sysmacros.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iterator>
#include <system_error>

namespace robosim::hostile {
namespace fs = std::filesystem;

namespace {

constexpr int kLook_ms = 3;
constexpr std::size_t kMostOutput = 4 << 20;

std::vector<pid_t> children_of(pid_t process) {
  std::vector<pid_t> all;
  const std::string tasks = fmt::format("/proc/{}/task", process);
  std::error_code error;
  for (const auto& task : fs::directory_iterator(tasks, error)) {
    std::ifstream list(task.path() / "children");
    for (pid_t one = 0; list >> one;) all.push_back(one);
  }
  return all;
}

void add_descendants(std::vector<pid_t>& all, pid_t of) {
  for (const pid_t child : children_of(of)) {
    all.push_back(child);
    add_descendants(all, child);
  }
}

std::string name_of(pid_t process) {
  std::ifstream file(fmt::format("/proc/{}/comm", process));
  std::string name;
  std::getline(file, name);
  return name;
}

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// Reads some bytes; returns false at the end.
bool read_some(int descriptor, std::string& text) {
  char buffer[65536];
  const ssize_t got = ::read(descriptor, buffer, sizeof buffer);
  if (got > 0 && text.size() < kMostOutput) text.append(buffer, static_cast<std::size_t>(got));
  return got > 0 || (got < 0 && (errno == EINTR || errno == EAGAIN));
}

void make_one(const fs::path& path, const Entry& entry, const std::string& content) {
  const auto check = [&](int result) {
    if (result != 0)
      throw fs::filesystem_error("make", path, std::error_code(errno, std::generic_category()));
  };
  switch (entry.kind) {
    case Kind::file:
      std::ofstream(path, std::ios::binary) << content;
      break;
    case Kind::sparse:
      std::ofstream(path).close();
      fs::resize_file(path, std::stoull(content));
      break;
    case Kind::folder:
      fs::create_directories(path);
      break;
    case Kind::link:
      fs::create_symlink(content, path);
      break;
    case Kind::hard_link:
      fs::create_hard_link(path.parent_path() / content, path);
      break;
    case Kind::pipe:
      check(::mkfifo(path.c_str(), 0644));
      break;
    case Kind::device:
      check(::mknod(path.c_str(), S_IFCHR | 0644, makedev(1, 5)));  // the device numbers of /dev/zero
      break;
    case Kind::socket: {
      const Descriptor socket(::socket(AF_UNIX, SOCK_STREAM, 0));
      sockaddr_un address{};
      address.sun_family = AF_UNIX;
      fs::current_path(path.parent_path());  // the absolute path may be too long for sun_path
      path.filename().string().copy(address.sun_path, sizeof address.sun_path - 1);
      check(::bind(socket.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address));
      fs::current_path("/");
    }
  }
}

}  // namespace

void MemoryOfTree::look() {
  std::vector<pid_t> all = {root_};
  add_descendants(all, root_);
  std::size_t sum = 0;
  for (const pid_t one : all) {
    std::ifstream facts(fmt::format("/proc/{}/statm", one));
    std::size_t addresses = 0, resident = 0;
    if (facts >> addresses >> resident) sum += resident * 4;
    largest_kb_ = std::max(largest_kb_, resident * 4);
  }
  sum_kb_ = std::max(sum_kb_, sum);
}

void adopt_orphans() { ::prctl(PR_SET_CHILD_SUBREAPER, 1); }

std::vector<std::string> end_processes_left(pid_t known) {
  const auto begin = std::chrono::steady_clock::now();
  std::vector<pid_t> left;
  do {
    left.clear();
    for (const pid_t child : children_of(::getpid())) {
      if (child != known && ::waitpid(child, nullptr, WNOHANG) == child) continue;
      if (child != known) left.push_back(child);
      add_descendants(left, child);
    }
    left.erase(
        std::remove_if(left.begin(), left.end(), [](pid_t one) { return name_of(one) == "robosim-serve"; }),
        left.end());
    if (left.empty()) return {};
    ::poll(nullptr, 0, 10);
  } while (seconds_since(begin) < 2.0);
  std::vector<std::string> names;
  for (const pid_t one : left) {
    names.push_back(fmt::format("{} {}", one, name_of(one)));
    ::kill(one, SIGKILL);
  }
  for (const pid_t one : left) ::waitpid(one, nullptr, 0);
  return names;
}

Watched watch(const std::vector<std::string>& words, const fs::path& folder, bool on_terminal,
              double most_s) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  int out[2] = {-1, -1}, err[2] = {-1, -1};
  if (!on_terminal && (::pipe2(out, O_CLOEXEC) != 0 || ::pipe2(err, O_CLOEXEC) != 0))
    throw std::system_error(errno, std::generic_category(), "pipe");
  const winsize size{40, 400, 0, 0};
  const auto begin = std::chrono::steady_clock::now();
  const pid_t command = on_terminal ? ::forkpty(&out[0], nullptr, nullptr, &size) : ::fork();
  if (command < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (command == 0) {
    if (!on_terminal) {
      ::setsid();
      const int nothing = ::open("/dev/null", O_RDONLY);
      ::dup2(nothing, STDIN_FILENO);
      ::dup2(out[1], STDOUT_FILENO);
      ::dup2(err[1], STDERR_FILENO);
    }
    if (::chdir(folder.c_str()) == 0) ::execv(arguments[0], arguments.data());
    ::_exit(127);
  }
  const Descriptor out_end(out[0]), err_end(err[0]);
  for (const int end : {out[1], err[1]})
    if (end >= 0) ::close(end);
  const Descriptor ended(static_cast<int>(::syscall(SYS_pidfd_open, command, 0)));

  Watched watched;
  MemoryOfTree memory(command);
  pollfd ready[] = {{ended.get(), POLLIN, 0}, {out_end.get(), POLLIN, 0}, {err_end.get(), POLLIN, 0}};
  while (!(ready[0].revents & POLLIN)) {
    ::poll(ready, 3, kLook_ms);
    memory.look();
    if (ready[1].revents && !read_some(ready[1].fd, watched.out)) ready[1].fd = -1;
    if (ready[2].revents && !read_some(ready[2].fd, watched.err)) ready[2].fd = -1;
    if (!watched.endless && seconds_since(begin) > most_s) {
      watched.endless = true;
      ::kill(command, SIGKILL);
    }
  }
  watched.wall_s = seconds_since(begin);
  for (int i : {1, 2})  // reads the remaining output; a process that is still running may keep the pipes open
    while (ready[i].fd >= 0 && ::poll(&ready[i], 1, 0) > 0)
      if (!read_some(ready[i].fd, i == 1 ? watched.out : watched.err)) ready[i].fd = -1;
  int status = 0;
  rusage used{};
  ::wait4(command, &status, 0, &used);
  watched.status = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  watched.processor_s = seconds_of(used.ru_utime) + seconds_of(used.ru_stime);
  watched.largest_kb = std::max(memory.largest_kb(), static_cast<std::size_t>(used.ru_maxrss));
  watched.sum_kb = std::max(memory.sum_kb(), watched.largest_kb);
  watched.left = end_processes_left();
  return watched;
}

Canaries::Canaries(const std::vector<fs::path>& folders)
    : notices_(::inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {
  for (const fs::path& folder : folders) {
    const int watched = ::inotify_add_watch(
        notices_.get(), folder.c_str(),
        IN_OPEN | IN_ACCESS | IN_MODIFY | IN_ATTRIB | IN_CREATE | IN_DELETE | IN_MOVED_FROM | IN_MOVED_TO);
    if (watched < 0) throw std::system_error(errno, std::generic_category(), folder.string());
    folders_[watched] = folder;
  }
}

std::vector<std::string> Canaries::take() {
  std::vector<std::string> all;
  alignas(inotify_event) char buffer[65536];
  for (ssize_t got; (got = ::read(notices_.get(), buffer, sizeof buffer)) > 0;)
    for (ssize_t at = 0; at < got;) {
      const auto* const notice = reinterpret_cast<const inotify_event*>(buffer + at);
      at += static_cast<ssize_t>(sizeof *notice + notice->len);
      all.push_back(fmt::format(
          "{} ({:#x})", (folders_[notice->wd] / (notice->len ? notice->name : "")).string(), notice->mask));
    }
  return all;
}

QuietPort::QuietPort() : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  ::bind(socket_.get(), reinterpret_cast<const sockaddr*>(&address), size);
  ::listen(socket_.get(), 8);
  ::getsockname(socket_.get(), reinterpret_cast<sockaddr*>(&address), &size);
  number_ = ntohs(address.sin_port);
}

bool QuietPort::was_reached() const {
  return Descriptor(::accept4(socket_.get(), nullptr, nullptr, SOCK_CLOEXEC)).is_open();
}

std::map<std::string, std::string> state_of(const fs::path& folder, const std::vector<std::string>& except) {
  std::map<std::string, std::string> state;
  std::error_code error;
  for (fs::recursive_directory_iterator entry(folder, error), end; entry != end; entry.increment(error)) {
    const std::string name = entry->path().lexically_relative(folder).string();
    if (std::find(except.begin(), except.end(), name) != except.end()) {
      entry.disable_recursion_pending();
      continue;
    }
    struct stat facts {};
    ::lstat(entry->path().c_str(), &facts);
    state[name] = fmt::format("{:o} {} {}.{}", facts.st_mode, S_ISDIR(facts.st_mode) ? 0 : facts.st_size,
                              facts.st_mtim.tv_sec, facts.st_mtim.tv_nsec);
  }
  return state;
}

std::string replace_all(std::string text, const std::map<std::string, std::string>& replaced) {
  for (const auto& [from, to] : replaced)
    for (std::size_t at = 0; (at = text.find(from, at)) != text.npos; at += to.size())
      text.replace(at, from.size(), to);
  return text;
}

/// Expands repeated text: "\2TIMES\3TEXT\4".
std::string written_out(const std::string& text) {
  std::string all;
  for (std::size_t at = 0, begin; at < text.size(); at = text.find('\4', begin) + 1) {
    begin = text.find('\2', at);
    all += text.substr(at, begin - at);
    if (begin == text.npos) break;
    const std::size_t text_begin = text.find('\3', begin) + 1;
    const std::string one = text.substr(text_begin, text.find('\4', begin) - text_begin);
    for (int times = std::stoi(text.substr(begin + 1)); times > 0; --times) all += one;
  }
  return all;
}

bool make(const fs::path& folder, const std::vector<Entry>& entries,
          const std::map<std::string, std::string>& replaced) try {
  fs::create_directories(folder);
  for (const Entry& entry : entries) {
    const fs::path path = folder / entry.path;
    if (path.native().size() < 4000) {
      fs::create_directories(path.parent_path());
      make_one(path, entry, written_out(replace_all(entry.content, replaced)));
      continue;
    }
    fs::current_path(folder);  // the path is longer than a system call accepts
    for (const fs::path& step : fs::path(entry.path).parent_path()) {
      fs::create_directory(step);
      fs::current_path(step);
    }
    make_one(fs::path(entry.path).filename(), entry, written_out(replace_all(entry.content, replaced)));
    fs::current_path("/");
  }
  return true;
} catch (const fs::filesystem_error& error) {
  fs::current_path("/");
  if (error.code() == std::errc::operation_not_permitted) return false;
  throw;
}

}  // namespace robosim::hostile
