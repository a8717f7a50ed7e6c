// A stream of a run's columns (sim/wire/columns.h) as it comes in; thinned, if all of it would be too much.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/record/recording_header.h"
#include "sim/record/thinner.h"

namespace robosim::record {

class KeptStream {
 public:
  /// `packer`: as KeptBytes has it; must live as long as this.
  explicit KeptStream(Packer* packer = nullptr) : packer_(packer), all_(0, packer) {}

  /// Throws wire::BadValue if they do not fit those before.
  void add(const wire::Rows& rows);
  /// thin() may come: it has less to do then, as it begins now, a little with all rows that are added.
  void prepare_to_thin(std::int64_t span_ns);
  /// From now on, and of what is there, only the last row in each span is kept. The first column is t_ns.
  void thin(std::int64_t span_ns);
  /// Unpacked.
  std::size_t bytes() const;
  const std::vector<wire::ColumnSpec>& specs() const { return specs_; }
  /// What the header says of it; its columns' bytes are added to `body`.
  StreamInfo finish(const std::string& name, std::vector<const KeptBytes*>& body);

 private:
  const KeptRows& kept() const { return is_thin_ ? thinner_->kept() : all_; }

  Packer* packer_;
  std::vector<wire::ColumnSpec> specs_;
  KeptRows all_;
  std::optional<Thinner> thinner_;
  bool is_thin_ = false;
};

}  // namespace robosim::record
