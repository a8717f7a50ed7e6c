// Implements the part of a session in which the robot moves from cell to cell: walks, a scan, drives.
#include <fmt/format.h>

#include <algorithm>

#include "sim/view/play/session.h"
#include "sim/view/terminal/graph_table.h"
#include "sim/view/terminal/text.h"

namespace robosim::play {
namespace {

constexpr int kScroll = 5;               // cells
constexpr std::size_t kMostListed = 40;  // junctions of a route

constexpr const char* kTurnLetters = " (R: the first way out to the right, L: the last, S: between them)";

// Formats the turns as directions on the map: "east at J1, north at J2".
std::string directions_text(const map::TrueGraph& graph, int from, const RouteReport& route) {
  std::string text;
  const map::Arm* arm = &graph.stations[static_cast<std::size_t>(from - 1)].arm;
  for (std::size_t i = 0; i < std::min(route.turns.size(), kMostListed); ++i) {
    if (arm->behind != map::Arm::Behind::junction) break;
    const auto& arms = graph.junctions[static_cast<std::size_t>(arm->id - 1)].arms;
    const std::size_t right_hand = route.turns[i] == 'R' ? 1 : route.turns[i] == 'L' ? arms.size() - 1 : 2;
    const map::Arm& out = arms[(static_cast<std::size_t>(arm->slot) + right_hand) % arms.size()];
    text += fmt::format("{}{} at J{}", i ? ", " : "", terminal::direction_word(out.out), arm->id);
    arm = &out;
  }
  return text;
}

std::string consumed(const WalkReport& report) {
  return fmt::format("Time consumed: {:.10g} s, {} moves.", report.time_s, report.moves);
}

// Returns "S1, S2 dock and S3", with as many stations as fit in a sentence.
std::string stations_text(const map::TrueGraph& graph) {
  constexpr int kListed = 30;
  const int count = static_cast<int>(graph.stations.size());
  std::string text;
  for (int n = 1; n <= std::min(count, kListed); ++n)
    text += (n == 1 ? "" : n == count ? " and " : ", ") + terminal::station_name(graph, n);
  return count > kListed ? fmt::format("{}, ... S{}", text, count) : text;
}

}  // namespace

Session::Next Session::on_cells() {
  driver_ = host_.cells(*map_, start_, speed_s_);
  if (algorithm_ == Algorithm::ai) return scan_and_drive();
  const bool is_left = algorithm_ == Algorithm::left;
  const auto report = watch(fmt::format("Map {}: keeping to the {}", map_->name, is_left ? "left" : "right"),
                            {}, [&](const OnStep& on_step) { return driver_->walk(algorithm_, on_step); });
  if (!report) return choose_next("The walk was broken off.", terminal::Ink::plain);
  return choose_next(consumed(*report) + ' ' + report->note, terminal::Ink::strong);
}

Session::Next Session::scan_and_drive() {
  const auto report = watch(fmt::format("Map {}: scanning", map_->name), {},
                            [&](const OnStep& on_step) { return driver_->scan(on_step); });
  if (!report)
    return choose_next("The scan was broken off: the robot knows no stations.", terminal::Ink::plain);
  const map::TrueGraph& graph = driver_->graph();
  show_graph((report->complete ? "Scan complete. " : "Scan not complete. ") + consumed(*report) +
             (report->note.empty() ? "" : ' ' + report->note));
  if (graph.stations.size() < 2) {
    const char* why = graph.stations.empty() ? "There is no station to drive to."
                                             : "There is only one station: nowhere to drive to.";
    return choose_next(why, terminal::Ink::plain);
  }
  if (driver_->here() == 0) driver_->put_back(1);
  std::string result;
  do {
    result = drive_to(choose_destination());
  } while (ask_whether_to_continue(result));
  return choose_next("The robot has done its drives.", terminal::Ink::plain);
}

void Session::show_graph(const std::string& result) {
  const map::TrueGraph& graph = driver_->graph();
  const std::vector<terminal::CellLabel> labels = terminal::graph_labels(graph);
  const std::vector<std::string> lines = graph_lines(graph, console_.size().columns - 1, console_.look());
  const auto list_rows = static_cast<int>(std::min<std::size_t>(lines.size(), 1000));
  const bool lines_too = !console_.is_live();  // without a live console, there is no key g
  std::size_t selected = 0;
  map::CellAt around = pose_.cell;
  bool wants_map = true;
  // Shows map and list together if both fit; otherwise alternately.
  for (;;) {
    const terminal::Press press = read(
        [&](terminal::Page& page) {
          page.text(result, terminal::Ink::strong);
          page.text(terminal::graph_summary(graph));
          page.blank();
          const bool both = lines_too || page.rows_left() >= map_->height + 1 + list_rows;
          const int map_rows = page.rows_left() - (both ? std::min(list_rows, page.rows_left() / 2) + 1 : 0);
          if (wants_map || both) draw_map_around(page, map_rows, around, labels);
          if (both) page.blank();
          if (!wants_map || both) page.list(lines, selected, page.rows_left(), false);
        },
        {{wants_map ? "g shows it as a list, arrows move the map, Enter goes on, q quits"
                    : "g shows it on the map, arrows up and down scroll, Enter goes on, q quits",
          terminal::Ink::faint}});
    switch (press.kind) {
      case terminal::Press::Kind::enter:
        return;
      case terminal::Press::Kind::up:
        if (wants_map) around.y = std::max(around.y - kScroll, 0);
        if (!wants_map && selected > 0) --selected;
        break;
      case terminal::Press::Kind::down:
        if (wants_map) around.y = std::min(around.y + kScroll, map_->height - 1);
        if (!wants_map && selected + 1 < lines.size()) ++selected;
        break;
      case terminal::Press::Kind::left:
        around.x = std::max(around.x - kScroll, 0);
        break;
      case terminal::Press::Kind::right:
        around.x = std::min(around.x + kScroll, map_->width - 1);
        break;
      case terminal::Press::Kind::character:
        if (press.character == 'q') throw SessionQuit{};
        if (press.character == 'g') wants_map = !wants_map;
        break;
      default:
        break;
    }
  }
}

int Session::choose_destination() {
  const map::TrueGraph& graph = driver_->graph();
  const std::vector<terminal::CellLabel> labels = terminal::graph_labels(graph);
  for (;;) {
    const std::string answer = ask(
        [&](terminal::Page& page) {
          page.line(fmt::format("Map {}: the robot is at {}", map_->name,
                                terminal::station_name(graph, driver_->here())),
                    terminal::Ink::strong);
          page.text(fmt::format("Stations: {}", stations_text(graph)));
          draw_map(page, page.rows_left(), labels);
        },
        "Destination (a number or a name; q quits):");
    const int station = terminal::find_station(graph, answer);
    if (station == 0) {
      refuse(fmt::format("There is no station “{}” that can be reached; there are {}.", answer,
                         stations_text(graph)));
    } else if (station == driver_->here()) {
      refuse(fmt::format("The robot is at {} already: choose another station.",
                         terminal::station_name(graph, station)));
    } else {
      return station;
    }
  }
}

std::string Session::drive_to(int station) {
  const map::TrueGraph& graph = driver_->graph();
  const std::vector<terminal::CellLabel> labels = terminal::graph_labels(graph);
  const int from = driver_->here();
  const std::string trip =
      fmt::format("{} to {}", terminal::station_name(graph, from), terminal::station_name(graph, station));
  const RouteReport route = driver_->route(station);
  if (!route.possible) return fmt::format("{}: {}", trip, route.why_not);

  std::string junctions, turns;
  const std::size_t count = route.junctions.size();
  for (std::size_t i = 0; i < std::min(count, kMostListed); ++i) {
    junctions += fmt::format("{}J{}", i ? ", " : "", route.junctions[i]);
    turns += fmt::format("{}{}", i ? ", " : "", route.turns[i]);
  }
  if (count > kMostListed) junctions += fmt::format(", ... ({} in all)", count);
  if (count > kMostListed) turns += ", ...";
  picture_->clear_trail();
  const auto body = [&](terminal::Page& page) {
    page.line(trip, terminal::Ink::strong);
    page.text("Junctions: " + (junctions.empty() ? "none" : junctions));
    page.text("Turns: " + (turns.empty() ? "none" : turns + kTurnLetters));
    if (!turns.empty()) page.text("On the map: " + directions_text(graph, from, route));
    page.text(fmt::format("Time: {:.10g} s", route.time_s));
    draw_map(page, page.rows_left(), labels);
  };
  ask(body, "Enter drives there:");

  const auto report = watch(fmt::format("Map {}: {}", map_->name, trip), labels,
                            [&](const OnStep& on_step) { return driver_->drive(station, on_step); });
  if (!report) {
    driver_->put_back(from);
    pose_ = driver_->pose();
    picture_->clear_trail();
    return fmt::format("The drive was broken off; the robot is put back to {}.",
                       terminal::station_name(graph, from));
  }
  if (report->complete)
    return fmt::format("Arrived at {}. {}", terminal::station_name(graph, station), consumed(*report));
  return fmt::format("It did not arrive at {}. {} {}", terminal::station_name(graph, station), report->note,
                     consumed(*report));
}

bool Session::ask_whether_to_continue(const std::string& result) {
  const std::vector<terminal::CellLabel> labels = terminal::graph_labels(driver_->graph());
  for (;;) {
    const std::string answer = ask(
        [&](terminal::Page& page) {
          page.text(result, terminal::Ink::strong);
          draw_map(page, page.rows_left(), labels);
        },
        "Continue to another station (y/n) [y]:");
    if (answer.empty() || answer == "y" || answer == "yes") return true;
    if (answer == "n" || answer == "no") return false;
    refuse(fmt::format("“{}” is neither: answer y to continue or n to stop.", answer));
  }
}

}  // namespace robosim::play
