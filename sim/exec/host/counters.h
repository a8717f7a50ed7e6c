// Collects the files for gcov (.gcda) from an image that counts how often its lines run.
#pragma once

#include <utility>
#include <vector>

#include "hal/host/image.h"
#include "sim/exec/core/executor.h"

namespace robosim::exec {

class Counters final : public host::CounterSink {
 public:
  explicit Counters(std::vector<ArchivedFile> files) : files_(std::move(files)) {}
  void begin(const char* file) override { files_.push_back({file, ""}); }
  void add(const void* bytes, std::size_t count) override {
    files_.back().content.append(static_cast<const char*>(bytes), count);
  }
  const std::vector<ArchivedFile>& files() const { return files_; }

 private:
  std::vector<ArchivedFile> files_;
};

}  // namespace robosim::exec
