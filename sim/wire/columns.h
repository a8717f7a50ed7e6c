// Stores a run's numbers in compact columns. Writing every pin change and a sample every 10 ms as JSON lines
// would take several times as long as the run.
//
// A column contains integers (value x scale, rounded). The column stores the difference of each integer from
// an expected value; a small difference takes one byte:
//
//   order 1   expects the previous value      (constant values, or jumps)
//   order 2   expects a steady change         (times, positions)
//
// A difference `d` is written as the integer `2 d` if `d >= 0`, and as `-2 d - 1` otherwise. Its bits are
// stored in groups of seven, the lowest bits first. Each group is a byte. In all bytes except the last, the
// highest bit is set.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/result/fields.h"
#include "sim/result/run_result.h"

namespace robosim::wire {
using namespace result;  // the values that messages carry

/// The encoding of a column's numbers.
struct ColumnSpec {
  std::string name;
  double scale = 1.0;  ///< steps in one unit: 100 = hundredths
  int order = 1;       ///< 1 or 2, as described above
};

template <class V>
void fields(V& v, Same<V, ColumnSpec>& c) {
  v("name", c.name, "name of the column, with its unit");
  v("scale", c.scale, "stored integer = value x scale");
  v("order", c.order, "1: differences between neighbours; 2: differences between those differences");
}

/// The rows that were added to one stream since the stream's previous Rows message.
struct Rows {
  std::string stream;               ///< "samples", "pin D5", "volts A0"
  std::int64_t count = 0;           ///< number of rows
  std::vector<ColumnSpec> columns;  ///< only with the first rows of a stream
  std::vector<std::string> bytes;   ///< one string per column; base64 in a line of JSON
};

template <class V>
void fields(V& v, Same<V, Rows>& r) {
  v("stream", r.stream, "name of the stream: `\"samples\"`, `\"pin D5\"`, `\"volts A0\"`");
  v("count", r.count, "number of rows", {.least = 0});
  v("columns", r.columns, "encodings of the columns; only with the first rows of a stream",
    {.presence = when(!r.columns.empty())});
  v("bytes", r.bytes, "new bytes of each column in base64, which continue its previous bytes");
}

/// The rows and sources that were added since the previous Columns event.
struct Columns {
  static constexpr const char* kEvent = "columns";
  std::vector<Rows> streams;
  int agent = 0;
  std::vector<SourceLine> sources{};  ///< lines of the sketch that appear here for the first time
};

template <class V>
void fields(V& v, Same<V, Columns>& c) {
  agent_field(v, c.agent);
  v("streams", c.streams, "streams with new rows");
  v("sources", c.sources,
    "on a chip: lines of the sketch that drive pins, and that a column `source` names for the first time. "
    "The lines are numbered from 1 over all `columns` of the run",
    {.presence = when(!c.sources.empty())});
}

/// The largest stored integer (value x scale). Larger integers are clamped. JavaScript's numbers are exact up
/// to this limit.
constexpr std::int64_t kMostSteps = std::int64_t{1} << 50;

/// Writes a column.
class Column {
 public:
  explicit Column(ColumnSpec spec) : spec_(std::move(spec)) {}

  const ColumnSpec& spec() const { return spec_; }
  std::string_view bytes() const { return {buffer_.data(), used_}; }
  /// Clears the bytes, but not the last number.
  void clear() { used_ = 0; }
  /// Adds `count` values. The first value is at `first`, and each further value is `step` doubles later.
  void add(const double* first, std::size_t step, std::size_t count);

 private:
  template <bool kIsSecond>
  void pack(const double* first, std::size_t step, std::size_t count);

  ColumnSpec spec_;
  std::vector<char> buffer_;
  std::size_t used_ = 0;  ///< used bytes of buffer_
  std::int64_t last_ = 0, change_ = 0;
};

/// Reads a column, piece by piece.
class ColumnReader {
 public:
  explicit ColumnReader(int order) : order_(order) {}
  /// Returns the next `count` integers. Returns nullopt if the bytes do not contain exactly `count` integers.
  std::optional<std::vector<std::int64_t>> read(std::string_view bytes, std::size_t count);

 private:
  int order_;
  std::uint64_t last_ = 0, change_ = 0;
};

/// Writes rows. Rows wait until their bytes are requested. Packing column by column takes a third of the
/// time of packing row by row.
class Stream {
 public:
  Stream(std::string name, const std::vector<ColumnSpec>& columns);
  const std::string& name() const { return name_; }
  std::size_t width() const { return columns_.size(); }
  std::vector<Column>& columns();
  std::int64_t count() const { return count_; }
  /// Adds a row, which the caller fills: one value for each column.
  double* add() {
    const std::size_t begin = waiting_;
    waiting_ += columns_.size();
    if (rows_.size() < waiting_) rows_.resize(2 * rows_.size() + 16 * columns_.size());
    ++count_;
    return rows_.data() + begin;
  }
  void add(const double* row) { std::copy(row, row + columns_.size(), add()); }
  /// Returns the rows since the last call.
  Rows take();

 private:
  std::string name_;
  std::vector<Column> columns_;
  std::vector<double> rows_;  ///< waiting rows, concatenated
  std::size_t waiting_ = 0;   ///< number of waiting values
  std::int64_t count_ = 0;
  bool told_ = false;
};

}  // namespace robosim::wire
