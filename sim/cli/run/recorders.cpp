#include "sim/cli/run/recorders.h"

#include <fmt/format.h>

#include "sim/launch/names.h"

namespace robosim::cli {

record::Recorders recorders_of(const RunArguments& arguments) {
  std::vector<std::string> files = arguments.plot;
  launch::name_flag("--plot", [&] {
    for (const std::string& file : files) record::check_is_picture(file);
  });
  files.insert(files.end(), arguments.record.begin(), arguments.record.end());
  record::Recorders recorders;
  launch::name_flag("--record", [&] { recorders = record::Recorders(files); });
  return recorders;
}

std::vector<FileLock> claims_of(const RunArguments& arguments) {
  std::vector<FileLock> claims;
  for (const auto* files : {&arguments.record, &arguments.plot})
    for (const std::string& file : *files) claims.emplace_back(file);
  return claims;
}

std::string written_text(const std::vector<std::string>& files) {
  std::string text;
  for (const std::string& file : files)
    text += fmt::format("{} is written{}\n", file, file.ends_with(".html") ? "; open it in a browser" : "");
  return text;
}

std::string written_text(const RunArguments& arguments) {
  return written_text(arguments.record) + written_text(arguments.plot);
}

}  // namespace robosim::cli
