// Provides the files of the page of `robosim serve` (sim/view/serve/page), which the build embeds.
#pragma once

#include <string_view>

namespace robosim::serve {

std::string_view bench_html();
std::string_view bench_css();
std::string_view bench_js();
std::string_view watch_js();
std::string_view editor_js();
std::string_view drop_js();
std::string_view hands_js();
std::string_view scripts_js();

}  // namespace robosim::serve
