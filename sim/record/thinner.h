// Thins the rows of a run with too many changes: stores only the last row in each span of time.
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

/// Thins rows a little at a time, while the rows are also stored in full. Thinning all rows at once would
/// make the run wait. The first column is t_ns.
class Thinner {
 public:
  /// `packer` compresses the thinned rows; null = they are stored unchanged.
  Thinner(const std::vector<wire::ColumnSpec>& specs, std::int64_t span_ns, Packer* packer);

  /// Thins at most `most_rows` further rows of `all`. Ignores rows that are not packed yet. Throws
  /// wire::BadValue if the columns do not contain as many numbers as there are rows. The next two functions
  /// throw the same error.
  void follow(const CompressedRows& all, std::size_t most_rows);
  /// Thins all remaining rows of `all`.
  void catch_up(const CompressedRows& all);
  /// Thins rows that follow those of `all`.
  void add(const std::vector<std::string>& bytes, std::int64_t count);
  /// Stores the last row.
  void finish();

  const CompressedRows& kept() const { return kept_; }

 private:
  /// Unpacked but unread data of a column of `all`.
  struct Ahead {
    std::size_t pieces = 0;  ///< number of unpacked pieces
    std::string bytes;
    std::size_t numbers = 0;
  };
  static void unpack(Ahead& ahead, std::string_view bytes);
  /// Removes and returns `count` numbers.
  static std::string take(Ahead& ahead, std::size_t count);
  /// Reads some rows. Returns false at the end.
  bool read_some(const CompressedRows& all, std::size_t most_rows);
  void keep_last();

  std::uint64_t span_ns_;
  std::vector<wire::ColumnSpec> specs_;
  std::vector<wire::ColumnReader> readers_;
  std::vector<Ahead> ahead_;
  std::int64_t read_ = 0;           ///< number of rows read from `all`
  std::uint64_t begin_ns_ = 0;      ///< start of the last row's span
  std::vector<std::int64_t> last_;  ///< the last row, which is not stored yet
  bool has_last_ = false;
  wire::Stream few_;
  CompressedRows kept_;
};

}  // namespace robosim::record
