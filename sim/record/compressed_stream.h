// Stores a stream of a run (rows as columns, sim/wire/columns.h) as it arrives. Thins a stream that is too
// large.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/record/recording_header.h"
#include "sim/record/thinner.h"

namespace robosim::record {

class CompressedStream {
 public:
  /// `packer` compresses the rows (null: they are stored unchanged), and must outlive this object.
  explicit CompressedStream(Packer* packer = nullptr) : packer_(packer), all_(0, packer) {}

  /// Adds rows. Throws wire::BadValue if the rows do not match the earlier ones.
  void add(const wire::Rows& rows);
  /// Begins the work of thin() in advance. Each added row continues this work a little, so that thin() is
  /// fast.
  void prepare_to_thin(std::int64_t span_ns);
  /// Reduces all present and later rows to the last row in each span. The first column must be t_ns.
  void thin(std::int64_t span_ns);
  /// Returns the unpacked size.
  std::size_t bytes() const;
  const std::vector<wire::ColumnSpec>& specs() const { return specs_; }
  /// Returns the stream's entry for the header, and appends the columns' bytes to `body`.
  StreamInfo finish(const std::string& name, std::vector<const CompressedBytes*>& body);

 private:
  const CompressedRows& kept() const { return is_thin_ ? thinner_->kept() : all_; }

  Packer* packer_;
  std::vector<wire::ColumnSpec> specs_;
  CompressedRows all_;
  std::optional<Thinner> thinner_;
  bool is_thin_ = false;
};

}  // namespace robosim::record
