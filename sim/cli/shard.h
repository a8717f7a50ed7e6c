// A part of a campaign whose runs are made on several machines: --shard 2/8, and --merge of what came of
// them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace robosim::cli {

struct Shard {
  std::uint64_t index = 0;  ///< from 0; the command line counts from 1
  std::uint64_t count = 1;  ///< 1 = all runs are made here

  bool whole() const { return count == 1; }
  /// Every count-th, so that what takes long is spread over all.
  bool has(std::size_t run) const { return run % count == index; }
  /// The run of the campaign that is the n-th of this shard, both from 0.
  std::uint64_t run(std::uint64_t n) const { return n * count + index; }
  /// How many of so many are of this shard.
  std::size_t share_of(std::size_t runs) const { return runs / count + (runs % count > index ? 1 : 0); }
  /// "2/8"
  std::string text() const;
};

/// The value of --shard. Throws InputError.
Shard read_shard(const std::string& text);

}  // namespace robosim::cli
