// Writes pictures of a run as .svg: the robot's path on the floor, its speed along the path, and the end of
// the path. The pictures are suitable for papers and READMEs, because equal runs give equal bytes.
#pragma once

#include <string>
#include <vector>

#include "sim/record/floor_shapes.h"
#include "sim/record/recorder.h"
#include "sim/wire/hand.h"

namespace robosim::record {

/// Returns a floor as elements of an SVG: unit mm, x east, y down from the map's top edge.
std::string floor_elements(const FloorShapes& floor);

class SvgRecorder : public Recorder {
 public:
  explicit SvgRecorder(std::filesystem::path path) : path_(std::move(path)) {}
  void ask(wire::RunRequest& request) const override;
  void begin(const RecordedRun& run) override;
  void add(const wire::Event& event) override;
  void finish(const result::RunResult& result) override;

  /// The part of a sample that is drawn.
  struct Point {
    double x_mm = 0.0, y_mm = 0.0, speed_mm_s = 0.0;
    bool carried = false;  ///< a manual move brought the robot here
  };

 protected:
  /// Returns the content of the file.
  virtual std::string content(const std::string& svg) const { return svg; }

 private:
  struct Words {
    std::string title, first, second;
  };
  Words words_of_one(const result::RunResult& result) const;
  Words words_of_several(const result::RunResult& result) const;

  std::filesystem::path path_;
  RecordedRun run_;
  wire::Started started_;
  /// The path of one robot.
  struct Drive {
    wire::Hand hand;
    std::vector<Point> trail;
  };
  std::vector<Drive> drives_{1};
  std::vector<Point> collisions_;
};

}  // namespace robosim::record
