#include "sim/record/recorder.h"

#include <algorithm>

#include "sim/base/error.h"
#include "sim/record/record_csv.h"
#include "sim/record/record_page.h"
#include "sim/record/record_png.h"
#include "sim/record/record_svg.h"
#include "sim/record/record_trace.h"
#include "sim/record/record_vcd.h"

namespace robosim::record {
namespace {

struct Kind {
  const char* ending;
  bool is_picture;
  std::unique_ptr<Recorder> (*make)(const std::filesystem::path& file);
};

template <class R>
std::unique_ptr<Recorder> make(const std::filesystem::path& file) {
  return std::make_unique<R>(file);
}

constexpr Kind kKinds[] = {{".csv", false, make<CsvRecorder>},
                           {".vcd", false, make<VcdRecorder>},
                           {".html", false, make<PageRecorder>},
                           {".rec", false, make<RecRecorder>},
                           {".perfetto.json", false, make<TraceRecorder>},
                           {".svg", true, make<SvgRecorder>},
                           {".png", true, make<PngRecorder>}};

bool has_ending(const std::filesystem::path& file, const std::string& ending) {
  const std::string name = file.filename();
  return name.size() > ending.size() && name.ends_with(ending);
}

std::vector<std::string> endings_where(bool only_pictures) {
  std::vector<std::string> endings;
  for (const Kind& kind : kKinds)
    if (kind.is_picture || !only_pictures) endings.push_back(kind.ending);
  return endings;
}

[[noreturn]] void refuse(const std::filesystem::path& file, const std::vector<std::string>& endings) {
  throw InputError(file.string() + ": expected a name that ends in " + one_of(endings));
}

}  // namespace

const std::vector<std::string>& record_endings() {
  static const std::vector<std::string> endings = endings_where(false);
  return endings;
}

void check_is_picture(const std::filesystem::path& file) {
  const std::vector<std::string> pictures = endings_where(true);
  const auto is = [&](const std::string& ending) { return has_ending(file, ending); };
  if (std::none_of(pictures.begin(), pictures.end(), is)) refuse(file, pictures);
}

std::unique_ptr<Recorder> make_recorder(const std::filesystem::path& file) {
  for (const Kind& kind : kKinds)
    if (has_ending(file, kind.ending)) return kind.make(file);
  refuse(file, record_endings());
}

void Recorder::ask(wire::RunRequest& request) const { request.samples_every_ns = kRecordEvery_ns; }

Recorders::Recorders(const std::vector<std::string>& files) : files_(files) {
  for (const std::string& file : files) recorders_.push_back(make_recorder(file));
}

void Recorders::ask(wire::RunRequest& request) const {
  for (const auto& recorder : recorders_) recorder->ask(request);
}

void Recorders::begin(const RecordedRun& run) {
  for (const auto& recorder : recorders_) recorder->begin(run);
}

void Recorders::add(const wire::Event& event) {
  for (const auto& recorder : recorders_) recorder->add(event);
}

void Recorders::finish(const result::RunResult& result) {
  for (const auto& recorder : recorders_) recorder->finish(result);
}

}  // namespace robosim::record
