#include "sim/base/pluralize.h"

#include <fmt/format.h>

namespace robosim {

std::string pluralize(std::size_t n, std::string_view noun) {
  return fmt::format("{} {}{}", n, noun, n == 1 ? "" : "s");
}

}  // namespace robosim
