#include "sim/campaign/rerun/line_counts.h"

#include <sstream>
#include <system_error>

#include "sim/base/archive.h"
#include "sim/base/file.h"

namespace robosim::campaign {
namespace fs = std::filesystem;

std::map<std::pair<std::string, int>, double> take_line_counts(const fs::path& file) {
  std::map<std::pair<std::string, int>, double> counts;
  std::error_code none;
  if (!fs::exists(file, none)) return counts;
  const std::string bundle = read_file(file);
  fs::remove(file, none);
  for (const ArchivedFile& part : unpack(bundle)) {
    std::istringstream text(part.content);
    int line = 0;
    double count = 0.0;
    for (std::string name; text >> line >> count && std::getline(text >> std::ws, name);)
      counts[{name, line}] = count;
  }
  return counts;
}

}  // namespace robosim::campaign
