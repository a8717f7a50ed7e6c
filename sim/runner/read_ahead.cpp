#include "sim/runner/read_ahead.h"

#include <fcntl.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>

#include "sim/base/descriptor.h"
#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/exec/host/confinement.h"

namespace robosim::runner {
namespace {

constexpr std::size_t kChunk = 16 * 1024;  // bytes

/// Whether `file` holds `text`, and nothing else.
bool holds(const std::filesystem::path& file, std::string_view text) {
  const Descriptor open(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (!open.is_open()) return false;
  std::array<char, kChunk> chunk;
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

ImageAhead image_in(const std::filesystem::path& file, ImageAhead last) {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  const Stamp stamp = stamp_of(file);
  if (last.content && last.stamp == stamp && stamp != Stamp{}) return last;
  ImageAhead image{std::move(last.content),
                   is_settled(stamp, std::chrono::nanoseconds(now).count()) ? stamp : Stamp{}};
  if (image.content && holds(file, image.content->bytes())) return image;
  const auto content = std::make_shared<exec::ImageContent>(read_file(file));
  if (exec::why_not_confined().empty()) content->seal();
  image.content = content;
  return image;
}

void add_robot(const std::string& name, const Robots& last, Robots& robots) {
  if (robots.contains(name)) return;
  try {
    robots.emplace(name, known_robot(name, last));
  } catch (const InputError&) {
  }
}

}  // namespace

std::shared_ptr<const robot::Description> known_robot(const std::string& name, const Robots& last) {
  if (const auto known = last.find(name); known != last.end() && is_as_read(*known->second))
    return known->second;
  return std::make_shared<const robot::Description>(robot::load_description(name));
}

ReadAhead read_ahead(const wire::RunRequest& request, const std::vector<std::size_t>& confined,
                     ReadAhead last) {
  const std::vector<wire::AgentRequest> agents = agents_of(request);
  ReadAhead all;
  for (const wire::AgentRequest& agent : agents) add_robot(agent.robot, last.robots, all.robots);
  for (const std::size_t number : confined) {
    const std::string& file = agents[number].image;
    if (all.images.contains(file)) continue;
    const auto known = last.images.find(file);
    all.images[file] = image_in(file, known == last.images.end() ? ImageAhead{} : known->second);
  }
  return all;
}

std::vector<int> sealed_images(const ReadAhead& ahead) {
  std::vector<int> all;
  for (const auto& [file, image] : ahead.images)
    if (image.content->sealed() >= 0) all.push_back(image.content->sealed());
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace robosim::runner
