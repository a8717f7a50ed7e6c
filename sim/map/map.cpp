#include "sim/map/map.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>

#include "sim/base/did_you_mean.h"
#include "sim/base/file.h"
#include "sim/base/file_kind.h"
#include "sim/map/floor_image.h"
#include "sim/map/map_parser.h"

namespace robosim::map {
namespace fs = std::filesystem;

namespace {

constexpr std::size_t kChunk = 256 * 1024;  // bytes; fits into the second-level cache

class MapFile {
 public:
  explicit MapFile(const fs::path& path) : path_(path), file_(open_to_read(path)) {
    struct stat info {};
    if (::fstat(file_.get(), &info) != 0) fail(errno);
    size_ = static_cast<std::size_t>(info.st_size);
  }

  std::size_t size() const { return size_; }

  /// Returns a buffer for the whole file, limited to `most` bytes. read() fills it completely except at the
  /// file's end.
  std::vector<char> buffer_of(std::size_t most) const { return std::vector<char>(std::min(size_ + 1, most)); }

  /// Returns the beginning of the file, including all front matter.
  std::string beginning() {
    std::vector<char> buffer = buffer_of(MapParser::kMaxFrontMatter + 1024);
    return std::string(read(buffer));
  }

  /// Fills the buffer; returns a shorter view only at the file's end.
  std::string_view read(std::vector<char>& buffer) {
    std::size_t got = 0;
    while (got < buffer.size()) {
      const ssize_t n = ::read(file_.get(), buffer.data() + got, buffer.size() - got);
      if (n < 0 && errno == EINTR) continue;
      if (n < 0) fail(errno);
      if (n == 0) break;
      got += static_cast<std::size_t>(n);
    }
    return {buffer.data(), got};
  }

 private:
  [[noreturn]] void fail(int error) const {
    throw InputError({path_.string()}, std::string("cannot be read: ") + std::strerror(error));
  }

  fs::path path_;
  Descriptor file_;
  std::size_t size_ = 0;
};

std::string sha256_with_picture(std::string_view text, const Map& map) {
  return map.image ? sha256(std::string(text) + map.image->png()) : sha256(text);
}

std::string stem(const std::string& file) { return fs::path(file).stem().string(); }

}  // namespace

namespace {

Map read_whole(MapFile file, const fs::path& path, Draw draw) {
  MapParser parser(path.string(), file.size(), "", draw);
  std::vector<char> buffer = file.buffer_of(kChunk);
  std::string_view chunk = file.read(buffer);
  const std::string_view small = chunk.size() < buffer.size() ? chunk : std::string_view();
  while (!chunk.empty()) {
    parser.feed(chunk);
    chunk = chunk.size() < buffer.size() ? std::string_view() : file.read(buffer);
  }
  Map map = parser.finish();
  if (!small.empty()) map.sha256 = sha256_with_picture(small, map);
  if (map.name.empty()) map.name = stem(map.file);
  return map;
}

}  // namespace

Map read_map(const fs::path& path, Draw draw) {
  try {
    return read_whole(MapFile(path), path, draw);
  } catch (const InputError&) {
    refuse_other_kind(MapFile(path).beginning(), FileKind::map, path.string());
    throw;
  }
}

Map parse_map(std::string_view text, const std::string& file, const std::string& picture, Draw draw) {
  MapParser parser(file, text.size(), picture, draw);
  parser.feed(text);
  Map map = parser.finish();
  map.sha256 = sha256_with_picture(text, map);
  if (map.name.empty()) map.name = stem(file);
  return map;
}

std::string sha256_of(const Map& map) {
  if (!map.sha256.empty()) return map.sha256;
  return map.image ? sha256_with_picture(read_file(map.file), map) : sha256_of_file(map.file);
}

std::string sha256_of_map(const fs::path& path) {
  const std::string picture = MapParser::picture_named_in(MapFile(path).beginning(), path.string());
  if (picture.empty()) return sha256_of_file(path);
  return sha256(read_file(path) + read_file(path.parent_path() / picture, FloorImage::kMostFile_bytes));
}

fs::path find_map(const std::string& name) {
  if (name.find_first_of("/.") != std::string::npos) return name;
  const fs::path folder = data_folder() / "maps";
  fs::path sample = folder / (name + ".map");
  std::error_code error;
  if (!name.empty() && fs::exists(sample, error)) return sample;
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    if (entry.path().extension() == ".map") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  throw InputError(unknown_name("sample map", name, names) + " (a name with / or . is a path)");
}

}  // namespace robosim::map
