#include "sim/runner/read_ahead.h"

#include <fcntl.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>

#include "sim/base/descriptor.h"
#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/map/floor_image.h"

namespace robosim::runner {
namespace {

constexpr std::size_t kCompared = 16 * 1024;  // bytes
constexpr std::size_t kMaps = 4;              // number of cached maps
constexpr std::size_t kMostKnown_bytes = 1 << 20;
constexpr long long kLargestMap = 1024 * 1024;  // bytes; the floor of a larger map takes much memory

/// Returns whether the content of `file` is exactly `text`.
bool holds(const std::filesystem::path& file, std::string_view text) {
  const Descriptor open(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (!open.is_open()) return false;
  std::array<char, kCompared> chunk;
  for (;;) {
    const ssize_t n = ::read(open.get(), chunk.data(), chunk.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return n == 0 && text.empty();
    const auto bytes = static_cast<std::size_t>(n);
    if (text.substr(0, bytes) != std::string_view(chunk.data(), bytes)) return false;
    text.remove_prefix(bytes);
  }
}

bool is_as_read(const robot::Description& robot) {
  return std::all_of(robot.texts.begin(), robot.texts.end(),
                     [](const robot::SourceText& one) { return holds(one.file, one.text); });
}

ImageAhead image_in(const std::filesystem::path& file, ImageAhead last, long long now) {
  const FileIdentity identity = identity_of(file);
  if (last.content && last.identity == identity && identity != FileIdentity{}) return last;
  ImageAhead image{std::move(last.content), is_settled(identity, now) ? identity : FileIdentity{},
                   std::move(last.lines)};
  if (!image.content || !image.content->is_like(file)) {
    image.content = std::make_shared<const exec::ImageContent>(file);
    image.lines = std::make_shared<KnownLines>();
  }
  return image;
}

std::filesystem::path picture_of(const map::Map& map) {
  return map.image ? std::filesystem::path(map.file).parent_path() / map.image->name() : "";
}

bool is_as_read(const MapAhead& ahead, const FileIdentity& identity) {
  if (ahead.identity != identity || identity == FileIdentity{}) return false;
  const std::filesystem::path picture = picture_of(ahead.read->map);
  return picture.empty() || (ahead.picture != FileIdentity{} && identity_of(picture) == ahead.picture);
}

MapAhead map_in(const std::string& name, const map::Draw& draw, const FileIdentity& identity, long long now) {
  MapAhead ahead{name, draw, is_settled(identity, now) ? identity : FileIdentity{}};
  ahead.read = std::make_shared<ReadMap>(name, draw);
  ahead.read->prepared_map = std::make_unique<run::PreparedMap>(ahead.read->map);
  if (const std::filesystem::path picture = picture_of(ahead.read->map); !picture.empty()) {
    const FileIdentity of_picture = identity_of(picture);
    if (is_settled(of_picture, now)) ahead.picture = of_picture;
  }
  return ahead;
}

void prepare_errands(ReadMap& read, const wire::RunRequest& request) {
  const std::vector<run::Mission> missions = missions_of(request, read.map);
  for (std::size_t i = 0; i < missions.size(); ++i) read.prepared_map->prepare(i, missions[i]);
}

/// Moves or adds the request's map to the front of `maps`, and returns it. Returns null if the map is too
/// large or cannot be read.
std::shared_ptr<ReadMap> add_map(const wire::RunRequest& request, std::vector<MapAhead>& maps,
                                 long long now) {
  try {
    const FileIdentity identity = identity_of(request.map);
    if (size_in(identity) > kLargestMap) return nullptr;
    const map::Draw draw = draw_of(request);
    const auto known = std::find_if(maps.begin(), maps.end(), [&](const MapAhead& one) {
      return one.name == request.map && one.draw.profile == draw.profile &&
             (!one.read->map.differs || one.draw.seed == draw.seed) && is_as_read(one, identity);
    });
    if (known != maps.end())
      std::rotate(maps.begin(), known, known + 1);
    else
      maps.insert(maps.begin(), map_in(request.map, draw, identity, now));
    if (maps.size() > kMaps) maps.resize(kMaps);
    prepare_errands(*maps.front().read, request);
    return maps.front().read;
  } catch (const InputError&) {
    return nullptr;
  }
}

void add_robot(const std::string& name, const Robots& last, Robots& robots) {
  if (robots.contains(name)) return;
  try {
    robots.emplace(name, known_robot(name, last));
  } catch (const InputError&) {
  }
}

}  // namespace

std::string KnownLines::find(const std::vector<std::uintptr_t>& offsets,
                             const std::function<std::string()>& ask) {
  if (const auto known = outputs_.find(offsets); known != outputs_.end()) return known->second;
  std::string output = ask();
  const std::size_t bytes = output.size() + offsets.size() * sizeof offsets[0];
  if (output.empty() || bytes > kMostKnown_bytes) return output;
  if (bytes_ + bytes > kMostKnown_bytes) outputs_.clear(), bytes_ = 0;
  bytes_ += bytes;
  return outputs_[offsets] = std::move(output);
}

long long wall_ns() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::nanoseconds(now).count();
}

std::shared_ptr<const robot::Description> known_robot(const std::string& name, const Robots& last) {
  if (const auto known = last.find(name); known != last.end() && is_as_read(*known->second))
    return known->second;
  return std::make_shared<const robot::Description>(robot::load_description(name));
}

ReadAhead read_ahead(const wire::RunRequest& request, const std::vector<std::size_t>& confined,
                     ReadAhead last, long long now) {
  const std::vector<wire::AgentRequest> agents = agents_of(request);
  ReadAhead all;
  all.maps = std::move(last.maps);
  all.map = add_map(request, all.maps, now);
  for (const wire::AgentRequest& agent : agents) add_robot(agent.robot, last.robots, all.robots);
  for (const std::size_t number : confined) {
    const std::string& file = agents[number].image;
    if (all.images.contains(file)) continue;
    const auto known = last.images.find(file);
    all.images[file] = image_in(file, known == last.images.end() ? ImageAhead{} : known->second, now);
  }
  return all;
}

std::vector<int> sealed_images(const ReadAhead& ahead) {
  std::vector<int> all;
  for (const auto& [file, image] : ahead.images) all.push_back(image.content->sealed().get());
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace robosim::runner
