#include "sim/campaign/calibrate/sweep_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <string>

#include "sim/base/did_you_mean.h"
#include "sim/base/error.h"
#include "sim/campaign/calibrate/edge_fit.h"
#include "sim/campaign/calibrate/tape_crossings.h"

namespace robosim::calibrate {
namespace {

using robot::ReflectanceSpec;

constexpr double kPatch = 0.012;                       // in metres: readings within this length count as one
constexpr double kMostChange = 0.25;                   // maximum change of levels, share of black - white
constexpr double kClock = 4e-6 * std::numbers::sqrt2;  // s, error of a duration by micros() on a 16 MHz chip
constexpr std::size_t kBatches = 10;
constexpr std::size_t kMostEdges = 1500;  // limit for a part; more edges do not improve the result
constexpr double kMostClipped =
    0.005;  // with more than this share of clipped readings, the median replaces the biased mean

/// An element with all of its sweeps.
struct Element {
  ElementFit fit;
  std::vector<Trace> traces;
  std::vector<std::vector<Crossing>> crossings;
  Levels rough;
};

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

double deviation(const std::vector<double>& values) {
  const double middle = mean(values);
  double sum = 0.0;
  for (const double value : values) sum += (value - middle) * (value - middle);
  return std::sqrt(sum / std::max(static_cast<double>(values.size()) - 1.0, 1.0));
}

/// Returns the uncertainty of a mean of few values, by Student's distribution (95 %).
double mean_sd(const std::vector<double>& values) {
  constexpr double kFew[] = {6.4, 2.2, 1.6, 1.4, 1.3, 1.2, 1.2, 1.15};  // for 2, 3, … values
  const std::size_t n = values.size();
  if (n < 2) return values.front();
  return deviation(values) / std::sqrt(static_cast<double>(n)) *
         (n - 2 < std::size(kFew) ? kFew[n - 2] : 1.1);
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<long>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Returns the standard deviation of single readings, computed from second differences.
double noise_of(const std::vector<double>& differences, double step) {
  if (differences.size() < 10) return 0.0;
  double sum = 0.0;
  for (const double d : differences) sum += d * d;
  const double variance = sum / (6.0 * static_cast<double>(differences.size())) - step * step / 12.0;
  return std::sqrt(std::max(variance, 0.0));
}

/// Returns the index of the first sample at or after `time`.
std::size_t index_at(const std::vector<double>& t, double time) {
  return static_cast<std::size_t>(std::lower_bound(t.begin(), t.end(), time) - t.begin());
}

/// Measures levels and noise of one element, well inside and well outside the tape.
void measure_levels(Element& element) {
  std::vector<double> white, black, rough_white, rough_black;
  double length = 0.0, radius = 0.0;
  std::set<std::string> logs;  // each log comes from a different place on the floor
  std::size_t clipped = 0;
  for (std::size_t k = 0; k < element.traces.size(); ++k) {
    const Trace& trace = element.traces[k];
    const std::vector<double>& t = trace.sweep->t;
    const std::vector<Crossing>& crossings = element.crossings[k];
    std::vector<signed char> where(t.size(), 1);  // 1 white, -1 black, 0 neither
    for (std::size_t i = 0; i < t.size(); ++i) {
      if (std::fabs(trace.y[i] - element.rough.white) >
          0.5 * std::fabs(element.rough.black - element.rough.white))
        where[i] = 0;
    }
    for (const Crossing& c : crossings) {
      const double duration = c.leaves - c.enters, middle = 0.5 * (c.leaves + c.enters);
      for (std::size_t i = index_at(t, middle - duration); i < t.size() && t[i] < middle + duration; ++i)
        where[i] = std::fabs(t[i] - middle) < 0.15 * duration ? -1 : 0;
    }
    for (std::size_t i = 0; i < t.size(); ++i) {
      if (where[i] > 0) white.push_back(trace.y[i]);
      if (where[i] < 0) black.push_back(trace.y[i]);
      clipped +=
          where[i] > 0 && trace.step > 0.0 && (trace.y[i] < trace.step || trace.y[i] > 1023.0 * trace.step);
    }
    for (std::size_t i = 1; i + 1 < t.size(); ++i) {
      if (where[i - 1] != where[i] || where[i + 1] != where[i] || where[i] == 0) continue;
      (where[i] > 0 ? rough_white : rough_black)
          .push_back(trace.y[i - 1] - 2.0 * trace.y[i] + trace.y[i + 1]);
    }
    length += crossings.front().speed * (t.back() - t.front());
    radius = trace.radius;
    logs.insert(*trace.file);
  }
  ElementFit& fit = element.fit;
  const double step = element.traces.front().step;
  // Converts the time step of an RC sensor to the step of the rate, 1 / time.
  const auto step_at = [&](const std::vector<double>& rates) {
    const double rate = rates.empty() ? 0.0 : mean(rates);
    const double timing = element.traces.front().timing;
    return std::hypot(step, timing > 0.0 ? std::hypot(timing, kClock) * rate * rate : 0.0);
  };
  fit.noise = noise_of(rough_white, step_at(white));
  fit.dark_noise = noise_of(rough_black, step_at(black));
  const double floor = deviation(white);  // caused by patches of the floor, and by noise
  const double circles = 2.0 * std::numbers::pi * radius * static_cast<double>(logs.size());
  const double patches = std::max((radius > 0.0 ? std::min(length, circles) : length) / kPatch, 2.0);
  const bool skewed = static_cast<double>(clipped) > kMostClipped * static_cast<double>(white.size());
  fit.white = {skewed ? median(white) : mean(white), (skewed ? 1.25 : 1.0) * floor / std::sqrt(patches)};
  // The mean of times that are rounded to steps is uncertain by a quarter of a step.
  fit.white.sd =
      std::hypot(fit.white.sd, 0.25 * element.traces.front().timing * fit.white.value * fit.white.value);
  fit.black = {mean(black),
               std::max(deviation(black) / std::sqrt(static_cast<double>(black.size())), 0.5 * step)};
}

std::vector<Edge> cut_edges(const std::vector<Element>& elements, double tape_m, double footprint,
                            double* spacing) {
  const double inside = std::min(0.5 * tape_m, 0.5 * footprint + 0.003);
  const double outside = 0.5 * footprint + 0.003;
  std::vector<Edge> edges;
  double sum = 0.0;
  std::size_t count = 0;
  for (const Element& element : elements) {
    for (std::size_t k = 0; k < element.traces.size(); ++k) {
      const std::vector<double>& t = element.traces[k].sweep->t;
      for (const Crossing& c : element.crossings[k]) {
        for (const bool entering : {true, false}) {
          Edge edge{{}, {}, element.fit.black.value};
          const double from = entering ? c.enters - outside / c.speed : c.leaves - inside / c.speed;
          const double to = entering ? c.enters + inside / c.speed : c.leaves + outside / c.speed;
          for (std::size_t i = index_at(t, from); i < t.size() && t[i] <= to; ++i) {
            const double s = c.speed * (entering ? t[i] - c.enters : c.leaves - t[i]);
            edge.s.push_back(s);
            edge.y.push_back(element.traces[k].y[i]);
          }
          if (edge.s.size() < 5) continue;
          sum += std::fabs(edge.s.back() - edge.s.front());
          count += edge.s.size() - 1;
          edges.push_back(std::move(edge));
        }
      }
    }
  }
  if (edges.size() > kMostEdges) {
    const std::size_t stride = edges.size() / kMostEdges + 1;
    for (std::size_t i = 0; i * stride < edges.size(); ++i) std::swap(edges[i], edges[i * stride]);
    edges.resize((edges.size() + stride - 1) / stride);
  }
  *spacing = count ? sum / static_cast<double>(count) : 0.0;
  return edges;
}

void measure_footprint(PartFit& fit, const std::vector<Element>& elements, double tape_m) {
  // The first footprint is a guess; each round cuts the edges again with a better footprint.
  double footprint = 0.25 * tape_m;
  std::vector<Edge> edges;
  for (int round = 0; round < 3; ++round) {
    edges = cut_edges(elements, tape_m, footprint, &fit.spacing);
    if (edges.empty()) return;
    footprint = fit_footprint(edges, 0, 1, footprint, tape_m);
  }
  std::vector<double> tenths;
  const std::size_t batches = std::min(kBatches, edges.size());
  for (std::size_t k = 0; k < batches; ++k)
    tenths.push_back(fit_footprint(edges, k, batches, footprint, tape_m));
  const double scatter = mean_sd(tenths);
  // If samples are farther apart than the footprint, they show only that the footprint is small.
  if (fit.spacing > footprint) return;
  // Half of the relative difference between the measured and the given tape width counts as uncertainty.
  const double scale = fit.seen.value > 0.0 ? 0.5 * (fit.seen.value / tape_m - 1.0) : 0.0;
  fit.footprint = {footprint, std::hypot(scatter, std::hypot(0.01, scale) * footprint)};
  for (const Edge& edge : edges) {
    const double offset = best_offset(edge, footprint, tape_m);
    const double white = at_offset(edge, offset, footprint, tape_m).white;
    for (std::size_t i = 0; i < edge.s.size(); ++i)
      fit.points.push_back({edge.s[i] - offset, (edge.y[i] - white) / (edge.black - white)});
  }
}

/// Collects track widths. From a crossing to the second crossing after it, the robot makes a whole turn. The
/// wheels' counts give the length of the wheels' path in this turn.
void collect_turns(const Element& element, const robot::Description& robot, std::vector<double>& tracks) {
  for (std::size_t k = 0; k < element.traces.size(); ++k) {
    const Trace& trace = element.traces[k];
    if (trace.angle.empty()) continue;
    const std::vector<double>& t = trace.sweep->t;
    const auto angle_at = [&](const Crossing& c) {
      const double time = 0.5 * (c.enters + c.leaves);
      const auto after = static_cast<std::size_t>(std::upper_bound(t.begin(), t.end(), time) - t.begin());
      const double share = (time - t[after - 1]) / (t[after] - t[after - 1]);
      return trace.angle[after - 1] + share * (trace.angle[after] - trace.angle[after - 1]);
    };
    for (std::size_t i = 2; i < element.crossings[k].size(); ++i) {
      const double turned =
          std::fabs(angle_at(element.crossings[k][i]) - angle_at(element.crossings[k][i - 2]));
      tracks.push_back(turned / (2.0 * std::numbers::pi) * robot.chassis.track.value);
    }
  }
}

/// The part and element of a column.
struct Column {
  const ReflectanceSpec* part = nullptr;
  std::size_t element = 0;
};

std::map<std::string, Column> columns_of(const robot::Description& robot) {
  std::map<std::string, Column> columns;
  for (const auto& part : robot.parts)
    if (const auto* sensors = dynamic_cast<const ReflectanceSpec*>(part.get()))
      for (std::size_t i = 0; i < sensors->elements.size(); ++i)
        columns[sensors->elements[i].name] = {sensors, i};
  return columns;
}

std::vector<Element> gather(const std::vector<Log>& logs, const robot::Description& robot,
                            const ReflectanceSpec& part, const std::map<std::string, Column>& columns,
                            double tape_m) {
  std::vector<Element> elements;
  for (std::size_t i = 0; i < part.elements.size(); ++i) {
    Element element;
    element.fit.name = part.elements[i].name;
    for (const Log& log : logs) {
      for (const Sweep& sweep : log.sweeps) {
        for (std::size_t c = 0; c < sweep.names.size(); ++c) {
          const Column& column = columns.at(sweep.names[c]);
          if (column.part != &part || column.element != i) continue;
          Trace trace = make_trace(log, sweep, c, part, i, robot);
          const Levels levels = rough_levels(trace, element.fit.name, part);
          const Levels& first = element.traces.empty() ? levels : element.rough;
          const double span = first.black - first.white;
          if (std::fabs(levels.white - first.white) + std::fabs(levels.black - first.black) >
              kMostChange * std::fabs(span))
            throw InputError(
                {log.file, sweep.line},
                fmt::format(
                    "in this sweep, {} reads {:.3g} over the floor and {:.3g} over the tape, but {:.3g} and "
                    "{:.3g} in the sweep {}; check that both sweeps are of the same robot at the same height",
                    element.fit.name, levels.white, levels.black, first.white, first.black,
                    to_string(Place{*element.traces.front().file, element.traces.front().sweep->line})));
          if (element.traces.empty()) element.rough = levels;
          element.crossings.push_back(find_crossings(trace, element.fit.name, levels, tape_m));
          element.fit.crossings += element.crossings.back().size();
          element.traces.push_back(std::move(trace));
        }
      }
    }
    if (!element.traces.empty()) elements.push_back(std::move(element));
  }
  return elements;
}

/// Fits one part. `scale` corrects speeds from wheel counts. It is the file's track width / the fitted one.
PartFit fit_part(const ReflectanceSpec& part, std::vector<Element>& elements, double tape_m, double scale) {
  PartFit fit;
  fit.part = &part;
  for (Element& element : elements)
    for (std::size_t k = 0; k < element.traces.size(); ++k)
      for (Crossing& c : element.crossings[k])
        if (!element.traces[k].angle.empty()) c.speed *= scale;
  std::vector<double> noise, seen;
  for (Element& element : elements) {
    measure_levels(element);
    noise.push_back(element.fit.noise / std::fabs(element.fit.black.value - element.fit.white.value));
    for (std::size_t k = 0; k < element.traces.size(); ++k)
      for (const Crossing& c : element.crossings[k])
        if (!element.traces[k].angle.empty()) seen.push_back(c.speed * (c.leaves - c.enters));
  }
  // If the elements' noise is uniformly distributed, twice this value is the half-width of the distribution.
  const double differ = noise.size() > 1 ? 0.5 * std::numbers::sqrt3 * deviation(noise) : 0.0;
  fit.noise = {mean(noise), std::hypot(0.02 * mean(noise), differ)};
  if (!seen.empty()) fit.seen = {mean(seen), deviation(seen) / std::sqrt(static_cast<double>(seen.size()))};
  measure_footprint(fit, elements, tape_m);
  for (Element& element : elements) fit.elements.push_back(std::move(element.fit));
  return fit;
}

bool is_swept(const std::vector<Log>& logs, const ReflectanceSpec& part) {
  for (const Log& log : logs)
    for (const Sweep& sweep : log.sweeps)
      for (const auto& element : part.elements)
        if (std::find(sweep.names.begin(), sweep.names.end(), element.name) != sweep.names.end()) return true;
  return false;
}

}  // namespace

SweepFit fit_sweeps(const std::vector<Log>& logs, const robot::Description& robot, double tape_m) {
  const std::map<std::string, Column> columns = columns_of(robot);
  std::vector<std::string> known;
  for (const auto& [name, column] : columns) known.push_back(name);
  for (const Log& log : logs)
    for (const Sweep& sweep : log.sweeps)
      for (const std::string& name : sweep.names)
        if (!columns.contains(name))
          throw InputError({log.file, sweep.line},
                           known.empty()
                               ? fmt::format("unknown column {}: the robot has no floor sensors", name)
                               : unknown_name("floor sensor", name, known));
  SweepFit fit;
  std::vector<double> tracks;
  std::vector<std::pair<const ReflectanceSpec*, std::vector<Element>>> parts;
  for (const auto& part : robot.parts) {
    const auto* sensors = dynamic_cast<const ReflectanceSpec*>(part.get());
    if (!sensors) continue;
    if (sensors->read == ReflectanceSpec::Read::digital) {
      if (is_swept(logs, *sensors))
        fit.remarks.push_back(sensors->name +
                              ": a comparator's output shows neither its threshold nor its footprint");
      continue;
    }
    parts.emplace_back(sensors, gather(logs, robot, *sensors, columns, tape_m));
    for (const Element& element : parts.back().second) collect_turns(element, robot, tracks);
  }
  if (tracks.size() > 1)
    fit.track = {mean(tracks), std::hypot(deviation(tracks) / std::sqrt(static_cast<double>(tracks.size())),
                                          0.001 * mean(tracks))};
  const double scale = fit.track.value > 0.0 ? robot.chassis.track.value / fit.track.value : 1.0;
  for (auto& [part, elements] : parts)
    if (!elements.empty()) fit.parts.push_back(fit_part(*part, elements, tape_m, scale));
  return fit;
}

}  // namespace robosim::calibrate
