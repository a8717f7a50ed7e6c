#include "sim/campaign/calibrate/stopwatch.h"

#include "sim/base/config.h"
#include "sim/base/error.h"
#include "sim/base/file.h"

namespace robosim::calibrate {

Stopwatch read_stopwatch(const std::string& file) {
  const ConfigValue tree = parse_toml(read_file(file), file);
  Stopwatch watch;
  TableReader reader(tree, "the file");
  if (const ConfigValue* supply = reader.find("supply"))
    watch.supply_volts = as_quantity(*supply, "supply", Dimension::voltage, 1.0, 30.0);
  const ConfigValue* drives = reader.find("drive");
  reader.finish();
  if (!drives || drives->kind != ConfigValue::Kind::array || drives->items.empty())
    throw InputError({file},
                     "[[drive]] is missing: expected a table with pwm, time and distance for each drive");
  for (const ConfigValue& item : drives->items) {
    TableReader drive(item, "[[drive]]");
    Timed timed{file, item.place.line};
    timed.told = static_cast<int>(as_integer(drive.require("pwm"), "pwm", 1, 255));
    timed.seconds = as_quantity(drive.require("time"), "time", Dimension::time, 0.05, 60.0);
    timed.distance = as_quantity(drive.require("distance"), "distance", Dimension::length, 0.02, 30.0);
    timed.sd = drive.quantity("measured", Dimension::length, 0.01, 0.0005, 1.0);
    drive.finish();
    watch.drives.push_back(timed);
  }
  return watch;
}

}  // namespace robosim::calibrate
