#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "sim/base/file.h"
#include "sim/sketch/elf_file.h"
#include "sim/sketch/sketch.h"
#include "sim/sketch/toolchain.h"

namespace robosim::sketch {

std::string missing_tool(const std::string& target_name) {
  const Target& target = find_target(target_name);
  try {
    find_compiler(target);
    if (target.archiver.name) find_tool(target, target.archiver);
    for (const Product& product : target.products) find_tool(target, product.program);
    find_core();
    find_ctags();
    return {};
  } catch (const ToolMissing& error) {
    return error.what();
  }
}

void check_can_sanitize(const std::string& target) {
  if (find_target(target).sanitizer.undefined.empty())
    throw InputError(fmt::format("--sanitize: there are no checks for the target {}", target));
}

void check_can_cover(const std::string& target) {
  if (find_target(target).coverage.own.empty())
    throw InputError("--coverage is for --target host; a chip has no room for its counters");
}

std::vector<Limit> stated_limits(const Image& image) {
  constexpr std::string_view kPrefix = "linekit_limit_";
  std::vector<Limit> limits;
  for (const AbsoluteSymbol& symbol : absolute_symbols(read_file(image.image), kPrefix)) {
    std::string what = symbol.name.substr(kPrefix.size());
    std::replace(what.begin(), what.end(), '_', ' ');
    if (limits.empty() || limits.back().what != what) limits.push_back({what, symbol.value});
  }
  return limits;
}

}  // namespace robosim::sketch
