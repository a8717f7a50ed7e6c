#include "sim/cli/hunt/log.h"

#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>

#include "sim/base/file.h"

namespace robosim::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string line_of(const HuntRow& row) {
  Json json{{"run", row.run},
            {"time_s", row.time_s},
            {"reached", row.reached},
            {"traits", row.traits},
            {"heard", row.heard}};
  if (row.finding > 0) json["finding"] = row.finding;
  if (row.fresh) {
    const HuntFinding& f = *row.fresh;
    json["fresh"] = {{"kind", f.symptom.kind},
                     {"group", f.symptom.group},
                     {"sentence", f.symptom.sentence},
                     {"is_behaviour", f.symptom.is_behaviour},
                     {"needs", f.needs},
                     {"time_s", f.time_s},
                     {"run", f.run},
                     {"text", f.text},
                     {"check", f.check}};
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

HuntRow row_of(const Json& json) {
  HuntRow row{
      json.at("run"), json.at("time_s"), json.at("reached"), json.at("traits"), json.at("heard"), 0, {}};
  if (json.contains("finding")) row.finding = json.at("finding");
  if (json.contains("fresh")) {
    const Json& f = json.at("fresh");
    HuntFinding& fresh = row.fresh.emplace();
    fresh.symptom = {f.at("kind"), f.at("group"), f.at("sentence"), f.at("is_behaviour")};
    fresh.needs = f.at("needs").get<std::set<std::string>>();
    fresh.time_s = f.at("time_s");
    fresh.run = f.at("run");
    fresh.text = f.at("text");
    fresh.check = f.at("check");
  }
  return row;
}

}  // namespace

HuntLog::HuntLog(const std::filesystem::path& folder, const std::string& from, bool resume)
    : path_(folder / "runs.jsonl"), claim_(path_) {
  std::string kept = Json{{"schema", "robosim.hunt/1"}, {"from", from}}.dump() + "\n";
  if (resume) {
    const std::string text = read_file(path_);
    if (!text.starts_with(kept))
      throw InputError(
          {path_.string(), 1, 0},
          "is of another hunt: the sketch, an option or Robosim has changed since; without --resume, "
          "--out DIR begins a new one");
    int number = 1;
    for (std::size_t at = kept.size(), end; (end = text.find('\n', at)) != std::string::npos; at = end + 1) {
      ++number;
      try {
        HuntRow row = row_of(Json::parse(text.substr(at, end - at)));
        rows_[row.run] = std::move(row);
      } catch (const nlohmann::json::exception&) {
        throw InputError({path_.string(), number, 0}, "is no line that a hunt has written");
      }
      kept += text.substr(at, end + 1 - at);
    }
  }
  write_file(path_, kept);
  file_.reset(std::fopen(path_.c_str(), "a"));
  if (!file_) throw InputError({path_.string()}, std::strerror(errno));
}

const HuntRow* HuntLog::row(std::uint64_t run) const {
  const auto found = rows_.find(run);
  return found == rows_.end() ? nullptr : &found->second;
}

void HuntLog::add(const HuntRow& row) { put(line_of(row)); }

void HuntLog::put(const std::string& line) {
  if (std::fwrite(line.data(), 1, line.size(), file_.get()) != line.size() || std::fflush(file_.get()) != 0)
    throw InputError({path_.string()}, std::strerror(errno));
}

}  // namespace robosim::cli
