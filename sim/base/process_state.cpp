#include "sim/base/process_state.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <string_view>

#include "sim/base/descriptor.h"

namespace robosim {

char process_state(pid_t process) {
  // Avoids a stream, which throws if the process ends after the file is opened and before it is read.
  const Descriptor file(::open(fmt::format("/proc/{}/stat", process).c_str(), O_RDONLY | O_CLOEXEC));
  char facts[512];  // the number, the name in parentheses, the state, and further fields
  const ssize_t size = file.is_open() ? ::read(file.get(), facts, sizeof facts) : -1;
  if (size <= 0) return '\0';
  const std::string_view text(facts, static_cast<std::size_t>(size));
  const std::size_t name_end = text.rfind(") ");
  return name_end == text.npos || name_end + 2 >= text.size() ? '\0' : text[name_end + 2];
}

}  // namespace robosim
