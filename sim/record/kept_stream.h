// A stream of a run's columns (sim/wire/columns.h) as it comes in; thinned, if all of it would be too much.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/record/recording_header.h"
#include "sim/wire/columns.h"

namespace robosim::record {

class KeptStream {
 public:
  /// Throws wire::BadValue if they do not fit those before.
  void add(const wire::Rows& rows);
  /// From now on, and of what is there, only the last row in each span is kept. The first column is t_ns.
  void thin(std::int64_t span_ns);
  std::size_t bytes() const;
  /// A column in its unit; empty if there is none of that name, or its bytes are damaged.
  std::vector<double> column(const std::string& name) const;
  /// Adds its bytes to `body`.
  StreamInfo write(const std::string& name, std::string& body);

 private:
  struct Thinned {
    std::int64_t span_ns;
    std::vector<wire::ColumnReader> readers;
    wire::Stream few;
    std::vector<double> pending;
  };
  void add_thinned(const std::vector<std::string>& bytes, std::int64_t count);

  std::vector<wire::ColumnSpec> specs_;
  std::vector<std::string> bytes_;
  std::int64_t count_ = 0;
  std::optional<Thinned> thinned_;
};

}  // namespace robosim::record
