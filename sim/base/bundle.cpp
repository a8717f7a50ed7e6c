#include "sim/base/bundle.h"

#include <charconv>

#include "sim/base/error.h"

namespace robosim {

std::string pack(const std::vector<BundledFile>& files) {
  std::string bundle;
  for (const BundledFile& file : files)
    bundle += file.name + ' ' + std::to_string(file.content.size()) + '\n' + file.content;
  return bundle;
}

std::vector<BundledFile> unpack(std::string_view bundle) {
  std::vector<BundledFile> files;
  while (!bundle.empty()) {
    const std::string_view line = bundle.substr(0, bundle.find('\n'));
    const std::size_t space = line.rfind(' ');
    std::size_t size = 0;
    if (space == line.npos || line.size() == bundle.size()) throw InputError("this is not a bundle of files");
    const auto [end, error] = std::from_chars(line.data() + space + 1, line.data() + line.size(), size);
    bundle.remove_prefix(line.size() + 1);
    if (error != std::errc() || end != line.data() + line.size() || size > bundle.size())
      throw InputError("the bundle of files is truncated");
    files.push_back({std::string(line.substr(0, space)), std::string(bundle.substr(0, size))});
    bundle.remove_prefix(size);
  }
  return files;
}

}  // namespace robosim
