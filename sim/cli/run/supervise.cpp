#include "sim/cli/run/supervise.h"

#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/time.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <new>
#include <stdexcept>

#include "sim/base/child.h"
#include "sim/base/error.h"
#include "sim/cli/output.h"

namespace robosim::cli {
namespace {

constexpr int kPatience_s = 5;
constexpr int kLoopsStatus = 99;

const Progressed* watched = nullptr;
std::uint64_t moves_at_last_look = 0;
int seconds_without_a_move = 0;

void on_timer(int) {
  const bool moved = watched->moves() != moves_at_last_look;
  seconds_without_a_move = moved ? 0 : seconds_without_a_move + 1;
  if (seconds_without_a_move == kPatience_s) ::_exit(kLoopsStatus);
  moves_at_last_look = watched->moves();
}

void start_watchdog(const Progressed& progressed) {
  watched = &progressed;
  struct sigaction action {};
  action.sa_handler = on_timer;
  action.sa_flags = SA_RESTART;
  ::sigaction(SIGVTALRM, &action, nullptr);
  const timeval every{1, 0};
  const itimerval timer{every, every};
  ::setitimer(ITIMER_VIRTUAL, &timer, nullptr);
}

int run_in_child(const std::string& name, const std::function<int(Progressed&)>& work,
                 Progressed& progressed) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  // Restores the default actions, so that the parent sees the signal of a crash. A sanitizer's handlers would
  // turn the crash into a normal exit.
  for (const int crash : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) ::signal(crash, SIG_DFL);
  start_watchdog(progressed);
  int status = static_cast<int>(ExitStatus::failed);
  try {
    status = work(progressed);
  } catch (const InputError& error) {
    complain(fmt::format("robosim: {}: {}\n", name, error.what()));
    status = static_cast<int>(ExitStatus::bad_input);
  } catch (const std::exception& error) {
    complain(fmt::format("robosim: {} threw an exception: {}\n", name, error.what()));
  } catch (...) {
    complain(fmt::format("robosim: {} threw something other than a std::exception\n", name));
  }
  progressed.finish();
  return status;
}

std::string cause_of_death(const Ending& ending) {
  if (ending.signal > 0) return fmt::format("crashed ({})", ::strsignal(ending.signal));
  if (ending.status == kLoopsStatus)
    return fmt::format("loops without end: no move in {} s of processor time", kPatience_s);
  return fmt::format("ended the program by itself, with exit status {}", ending.status);
}

}  // namespace

int supervise(const std::string& name, const std::function<int(Progressed&)>& work) {
  void* const memory =
      ::mmap(nullptr, sizeof(Progressed), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw std::runtime_error(std::string("out of memory: ") + std::strerror(errno));
  auto& progressed = *new (memory) Progressed;
  const Ending ending = Child([&] { return run_in_child(name, work, progressed); }).wait();
  if (ending.signal == 0 && progressed.finished()) return ending.status;
  const cells::CellPose& pose = progressed.pose();
  const std::string where =
      progressed.moves() == 0
          ? "before its first move"
          : fmt::format("after {} move{}, the last from {},{},{}", progressed.moves(),
                        progressed.moves() == 1 ? "" : "s", pose.cell.x, pose.cell.y, letter(pose.facing));
  complain(fmt::format("robosim: {} {}, {}\n", name, cause_of_death(ending), where));
  return static_cast<int>(ExitStatus::failed);
}

}  // namespace robosim::cli
