// A stream of a run's columns (sim/wire/columns.h) as it comes in; thinned, if all of it would be too much.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/record/kept_bytes.h"
#include "sim/record/recording_header.h"
#include "sim/wire/columns.h"

namespace robosim::record {

class KeptStream {
 public:
  /// `packer`: as KeptBytes has it; must live as long as this.
  explicit KeptStream(Packer* packer = nullptr) : packer_(packer) {}

  /// Throws wire::BadValue if they do not fit those before.
  void add(const wire::Rows& rows);
  /// From now on, and of what is there, only the last row in each span is kept. The first column is t_ns.
  void thin(std::int64_t span_ns);
  /// Unpacked.
  std::size_t bytes() const;
  const std::vector<wire::ColumnSpec>& specs() const { return specs_; }
  /// What the header says of it; its columns' bytes are added to `body`.
  StreamInfo finish(const std::string& name, std::vector<const KeptBytes*>& body);

 private:
  struct Thinned {
    std::int64_t span_ns;
    std::vector<wire::ColumnReader> readers;
    wire::Stream few;
    std::vector<double> pending;
  };
  void keep(const wire::Rows& rows);
  void add_thinned(const std::vector<std::string>& bytes, std::int64_t count);

  Packer* packer_;
  std::vector<wire::ColumnSpec> specs_;
  std::vector<KeptBytes> columns_;
  std::int64_t count_ = 0;
  std::optional<Thinned> thinned_;
};

}  // namespace robosim::record
