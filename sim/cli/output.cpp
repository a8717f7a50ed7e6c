#include "sim/cli/output.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>

#include "sim/base/error.h"

namespace robosim::cli {

namespace {

void write_out(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0) return;
  throw InputError(std::string("cannot write to standard output: ") + std::strerror(errno));
}
void write_error(std::string_view text) { std::fwrite(text.data(), 1, text.size(), stderr); }

bool on_terminal() { return ::isatty(STDOUT_FILENO) != 0; }

}  // namespace

void print(std::string_view text) { write_out(on_terminal() ? for_terminal(text) : std::string(text)); }
void complain(std::string_view text) { write_error(for_terminal(text)); }
void print_coloured(std::string_view text) { write_out(text); }
void complain_coloured(std::string_view text) { write_error(text); }

void SerialPrinter::add(std::string_view text) {
  write_out(on_terminal() ? shown_.add(text) : std::string(text));
}
void SerialPrinter::finish() { write_out(shown_.finish()); }

void open_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(stream, F_GETFD) >= 0) continue;
    if (::open("/dev/null", stream == STDERR_FILENO ? O_WRONLY : O_RDONLY) < 0) return;
  }
}

}  // namespace robosim::cli
