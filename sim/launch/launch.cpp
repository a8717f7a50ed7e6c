#include "sim/launch/launch.h"

#include <fmt/format.h>

#include <utility>

#include "sim/base/file.h"
#include "sim/base/file_scope.h"
#include "sim/launch/trust.h"

namespace robosim::launch {

std::string script_text(const std::string& file) {
  constexpr std::size_t kMost_bytes = std::size_t{16} << 20;
  return read_file(file, kMost_bytes);
}

Chosen choose(const Launch& launch) {
  Chosen chosen;
  chosen.sketch = choose_sketch(launch.sketch, launch.environment, launch.untrusted);
  for (const project::Project& project = chosen.sketch.project;
       const auto* folders : {&project.libraries, &project.includes})
    for (const std::filesystem::path& folder : *folders) check_in_scope(folder, {project.file.string()});
  check_in_scope(chosen.sketch.project.sources, {chosen.sketch.project.file.string()});
  if (launch.untrusted) check_folder(chosen.sketch);
  chosen.target = choose_target(launch.target, chosen.sketch);
  if (launch.sanitize) name_flag("--sanitize", [&] { build::check_can_sanitize(chosen.target); });
  chosen.map = choose_map(launch.map, chosen.sketch.folder);
  chosen.robot = choose_robot(launch.robot, chosen.sketch, chosen.target);
  if (launch.untrusted) check_robot(chosen.sketch, chosen.robot);
  return chosen;
}

namespace {

constexpr const char* kForTheChip =
    "\nThe sketch compiles for the target avr: add --target avr to run it on the emulated chip.";

/// Returns whether a sketch that does not compile for the host compiles for an AVR. Such a sketch may contain
/// the chip's assembler, for example.
bool compiles_for_avr(const build::Request& request) try {
  if (request.target != "host" || std::string(request.board.chip->target) != "avr") return false;
  if (!build::missing_tool("avr").empty()) return false;
  build::Request other{request.sketch, request.board, "avr"};
  other.libraries = request.libraries;
  other.rules = request.rules;
  build::build(other);
  return true;
} catch (const std::exception&) {
  return false;
}

build::Image build_image(const build::Request& request) try {
  return build::build(request);
} catch (const build::MissingLibrary& error) {
  throw build::CompileError(error.place(), error.message() + "; --libraries DIR adds a folder of libraries");
} catch (const build::CompileError& error) {
  if (!compiles_for_avr(request)) throw;
  throw build::CompileError(error.place(), error.message() + kForTheChip);
} catch (const InputError& error) {
  if (!compiles_for_avr(request)) throw;
  throw InputError(error.place(), error.message() + kForTheChip);
}

}  // namespace

build::Image image_of(const SketchChoice& sketch, const build::Request& request, const Listener& listener) {
  if (!sketch.elf_target.empty()) {
    build::Image image;
    image.name = sketch.name;
    image.image = sketch.path;
    image.sketch_sha256 = sha256_of_file(sketch.path);
    return image;
  }
  if (listener.compiling) listener.compiling(title_of(sketch));
  build::Request told = request;
  if (listener.compiling_core)
    told.core_begins = [&] { listener.compiling_core(request.board.name, request.target); };
  build::Image image = build_image(told);
  if (listener.compiled) listener.compiled(image);
  return image;
}

void Launcher::tell(const std::function<void(const std::string&)>& to, const std::string& sentence) {
  if (to && !sentence.empty() && told_.insert(sentence).second) to(sentence);
}

const build::Image& Launcher::image(const SketchChoice& sketch, const build::Request& request) {
  std::string key = fmt::format("{}\n{}\n{}\n{}\n{}\n{}", sketch.path.string(), request.board.name,
                                request.target, request.sanitize, request.coverage, request.untrusted);
  key += "\n" + sketch.project.file.string() + "\n" + sketch.project.environment;
  for (const std::filesystem::path& folder : request.libraries) key += "\n" + folder.string();
  const auto known = images_.find(key);
  if (known != images_.end()) return known->second;
  return images_.emplace(key, image_of(sketch, request, listener_)).first->second;
}

Prepared Launcher::prepare(const Launch& launch, Chosen chosen, const Describe& describe,
                           const wire::Hello& runner) {
  for (const std::string& sentence : lacks(launch, chosen, runner)) tell(listener_.lacking, sentence);
  for (const std::string& sentence : remarks_on_project(chosen.sketch, launch.libraries))
    tell(listener_.chosen, sentence);
  tell(chosen.map.is_doubtful ? listener_.lacking : listener_.chosen, chosen.map.announcement);
  tell(listener_.chosen, chosen.robot.announcement);
  Carrier carrier = fit_to_target(chosen.robot, chosen.target, describe);
  tell(listener_.chosen, carrier.announcement);
  build::Request wanted = request_of(chosen.sketch, board_of(carrier.info), chosen.target, launch.libraries);
  wanted.sanitize = launch.sanitize;
  wanted.coverage = launch.count_lines;
  wanted.untrusted = launch.untrusted;
  const build::Image& built = image(chosen.sketch, wanted);
  Prepared run{std::move(chosen.sketch),
               std::move(chosen.map),
               std::move(carrier.robot),
               std::move(chosen.target),
               std::move(carrier.info),
               std::move(wanted),
               built,
               launch.request,
               ""};
  if (run.sketch.path.extension() == ".hex")
    run.remark =
        "a .hex has no names: loop() is not timed, the heap is unknown, and crashes and waits are reported "
        "by address; run the .elf for more";
  run.request.image = run.image.image.string();
  run.request.map = run.map.path.string();
  run.request.robot = run.robot.path.string();
  return run;
}

}  // namespace robosim::launch
