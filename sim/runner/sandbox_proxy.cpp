#include "sim/runner/sandbox_proxy.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/random.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <memory>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "sim/base/wall_clock.h"
#include "sim/exec/host/confinement.h"
#include "sim/runner/line_io.h"

namespace robosim::runner {
namespace {

constexpr char kLine = 'L';
constexpr char kAnswer = 'A';
constexpr char kAskForRoom = 'r';
constexpr std::uint32_t kMostBytes = 256u << 20;
constexpr std::size_t kChunk = 65536;
constexpr int kLook_ms = 100;

[[noreturn]] void fail(const char* what) { throw std::system_error(errno, std::generic_category(), what); }

/// First descriptor after those of a run's process (SandboxProxy::enter()).
constexpr int kAside = exec::kFirstSealed;

/// Returns a descriptor of /dev/null, which all runs share.
int nothing() {
  static const Descriptor null = [] {
    Descriptor opened(::open("/dev/null", O_RDWR | O_CLOEXEC));
    if (!opened.is_open()) fail("/dev/null");
    return at_least(kAside, std::move(opened));
  }();
  return null.get();
}

void fill_random(void* to, std::size_t bytes) {
  if (::getrandom(to, bytes, 0) != static_cast<ssize_t>(bytes)) fail("getrandom");
}

void write_keyed(const char* data, std::size_t bytes) {
  while (bytes > 0) {
    const long n = exec::keyed_write(exec::kTellFd, data, bytes);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) exec::keyed_exit(0);  // the runner has ended
    data += n;
    bytes -= static_cast<std::size_t>(n);
  }
}

void read_keyed(char* to, std::size_t bytes) {
  while (bytes > 0) {
    const long n = exec::keyed_read(exec::kAnswersFd, to, bytes);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) exec::keyed_exit(0);
    to += n;
    bytes -= static_cast<std::size_t>(n);
  }
}

/// Limits a pipe to the size of the pipe `model`. A run can then get only as far ahead of its reader as it
/// could with `model`.
void make_as_short(int pipe, int model) {
  const int bytes = ::fcntl(model, F_GETPIPE_SZ);
  if (bytes > 0) ::fcntl(pipe, F_SETPIPE_SZ, bytes);
}

}  // namespace

SandboxProxy::SandboxProxy(bool batches, bool lines) {
  if (batches) batches_.emplace();
  if (lines) lines_.emplace();
  nothing();
  for (Descriptor* end : {&told_.write, &answers_.read, lines_ ? &lines_->read : nullptr})
    if (end) *end = at_least(kAside, std::move(*end));
  fill_random(&token_, sizeof token_);
  fill_random(key_, sizeof key_);
  for (std::uint32_t& half : key_) half &= 0x7FFFFFFF;  // sign extension in registers then has no effect
  make_as_short(told_.write.get(), STDOUT_FILENO);
  exec::prepare_to_confine();
}

void SandboxProxy::enter(const std::vector<int>& kept) {
  const std::array<int, 3> ends = {told_.write.get(), answers_.read.get(),
                                   lines_ ? lines_->read.get() : nothing()};
  const std::array<int, 3> places = {exec::kTellFd, exec::kAnswersFd, exec::kLinesFd};
  for (int fd = 0; fd <= STDERR_FILENO; ++fd) ::dup2(nothing(), fd);
  for (std::size_t i = 0; i < ends.size(); ++i) ::dup2(ends[i], places[i]);
  unsigned next = exec::kImageFd;
  for (const int fd : kept) {
    if (static_cast<unsigned>(fd) > next) ::close_range(next, static_cast<unsigned>(fd) - 1, 0);
    next = static_cast<unsigned>(fd) + 1;
  }
  ::close_range(next, ~0u, 0);
}

void SandboxProxy::confine(bool has_grown) const {
  watch_->close();
  exec::confine({key_[0], key_[1]}, has_grown);
}

void SandboxProxy::send(char what, const std::string& text) const {
  const Header header{token_, batch_, static_cast<std::uint32_t>(text.size()), what};
  std::string all(reinterpret_cast<const char*>(&header), sizeof header);
  all += text;
  write_keyed(all.data(), all.size());
}

void SandboxProxy::tell(const std::string& line) const { send(kLine, line); }

void SandboxProxy::answer(const std::string& line) const { send(kAnswer, line); }

std::string SandboxProxy::ask(char what, const std::string& question) const {
  send(what, question);
  std::uint32_t bytes = 0;
  read_keyed(reinterpret_cast<char*>(&bytes), sizeof bytes);
  std::string answer(bytes, '\0');
  read_keyed(answer.data(), bytes);
  return answer;
}

wire::BatchMemory& SandboxProxy::hand_on() {
  (*batches_)->handed_on.store(++batch_, std::memory_order_release);
  const std::size_t ahead = batch_ - (*batches_)->taken.load(std::memory_order_acquire);
  if (ahead >= kBatches)
    ask(kAskForRoom, "");
  else if (ahead >= kWaking)
    send(kLine, "");
  return *waiting();
}

long SandboxProxy::read_some(char* to, std::size_t bytes) const {
  watch_->wait_for_client(true);
  const long n = exec::keyed_read(exec::kLinesFd, to, bytes);
  watch_->wait_for_client(false);
  return n;
}

bool SandboxProxy::take_batches(std::size_t end, const wire::Id& id) {
  if (end - batch_ > (batches_ ? kBatches : 0)) return false;
  while (batch_ != end) {
    wire::BatchMemory& memory = *waiting();
    // Limits the size, because firmware may have overwritten it.
    const std::size_t bytes =
        std::min<std::size_t>(memory.used.load(std::memory_order_relaxed), wire::BatchMemory::kRoom_bytes);
    if (bytes > 0) write_batch(wire::batch_line(id, bytes), {memory.bytes, bytes});
    memory.used.store(0, std::memory_order_relaxed);
    (*batches_)->taken.store(++batch_, std::memory_order_release);
  }
  return true;
}

/// Writes `text` to a pipe of the run. Continues to watch the run meanwhile, since firmware may never read
/// the text.
void SandboxProxy::hand(const Pipe& pipe, std::string_view text, Told& told) {
  while (!text.empty()) {
    const ssize_t n = ::write(pipe.write.get(), text.data(), text.size());
    if (n >= 0) {
      text.remove_prefix(static_cast<std::size_t>(n));
      continue;
    }
    if (errno == EINTR) continue;
    if (errno != EAGAIN) return;  // the run has ended
    pollfd room{pipe.write.get(), POLLOUT, 0};
    ::poll(&room, 1, kLook_ms);
    if ((told.found = watch_->look()) != RunWatch::Found::nothing) return;
  }
}

/// Handles and removes complete messages in `taken`. Returns false if a message is invalid.
bool SandboxProxy::take(std::string& taken, const Ask& ask, const wire::Id& id, Told& told) {
  std::string out;
  std::size_t at = 0;
  for (Header header{}; taken.size() - at >= sizeof header;) {
    std::memcpy(&header, taken.data() + at, sizeof header);
    if (header.token != token_ || header.bytes > kMostBytes || told.answer) return false;
    if (taken.size() - at < sizeof header + header.bytes) break;
    const std::string_view text(taken.data() + at + sizeof header, header.bytes);
    at += sizeof header + header.bytes;
    if (header.batches != batch_) {
      if (!out.empty()) write_line(std::exchange(out, ""));
      if (!take_batches(header.batches, id)) return false;
    }
    if (header.what == kLine) {
      out += text;
    } else if (header.what == kAnswer) {
      told.answer = text;
    } else {
      const std::string said = header.what == kAskForRoom ? "" : ask(header.what, std::string(text));
      const auto bytes = static_cast<std::uint32_t>(said.size());
      hand(answers_, std::string(reinterpret_cast<const char*>(&bytes), sizeof bytes) + said, told);
      if (told.found != RunWatch::Found::nothing) return true;
    }
  }
  taken.erase(0, at);
  if (!out.empty()) write_line(out);
  return true;
}

SandboxProxy::Told SandboxProxy::serve(const Child& run, const Ask& ask, const wire::Id& id,
                                       RunWatch::Limits limits) {
  told_.write.close();
  answers_.read.close();
  if (lines_) lines_->read.close();
  for (const Pipe* pipe : {&answers_, lines_ ? &*lines_ : nullptr})
    if (pipe) ::fcntl(pipe->write.get(), F_SETFL, O_NONBLOCK);
  limits.may_wait = lines_.has_value();
  watch_->follow(run.pid(), limits);
  Told told;
  std::string taken;
  const auto buffer = std::make_unique_for_overwrite<char[]>(kChunk);
  std::int64_t looked_us = wall_us();
  std::array<pollfd, 2> ready = {pollfd{told_.read.get(), POLLIN, 0},
                                 pollfd{lines_ ? STDIN_FILENO : -1, POLLIN, 0}};
  if (lines_) hand(*lines_, take_unread(), told);
  for (;;) {
    const int some = ::poll(ready.data(), ready.size(), kLook_ms);
    if (some < 0) continue;
    if (some == 0) {
      // Takes the batches up to `end` if the pipe is empty: all messages before them have then been handled.
      const std::size_t end = handed_on();
      if (taken.empty() && ::poll(ready.data(), 1, 0) == 0) take_batches(end, id);
    }
    // Watches a run that sends continuously, too.
    if (const std::int64_t now_us = wall_us(); some == 0 || now_us - looked_us >= 1000 * kLook_ms) {
      looked_us = now_us;
      if ((told.found = watch_->look()) != RunWatch::Found::nothing) return told;
    }
    if (ready[1].revents) {
      char chunk[4096];
      const ssize_t n = ::read(STDIN_FILENO, chunk, sizeof chunk);
      if (n < 0 && errno == EINTR) continue;
      if (n > 0) hand(*lines_, {chunk, static_cast<std::size_t>(n)}, told);
      if (n <= 0) ready[1].fd = -1, lines_->write.close();
    }
    if (!ready[0].revents) continue;
    const ssize_t n = ::read(told_.read.get(), buffer.get(), kChunk);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) {
      told.forged |= !taken.empty();
      take_batches(handed_on(), id);
      return told;
    }
    taken.append(buffer.get(), static_cast<std::size_t>(n));
    told.forged = !take(taken, ask, id, told);
    if (told.forged || told.found != RunWatch::Found::nothing) return told;
    watch_->heard();
  }
}

}  // namespace robosim::runner
