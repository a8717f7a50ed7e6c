// Reads arbitrary bytes as a checks.toml. Either the file is rejected with a message that names it, or it is
// valid: each check has a unique name, at least one run, and expected verdicts.
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>

#include "sim/base/error.h"
#include "sim/campaign/check/checks_file.h"
#include "tests/fuzz/require.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace robosim;
  try {
    std::set<std::string> names;
    for (const campaign::Check& check :
         campaign::parse_checks({reinterpret_cast<const char*>(data), size}, "folder/checks.toml")) {
      require(!check.name.empty() && names.insert(check.name).second, "a check has a name of its own");
      require(check.place.file == "folder/checks.toml" && check.place.line >= 1, "a check has its place");
      require(!check.expect.empty(), "there is a verdict to expect");
      require(check.sweep.first_seed <= check.sweep.last_seed, "there is a run");
      for (const campaign::FigureLimit& limit : check.limits)
        require(limit.min || limit.max, "a limit limits");
    }
  } catch (const InputError& error) {
    require(error.place().file == "folder/checks.toml", "errors name the file");
    require(!error.message().empty(), "errors say something");
  }
  return 0;
}
