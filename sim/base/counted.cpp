#include "sim/base/counted.h"

#include <fmt/format.h>

namespace robosim {

std::string counted(std::size_t n, std::string_view noun) {
  return fmt::format("{} {}{}", n, noun, n == 1 ? "" : "s");
}

}  // namespace robosim
