#include "sim/campaign/shard.h"

#include <fmt/format.h>

#include <charconv>

#include "sim/base/option_values.h"

namespace robosim::campaign {
namespace {

constexpr std::uint64_t kMostShards = 100'000;

}  // namespace

std::string Shard::text() const { return fmt::format("{}/{}", index + 1, count); }

Shard read_shard(const std::string& text) {
  std::uint64_t index = 0, count = 0;
  const char* const end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, index);
  bool good = first.ec == std::errc() && first.ptr != end && *first.ptr == '/';
  if (good) {
    const auto second = std::from_chars(first.ptr + 1, end, count);
    good = second.ec == std::errc() && second.ptr == end;
  }
  if (!good || count < 1 || count > kMostShards || index < 1 || index > count)
    refuse_value("--shard", text,
                 fmt::format("PART/PARTS, as in 1/8 to 8/8, with at most {} parts", kMostShards));
  return {index - 1, count};
}

}  // namespace robosim::campaign
