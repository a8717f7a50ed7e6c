// Parses the form of a requested run (job_manager.h).
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "sim/base/error.h"
#include "sim/launch/fleet.h"
#include "sim/view/serve/job_manager.h"
#include "sim/wire/json_parse.h"
#include "sim/wire/run_request.h"

namespace robosim::serve {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kLongestScript = 64 * 1024;
constexpr std::size_t kLongestGoal = 100;
constexpr double kLongestRun_s = 3600.0;

std::string text(const Json& json, const char* key, const std::string& usual, std::size_t longest) {
  if (!json.contains(key)) return usual;
  if (!json[key].is_string() || json[key].get_ref<const std::string&>().size() > longest)
    throw InputError(fmt::format("{}: expected a text of at most {} characters", key, longest));
  return json[key];
}

double number(const Json& json, const char* key, double usual, double least, double most) {
  if (!json.contains(key)) return usual;
  if (!json[key].is_number() || !(json[key] >= least && json[key] <= most))
    throw InputError(fmt::format("{}: expected a number from {} to {}", key, least, most));
  return json[key];
}

std::string one_in(const Json& json, const char* key, const std::vector<std::string>& choices, bool needed) {
  const std::string name = text(json, key, "", 1000);
  if (name.empty() && !needed) return name;
  if (std::find(choices.begin(), choices.end(), name) == choices.end())
    throw InputError(
        fmt::format("{0}: expected a {0} of the served folder or one that comes with Robosim", key));
  return name;
}

std::map<std::string, std::string> scripts_in(const Json& json) {
  if (!json.is_object() || json.size() > result::kMostAgents)
    throw InputError(fmt::format("scripts: expected an object of at most {} texts, by the robots' names",
                                 result::kMostAgents));
  std::map<std::string, std::string> scripts;
  std::size_t size = 0;
  for (const auto& [name, script] : json.items()) {
    launch::check_member_name(name, {"scripts"});
    scripts[name] = text(json, name.c_str(), "", kLongestScript);
    size += scripts[name].size();
  }
  if (size > kLongestScript)
    throw InputError(fmt::format("scripts: expected at most {} characters together", kLongestScript));
  return scripts;
}

}  // namespace

RunForm read_run_form(const std::string& text_of_it, const Choices& choices) {
  const Json json = wire::parsed_json(text_of_it);
  if (!json.is_object()) throw InputError("the request: expected a JSON object");
  for (const auto& item : json.items()) {
    const char* const known[] = {"sketch", "robot", "map",    "target", "seed",
                                 "for_s",  "goal",  "script", "scripts"};
    if (std::find(std::begin(known), std::end(known), item.key()) == std::end(known))
      throw InputError("unknown key in the request: expected " + one_of(known));
  }
  RunForm form;
  form.sketch = one_in(json, "sketch", choices.sketches, true);
  form.robot = one_in(json, "robot", choices.robots, false);
  form.map = one_in(json, "map", choices.maps, false);
  form.target = text(json, "target", form.target, 10);
  if (form.target != "host" && form.target != "avr" && form.target != "stm32")
    throw InputError("target: expected host, avr or stm32");
  form.seed = static_cast<std::uint64_t>(number(json, "seed", 1.0, 0.0, 9e15));
  form.for_s = number(json, "for_s", form.for_s, 0.001, kLongestRun_s);
  form.goal = text(json, "goal", "", kLongestGoal);
  if (form.goal.starts_with("-")) throw InputError("goal: expected the name of a goal, such as laps:3");
  form.script = text(json, "script", "", kLongestScript);
  if (json.contains("scripts")) form.scripts = scripts_in(json["scripts"]);
  if (!form.scripts.empty() && !launch::is_fleet_file(form.sketch))
    throw InputError("scripts: expected a file of several robots as the sketch, got one sketch");
  return form;
}

}  // namespace robosim::serve
