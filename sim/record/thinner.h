// Thins rows of changes to the last one in each span of time, for runs with too many of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "sim/record/compressed_bytes.h"
#include "sim/wire/columns.h"

namespace robosim::record {

/// Rows of a stream.
struct CompressedRows {
  CompressedRows(std::size_t width, Packer* packer) : columns(width, CompressedBytes(packer)) {}

  void add(const wire::Rows& rows) {
    for (std::size_t i = 0; i < columns.size(); ++i) columns[i].add(rows.bytes[i]);
    count += rows.count;
  }

  std::vector<CompressedBytes> columns;
  std::int64_t count = 0;
};

/// Follows rows that are stored in full, a little each time. All of them at once would take so long that the
/// run waits. The first column is t_ns.
class Thinner {
 public:
  /// `packer`: as in CompressedBytes.
  Thinner(const std::vector<wire::ColumnSpec>& specs, std::int64_t span_ns, Packer* packer);

  /// Takes at most `most_rows` next rows of `all`, without those that wait to be packed. Throws
  /// wire::BadValue, like the others, if the columns do not hold as many numbers as there are rows.
  void follow(const CompressedRows& all, std::size_t most_rows);
  /// Takes all remaining rows of `all`.
  void catch_up(const CompressedRows& all);
  /// Adds rows that come after those.
  void add(const std::vector<std::string>& bytes, std::int64_t count);
  /// Stores the last row, too.
  void finish();

  const CompressedRows& kept() const { return kept_; }

 private:
  /// For a column of `all`: unpacked, but unread data.
  struct Ahead {
    std::size_t pieces = 0;  ///< number of unpacked pieces
    std::string bytes;
    std::size_t numbers = 0;
  };
  static void unpack(Ahead& ahead, std::string_view bytes);
  /// Takes `count` numbers.
  static std::string take(Ahead& ahead, std::size_t count);
  /// Returns false if there are none.
  bool read_some(const CompressedRows& all, std::size_t most_rows);
  void keep_last();

  std::uint64_t span_ns_;
  std::vector<wire::ColumnSpec> specs_;
  std::vector<wire::ColumnReader> readers_;
  std::vector<Ahead> ahead_;
  std::int64_t read_ = 0;           ///< rows of `all`
  std::uint64_t begin_ns_ = 0;      ///< of the span of the last row
  std::vector<std::int64_t> last_;  ///< a row that is not stored yet
  bool has_last_ = false;
  wire::Stream few_;
  CompressedRows kept_;
};

}  // namespace robosim::record
