#include "sim/base/archive.h"

#include <charconv>

#include "sim/base/error.h"

namespace robosim {

std::string pack(const std::vector<ArchivedFile>& files) {
  std::string archive;
  for (const ArchivedFile& file : files)
    archive += file.name + ' ' + std::to_string(file.content.size()) + '\n' + file.content;
  return archive;
}

std::vector<ArchivedFile> unpack(std::string_view archive) {
  std::vector<ArchivedFile> files;
  while (!archive.empty()) {
    const std::string_view line = archive.substr(0, archive.find('\n'));
    const std::size_t space = line.rfind(' ');
    std::size_t size = 0;
    if (space == line.npos || line.size() == archive.size())
      throw InputError("this is not a bundle of files");
    const auto [end, error] = std::from_chars(line.data() + space + 1, line.data() + line.size(), size);
    archive.remove_prefix(line.size() + 1);
    if (error != std::errc() || end != line.data() + line.size() || size > archive.size())
      throw InputError("the bundle of files is truncated");
    files.push_back({std::string(line.substr(0, space)), std::string(archive.substr(0, size))});
    archive.remove_prefix(size);
  }
  return files;
}

}  // namespace robosim
