// Writes pictures of a run as .png: renders the pictures of record_svg.h with the program rsvg-convert
// (Debian package librsvg2-bin).
#pragma once

#include <string>

#include "sim/record/record_svg.h"

namespace robosim::record {

class PngRecorder final : public SvgRecorder {
 public:
  /// Throws ToolMissing if rsvg-convert is not installed.
  explicit PngRecorder(std::filesystem::path path);

 protected:
  std::string content(const std::string& svg) const override;

 private:
  std::string name_;
};

}  // namespace robosim::record
