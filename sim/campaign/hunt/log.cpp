#include "sim/campaign/hunt/log.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string_view>

#include "sim/base/file.h"
#include "sim/base/json_limits.h"

namespace robosim::campaign {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kFile = "runs.jsonl";

std::string line_of(const HuntRow& row) {
  Json json{{"run", row.run},           {"time_s", row.time_s}, {"reached", row.reached},
            {"has_goal", row.has_goal}, {"traits", row.traits}, {"heard", row.heard}};
  if (!row.missed.empty()) json["missed"] = row.missed;
  if (row.moment.at_ms >= 0) json["at_ms"] = row.moment.at_ms;
  if (!row.moment.after.empty()) json["after"] = row.moment.after;
  if (row.finding > 0) json["finding"] = row.finding;
  if (row.fresh) {
    const HuntFinding& f = *row.fresh;
    Json options = Json::array();
    for (const Shown::Option& option : f.shown.options)
      options.push_back({{"name", option.name}, {"value", option.value}, {"own_file", option.own_file}});
    json["fresh"] = {{"kind", f.symptom.kind},
                     {"group", f.symptom.group},
                     {"sentence", f.symptom.sentence},
                     {"is_behaviour", f.symptom.is_behaviour},
                     {"needs", f.needs},
                     {"time_s", f.time_s},
                     {"where", f.shown.where},
                     {"sketch", f.shown.sketch},
                     {"options", options},
                     {"checked", f.shown.checked},
                     {"detected", f.shown.detected},
                     {"compared", f.shown.compared}};
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

HuntRow row_of(const Json& json) {
  HuntRow row{
      json.at("run"), json.at("time_s"), json.at("reached"), json.at("traits"), {}, json.at("heard"), 0, {}};
  row.moment = {json.value("at_ms", -1), json.value("after", "")};
  row.has_goal = json.value("has_goal", false);
  row.missed = json.value("missed", std::string());
  if (json.contains("finding")) row.finding = json.at("finding");
  if (json.contains("fresh")) {
    const Json& f = json.at("fresh");
    HuntFinding& fresh = row.fresh.emplace();
    fresh.symptom = {f.at("kind"), f.at("group"), f.at("sentence"), f.at("is_behaviour")};
    fresh.needs = f.at("needs").get<std::set<std::string>>();
    fresh.time_s = f.at("time_s");
    fresh.shown = {f.at("where"), f.at("sketch"), {}, f.at("checked"), f.at("detected"), f.at("compared")};
    for (const Json& option : f.at("options"))
      fresh.shown.options.push_back({option.at("name"), option.at("value"), option.at("own_file")});
  }
  return row;
}

const std::string kOfAnother = "belongs to another hunt: the sketch, an option or Robosim has changed since";

std::string header(const std::string& from, const std::string& part) {
  Json json{{"schema", "robosim.hunt/3"}, {"from", from}};
  if (!part.empty()) json["part"] = part;
  return json.dump() + "\n";
}

/// Parses a line. If it is not JSON, returns a value of the type `discarded`.
Json parsed(std::string_view line) {
  return is_within_json_limits(line) ? Json::parse(line, nullptr, false) : Json(Json::value_t::discarded);
}

/// Returns the rows of complete lines.
std::vector<HuntRow> rows_in(const std::string& text, const std::string& file) {
  std::vector<HuntRow> rows;
  int number = 1;
  for (std::size_t at = text.find('\n') + 1, end; (end = text.find('\n', at)) != std::string::npos;
       at = end + 1) {
    ++number;
    try {
      rows.push_back(row_of(parsed(std::string_view(text).substr(at, end - at))));
    } catch (const nlohmann::json::exception&) {
      throw InputError({file, number, 0}, "expected a line that a hunt has written");
    }
  }
  return rows;
}

Shard shard_in(const std::string& first_line, const std::string& from, const std::string& file) {
  const Json json = parsed(first_line);
  if (!json.is_object() || json.value("from", "") != from) throw InputError({file, 1, 0}, kOfAnother);
  const std::string part = json.value("part", "1/1");
  if (part == kMerged) throw InputError({file, 1, 0}, "is already merged; give the folders of the shards");
  return read_shard(part);
}

}  // namespace

std::vector<HuntPart> read_parts(const std::vector<std::string>& folders, const std::string& from) {
  std::vector<HuntPart> parts;
  for (const std::string& folder : folders) {
    const std::string file = (std::filesystem::path(folder) / kFile).string(), text = read_file(file);
    const Shard shard = shard_in(text.substr(0, text.find('\n')), from, file);
    for (const HuntPart& other : parts) {
      if (other.shard.count != shard.count || other.shard.index == shard.index)
        throw InputError({folder}, fmt::format("is shard {}, but {} is shard {}: expected parts of one hunt",
                                               shard.text(), other.folder.string(), other.shard.text()));
    }
    parts.push_back({folder, shard, rows_in(text, file)});
  }
  return parts;
}

HuntLog::HuntLog(const std::filesystem::path& folder, const std::string& from, const std::string& part,
                 bool resume)
    : file_(folder / kFile) {
  std::string kept = header(from, part);
  if (resume) {
    const std::string text = read_file(file_.path());
    if (!text.starts_with(kept))
      throw InputError({file_.path().string(), 1, 0},
                       kOfAnother + "; omit --resume and name a new folder with --out DIR");
    for (HuntRow& row : rows_in(text, file_.path().string())) rows_[row.run] = std::move(row);
    kept = text.substr(0, text.rfind('\n') + 1);  // drops an incomplete last line
  }
  file_.begin(kept);
}

const HuntRow* HuntLog::row(std::uint64_t run) const {
  const auto found = rows_.find(run);
  return found == rows_.end() ? nullptr : &found->second;
}

void HuntLog::add(const HuntRow& row) { file_.append(line_of(row)); }

}  // namespace robosim::campaign
