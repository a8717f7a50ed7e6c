// A part of a campaign whose runs are distributed over several machines: --shard 2/8, and --merge of the
// results.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace robosim::cli {

struct Shard {
  std::uint64_t index = 0;  ///< from 0; the command line counts from 1
  std::uint64_t count = 1;  ///< 1 = all runs are made here

  bool whole() const { return count == 1; }
  /// Returns whether a run is of this shard: every count-th, so that slow runs are spread over all.
  bool has(std::size_t run) const { return run % count == index; }
  /// Returns the campaign's number of this shard's n-th run, both from 0.
  std::uint64_t run(std::uint64_t n) const { return n * count + index; }
  /// Returns how many of `runs` are of this shard.
  std::size_t share_of(std::size_t runs) const { return runs / count + (runs % count > index ? 1 : 0); }
  /// Returns "2/8"
  std::string text() const;
};

/// Parses the value of --shard. Throws InputError.
Shard read_shard(const std::string& text);

}  // namespace robosim::cli
