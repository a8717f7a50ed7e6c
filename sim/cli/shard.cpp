#include "sim/cli/shard.h"

#include <fmt/format.h>

#include "sim/cli/options.h"

namespace robosim::cli {
namespace {

constexpr std::uint64_t kMostShards = 100'000;

}  // namespace

std::string Shard::text() const { return fmt::format("{}/{}", index + 1, count); }

Shard read_shard(const std::string& text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos) refuse_value("--shard", text, "which of how many, as in 1/8 … 8/8");
  const std::uint64_t count = whole_number("--shard", text.substr(slash + 1), 1, kMostShards);
  return {whole_number("--shard", text.substr(0, slash), 1, count) - 1, count};
}

}  // namespace robosim::cli
