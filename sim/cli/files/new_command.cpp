#include "sim/cli/files/new_command.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/cli/output.h"

namespace robosim::cli {
namespace fs = std::filesystem;

namespace {

constexpr const char* kPlaceholder = "NAME";
constexpr std::size_t kLongestName = 63;

fs::path template_folder() {
  const fs::path installed = data_folder() / "new";
  std::error_code error;
  return fs::is_directory(installed, error) ? installed : data_folder() / "sim/cli/files/new";
}

/// Checks a name by the Arduino IDE's rules for sketches, because the folder and the .ino get this name.
void check_name(const std::string& name) {
  const auto is_plain = [](unsigned char c) { return std::isalnum(c) || c == '_'; };
  const auto may_follow = [&](unsigned char c) { return is_plain(c) || c == '-' || c == '.'; };
  if (name.size() <= kLongestName && is_plain(static_cast<unsigned char>(name[0])) && name.back() != '.' &&
      std::all_of(name.begin(), name.end(), may_follow))
    return;
  throw InputError(fmt::format(
      "robosim new: invalid name: expected at most {} letters, digits, - . and _, beginning with a "
      "letter, a digit or _ and not ending with a dot, got “{}”",
      kLongestName, name));
}

std::string filled_in(std::string text, const std::string& name) {
  for (std::size_t at = 0; (at = text.find(kPlaceholder, at)) != std::string::npos; at += name.size())
    text.replace(at, std::char_traits<char>::length(kPlaceholder), name);
  return text;
}

std::vector<fs::path> files_below(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files.push_back(entry.path().lexically_relative(folder));
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

int new_command(const NewArguments& arguments) {
  const std::string& name = arguments.name;
  check_name(name);
  std::error_code error;
  if (fs::symlink_status(name, error).type() != fs::file_type::not_found)
    throw InputError(fmt::format("robosim new: “{}” exists already; nothing was changed", name));
  std::vector<std::string> made;
  for (const fs::path& file : files_below(template_folder())) {
    const std::string target = filled_in(file.string(), name);
    fs::create_directories((name / fs::path(target)).parent_path(), error);
    if (error)
      throw InputError({name, 0, 0}, "robosim new: the folder cannot be created: " + error.message());
    write_file(name / fs::path(target), filled_in(read_file(template_folder() / file), name));
    made.push_back(target);
  }
  print(fmt::format("{}: {}\nnext: cd {} && robosim test\n", name, fmt::join(made, ", "), name));
  return 0;
}

}  // namespace robosim::cli
