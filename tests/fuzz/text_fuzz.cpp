// Reads arbitrary bytes as TOML (checks.toml, a map's front matter), as a row of CSV, as an archive of
// several files (sim/base/archive.h), and as UTF-8.
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "sim/base/archive.h"
#include "sim/base/config.h"
#include "sim/base/csv.h"
#include "sim/base/utf8.h"
#include "tests/fuzz/require.h"

namespace {

using namespace robosim;

void look_at(const ConfigValue& value, int depth) {
  require(depth < 200, "values are nested less than 200 deep");
  require(value.place.file == "fuzz.toml" && value.place.line >= 1, "everything has its place");
  for (const ConfigValue& item : value.items) look_at(item, depth + 1);
  for (const auto& [key, member] : value.members) look_at(member, depth + 1);
}

void read_row(std::string_view text) {
  const auto fields = csv_fields(text);
  if (!fields) return;
  std::string row;
  for (const std::string& field : *fields)
    row += (row.empty() && &field == &fields->front() ? "" : ",") + csv_field(field);
  require(csv_fields(row) == fields, "a row that is written is read again");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    look_at(parse_toml(text, "fuzz.toml"), 0);
  } catch (const InputError& error) {
    require(error.place().file == "fuzz.toml", "errors name the file");
  }
  read_row(text);
  try {
    const std::string bundle = pack(unpack(text));
    require(pack(unpack(bundle)) == bundle, "a bundle that is packed is unpacked again");
  } catch (const InputError&) {
  }
  is_utf8(text);
  return 0;
}
