#include "sim/cli/launching.h"

#include <fmt/format.h>

#include "sim/cli/output.h"

namespace robosim::cli {
launch::Listener listener_of(terminal::Progress& progress, Says says) {
  launch::Listener listener;
  if (says.choices)
    listener.chosen = [](const std::string& sentence) { complain(fmt::format("robosim: {}\n", sentence)); };
  listener.lacking = [](const std::string& sentence) { complain(fmt::format("robosim: {}\n", sentence)); };
  listener.compiling = [&progress](const std::string& sketch) { progress.say("compiling " + sketch + " …"); };
  listener.compiling_core = [&progress](const std::string& board, const std::string& target) {
    progress.say(
        fmt::format("compiling the Arduino core of the {} for {}, once for all sketches …", board, target));
  };
  listener.compiled = [&progress, says](const build::Image& image) {
    progress.clear();
    if (!says.warnings || image.messages.empty()) return;
    std::string text = says.all_warnings ? image.messages : build::folded(image.messages);
    if (!text.ends_with('\n')) text += '\n';
    complain(text);
  };
  return listener;
}

}  // namespace robosim::cli
