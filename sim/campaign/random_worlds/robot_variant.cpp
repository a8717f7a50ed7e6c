#include "sim/campaign/random_worlds/robot_variant.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <utility>

#include "sim/base/config.h"

namespace robosim::random_worlds {
namespace {

struct Amount {
  double number = 0.0;
  std::string unit;
};

std::optional<Amount> amount(const ConfigValue& value) {
  if (value.kind == ConfigValue::Kind::integer || value.kind == ConfigValue::Kind::number)
    return Amount{value.number, ""};
  if (value.kind != ConfigValue::Kind::string) return {};
  char* end = nullptr;
  Amount found{std::strtod(value.string.c_str(), &end), ""};
  if (end == value.string.c_str()) return {};
  found.unit = end;
  found.unit.erase(0, found.unit.find_first_not_of(' '));
  return found;
}

void add_figures(const ConfigValue& table, const std::string& name, std::vector<Figure>& figures) {
  for (const auto& [key, value] : table.members) {
    const ConfigValue* const middle = value.find("value");
    const ConfigValue* const spread = value.find("spread");
    const auto is = middle ? amount(*middle) : std::nullopt;
    auto by = spread ? amount(*spread) : std::nullopt;
    if (!is || !by) continue;
    if (by->unit == "%") by = Amount{by->number / 100.0 * is->number, is->unit};
    if (by->unit == is->unit) figures.push_back({name, key, is->number, by->number, is->unit});
  }
}

void add_places(const ConfigValue& part, const std::string& name, double mounting_mm,
                std::vector<Figure>& figures) {
  const ConfigValue* const at = part.find("at");
  const ConfigValue* const type = part.find("type");
  if (!at || at->items.size() != 2 || !type || type->string.find("reflectance") != 0) return;
  std::vector<Figure> both;
  for (int i = 0; i < 2; ++i) {
    const auto is = amount(at->items[static_cast<std::size_t>(i)]);
    if (!is || is->unit != "mm") return;
    both.push_back({name, fmt::format("at {}", i), is->number, mounting_mm, "mm"});
  }
  figures.insert(figures.end(), both.begin(), both.end());
}

std::string text_of(double number, const std::string& unit) {
  return unit.empty() ? fmt::format("{:.5g}", number) : fmt::format("\"{:.5g} {}\"", number, unit);
}

}  // namespace

std::vector<Figure> figures_of(std::string_view robot_file, const std::string& name, double mounting_mm) {
  std::vector<Figure> figures;
  const ConfigValue robot = parse_toml(robot_file, name);
  for (const auto& [key, value] : robot.members) {
    if (key != "part") {
      if (value.kind == ConfigValue::Kind::table) add_figures(value, key, figures);
      continue;
    }
    for (const ConfigValue& part : value.items) {
      const ConfigValue* const called = part.find("name");
      if (!called) continue;
      add_figures(part, "part " + called->string, figures);
      if (mounting_mm > 0.0) add_places(part, "part " + called->string, mounting_mm, figures);
    }
  }
  return figures;
}

std::vector<RobotVariant> RobotVariant::smaller() const {
  std::vector<RobotVariant> found;
  const auto is_other = [](int level) { return level != 0; };
  if (std::count_if(levels.begin(), levels.end(), is_other) > 1)
    found.push_back({std::vector<int>(levels.size(), 0)});
  // Resets blocks of parameters to the file's values: all, each half, each quarter, … each single parameter.
  for (std::size_t width = levels.size(); width > 0; width /= 2) {
    for (std::size_t from = 0; from < levels.size(); from += width) {
      RobotVariant less = *this;
      const auto begin = less.levels.begin() + static_cast<std::ptrdiff_t>(from);
      const auto end =
          less.levels.begin() + static_cast<std::ptrdiff_t>(std::min(from + width, levels.size()));
      if (std::none_of(begin, end, is_other)) continue;
      std::fill(begin, end, 0);
      found.push_back(less);
    }
  }
  for (std::size_t i = 0; i < levels.size(); ++i) {
    if (std::abs(levels[i]) < 2) continue;
    found.push_back(*this);
    found.back().levels[i] /= 2;
  }
  return found;
}

std::string RobotVariant::file(const std::string& base, const std::vector<Figure>& figures) const {
  std::string text = fmt::format("base = \"{}\"\n", base), table;
  const auto value = [&](std::size_t i) {
    return text_of(figures[i].value + figures[i].spread * levels[i] / kLevels, figures[i].unit);
  };
  bool same = true;
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const Figure& figure = figures[i];
    const bool is_place = figure.key == "at 0";
    if (levels[i] == 0 && !(is_place && levels[i + 1] != 0)) continue;
    same = false;
    if (figure.table != table) {
      table = figure.table;
      const bool is_part = table.find("part ") == 0;
      text +=
          is_part ? fmt::format("[[part]]\nname = \"{}\"\n", table.substr(5)) : fmt::format("[{}]\n", table);
    }
    if (is_place) {
      text += fmt::format("at = [{}, {}]\n", value(i), value(i + 1));
      ++i;
    } else {
      text += fmt::format("{} = {}\n", figure.key, value(i));
    }
  }
  return same ? base : text;
}

RobotVariant assemble(const std::vector<Figure>& figures, const RandomSource& rng) {
  RobotVariant variant;
  for (std::size_t i = 0; i < figures.size(); ++i)
    variant.levels.push_back(rng(2 * RobotVariant::kLevels + 1) - RobotVariant::kLevels);
  return variant;
}

}  // namespace robosim::random_worlds
