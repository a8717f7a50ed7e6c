#include "sim/cli/output.h"

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "sim/base/error.h"

namespace robosim::cli {

void print(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0) return;
  throw InputError(std::string("the standard output cannot be written: ") + std::strerror(errno));
}

}  // namespace robosim::cli
