// A column of numbers in few bytes: whole numbers (value x scale, rounded), of which the differences from
// what was to be expected are kept, small ones in one byte. What is left is compressed with everything else.
//
//   order 1: expected is the value before       (what stays, or jumps)
//   order 2: expected is a steady change         (times, places)
//
// A difference d is written as z = 2 d or -2 d - 1, in groups of seven bits, the lowest first; a group that
// is not the last has its highest bit set.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace robosim::record {

/// How a column's numbers are kept.
struct ColumnSpec {
  std::string name;
  double scale = 1.0;  ///< steps in one unit: 100 = hundredths
  int order = 1;       ///< 1 or 2
};

class Column {
 public:
  explicit Column(ColumnSpec spec) : spec_(std::move(spec)) {}

  const ColumnSpec& spec() const { return spec_; }
  const std::string& bytes() const { return bytes_; }

  void add(double value) { add_steps(steps(value)); }
  /// The value times the scale.
  void add_steps(std::int64_t value);

 private:
  std::int64_t steps(double value) const;

  ColumnSpec spec_;
  std::string bytes_;
  std::int64_t last_ = 0, change_ = 0;
};

/// The largest value times scale that a column holds; more becomes this. JavaScript's numbers are exact so
/// far.
constexpr std::int64_t kMostSteps = std::int64_t{1} << 50;

/// Reads `count` numbers. Throws InputError with `what` if the bytes are not as many.
std::vector<std::int64_t> read_column(std::string_view bytes, std::size_t count, int order,
                                      const std::string& what);

}  // namespace robosim::record
