// One machine's part of a campaign, if several machines share the runs: --shard 2/8, and --merge for the
// results.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace robosim::campaign {

struct Shard {
  std::uint64_t index = 0;  ///< from 0; the command line counts from 1
  std::uint64_t count = 1;  ///< 1 = this machine makes all runs

  bool whole() const { return count == 1; }
  /// Returns whether a run belongs to this shard. A shard has every count-th run, so that slow runs are
  /// spread over all shards.
  bool has(std::size_t run) const { return run % count == index; }
  /// Returns the number, within the campaign, of this shard's n-th run. Both count from 0.
  std::uint64_t run(std::uint64_t n) const { return n * count + index; }
  /// Returns the number of this shard's runs among `runs`.
  std::size_t share_of(std::size_t runs) const { return runs / count + (runs % count > index ? 1 : 0); }
  /// Returns "2/8"
  std::string text() const;
};

/// Parses the value of --shard. Throws InputError.
Shard read_shard(const std::string& text);

}  // namespace robosim::campaign
