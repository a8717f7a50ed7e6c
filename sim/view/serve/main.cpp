// robosim-serve FOLDER ADDRESS PORT ROBOSIM: the server program, which `robosim serve` starts after it has
// checked all arguments.
#include <fmt/format.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <thread>

#include "sim/base/error.h"
#include "sim/view/serve/server.h"

namespace {

int serve(char** words) {
  sigset_t ends;
  sigemptyset(&ends);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&ends, signal);
  pthread_sigmask(SIG_BLOCK, &ends, nullptr);  // one thread waits for these signals
  std::signal(SIGPIPE, SIG_IGN);
  robosim::serve::Server server({words[1], words[4], words[2], std::atoi(words[3])});
  fmt::print("Open {}\nPress Ctrl-C to stop the server.\n", server.url());
  std::fflush(stdout);
  std::thread waiting([&] {
    int signal = 0;
    sigwait(&ends, &signal);
    server.stop();
  });
  server.serve();
  waiting.detach();  // if the server ended by itself, the thread still waits
  return 0;
}

}  // namespace

int main(int count, char** words) {
  if (count != 5) {
    fmt::print(stderr, "robosim: start this program with robosim serve\n");
    return 2;
  }
  try {
    return serve(words);
  } catch (const robosim::InputError& error) {
    fmt::print(stderr, "robosim: {}\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "robosim: internal error: {}\n", error.what());
    return 3;
  }
}
