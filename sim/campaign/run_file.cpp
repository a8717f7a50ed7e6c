#include "sim/campaign/run_file.h"

#include <cerrno>
#include <cstring>
#include <utility>

#include "sim/base/error.h"
#include "sim/base/file.h"

namespace robosim::campaign {
namespace {

[[noreturn]] void refuse_to_write(const std::filesystem::path& path) {
  throw InputError({path.string(), 0, 0}, std::string("cannot be written: ") + std::strerror(errno));
}

}  // namespace

RunFile::RunFile(std::filesystem::path path) : path_(std::move(path)), lock_(path_) {}

void RunFile::begin(const std::string& text) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path_, error) || read_file(path_) != text) write_file(path_, text);
  file_.reset(std::fopen(path_.c_str(), "a"));
  if (!file_) refuse_to_write(path_);
}

void RunFile::append(const std::string& line) {
  if (std::fwrite(line.data(), 1, line.size(), file_.get()) != line.size() || std::fflush(file_.get()) != 0)
    refuse_to_write(path_);
}

}  // namespace robosim::campaign
