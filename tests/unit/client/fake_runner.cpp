// Replaces robosim-host in tests, and plays back a file. Tests start this program through a symbolic link.
// The file's name is the link's name plus ".play". Each line is sent unchanged, except for these commands:
//   !wait          reads one request
//   !signal N      ends itself with signal N
//   !exit N        ends with status N
//   !interrupt     waits until SIGINT arrives
//   !echo          sends a note that quotes the last request
//   !flood N       sends N samples
#include <signal.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

namespace {
volatile sig_atomic_t interrupted = 0;
}

int main(int, char** arguments) {
  struct sigaction action {};
  action.sa_handler = [](int) { interrupted = 1; };
  sigaction(SIGINT, &action, nullptr);
  std::ifstream play(std::string(arguments[0]) + ".play");
  std::string line, request;
  while (std::getline(play, line)) {
    const auto argument = [&] { return std::atoi(line.substr(line.find(' ')).c_str()); };
    if (line == "!wait") {
      if (!std::getline(std::cin, request)) return 0;
    } else if (line.rfind("!signal", 0) == 0) {
      std::cout.flush();
      signal(argument(), SIG_DFL);  // a sanitizer's handler would turn the signal into an exit
      raise(argument());
    } else if (line.rfind("!exit", 0) == 0) {
      return argument();
    } else if (line == "!interrupt") {
      std::cout.flush();
      sigset_t block, before;
      sigemptyset(&block);
      sigaddset(&block, SIGINT);
      sigprocmask(SIG_BLOCK, &block, &before);
      while (!interrupted) sigsuspend(&before);
      sigprocmask(SIG_SETMASK, &before, nullptr);
      interrupted = 0;
    } else if (line == "!echo") {
      std::string text;
      for (const char c : request) text += c == '"' || c == '\\' || c == '\n' ? '\'' : c;
      std::cout << R"({"id": 1, "event": "note", "t_ns": 0, "text": ")" << text << "\"}" << std::endl;
    } else if (line.rfind("!flood", 0) == 0) {
      for (int i = 0; i < argument(); ++i) {
        std::cout
            << R"({"id": 1, "event": "sample", "t_us": )" << i * 10000
            << R"(, "x": 1, "y": 2, "yaw": 0, "speed_mm_s": 0, "cross_track": 0, "left": 0, "right": 0, )"
            << R"("readings": []})" << '\n';
      }
      std::cout.flush();
    } else {
      std::cout << line << std::endl;
    }
  }
  std::string rest;
  while (std::getline(std::cin, rest)) {
  }
}
