// Finds code that would not compile for the web page (docs/howto/tab.md). CI does not build this page.
#include <gtest/gtest.h>

#include <filesystem>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "sim/base/file.h"

namespace tab_test {

namespace fs = std::filesystem;

const fs::path kRoot = ROBOSIM_SOURCE_DIR;

/// Returns the words of `text` between `begin` and the next closing parenthesis.
std::vector<std::string> words_behind(const std::string& text, const std::string& begin) {
  const std::size_t at = text.find(begin) + begin.size();
  std::istringstream words(text.substr(at, text.find(')', at) - at));
  return {std::istream_iterator<std::string>(words), {}};
}

std::vector<fs::path> sources_in(const fs::path& folder) {
  std::vector<fs::path> found;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".cpp" || entry.path().extension() == ".h") found.push_back(entry.path());
  return found;
}

// The listed headers come with emscripten, are header-only, or are included only for another processor. The
// test rejects other headers, and features that emscripten's libc++ 13 does not have.
TEST(Tab, IsGivenNothingThatItsCompilerLacks) {
  const std::set<std::string> headers = {"fmt/format.h",     "nlohmann/json.hpp", "toml++/toml.h", "xxhash.h",
                                         "sha2.h",           "cxxabi.h",          "elf.h",         "fcntl.h",
                                         "unistd.h",         "sys/stat.h",        "sys/types.h",   "stdint.h",
                                         "xxh_x86dispatch.h"};
  const std::string list = robosim::read_file(kRoot / "sim/view/tab/CMakeLists.txt");
  std::set<fs::path> elsewhere;
  for (const char* set : {"set(replaced ", "set(left_out "})
    for (const std::string& file : words_behind(list, set)) elsewhere.insert(kRoot / "sim" / (file + ".cpp"));
  elsewhere.insert(kRoot / "sim/exec/elf/dwarf_access.h");  // only the files in left_out include it
  for (const fs::path& file : elsewhere) EXPECT_TRUE(fs::exists(file)) << file;

  std::vector<fs::path> sources;
  for (const std::string& room : words_behind(list, "foreach(room\n"))
    for (const fs::path& file : sources_in(kRoot / room)) sources.push_back(file);
  EXPECT_GT(sources.size(), 300u);
  const std::regex include("#include <([^>]*\\.h(?:pp)?)>"),
      lacking("std::(ranges::|bit_cast|jthread|format\\()");
  for (const fs::path& file : sources) {
    if (elsewhere.contains(file)) continue;
    const std::string text = robosim::read_file(file);
    for (std::sregex_iterator found(text.begin(), text.end(), include), end; found != end; ++found) {
      const std::string header = (*found)[1];
      if (header.starts_with("toml++/impl")) continue;
      EXPECT_TRUE(headers.contains(header))
          << file << " includes <" << header
          << ">, which a browser's tab does not have: replace the file by one "
          << "in sim/view/tab/instead, or add it to left_out (sim/view/tab/CMakeLists.txt)";
    }
    std::smatch found;
    EXPECT_FALSE(std::regex_search(text, found, lacking))
        << file << " uses " << found[0] << ", which emscripten's libc++ 13 does not have";
  }
}

}  // namespace tab_test
