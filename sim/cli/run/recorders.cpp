#include "sim/cli/run/recorders.h"

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

std::vector<WriteClaim> claims_of(const RunArguments& arguments) {
  std::vector<WriteClaim> claims;
  for (const auto* files : {&arguments.record, &arguments.plot})
    for (const std::string& file : *files) claims.emplace_back(file);
  return claims;
}

}  // namespace robosim::cli
