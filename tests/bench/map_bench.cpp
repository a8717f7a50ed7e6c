// Measures reading a map of 8000 x 8000 cells (64 MB, the largest map). The reference is the minimum for
// any reader: read() of the cached file and a copy into fresh pages. Reading a map must take at most twice
// that time, and one byte of memory per cell. Then measures structures derived from maps, and the generation
// of large maps.
#include <benchmark/benchmark.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdio>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/map/generator.h"
#include "sim/map/map.h"
#include "sim/map/network.h"
#include "sim/map/stripes.h"
#include "sim/map/true_graph.h"
#include "tests/support/temporary_folder.h"

namespace {

using namespace robosim::map;

constexpr int kSide = 8'000;
constexpr std::size_t kChunk = 256 * 1024;

enum Form : std::int64_t { digits, displayed };

// A map file in the form of a comb: a trunk down the middle, a branch in every fourth row, and walls around.
class LargeMap {
 public:
  explicit LargeMap(Form form) {
    const char* signs = form == digits ? "012" : "_.#";
    std::FILE* file = std::fopen(path_.c_str(), "w");
    if (!file) return;
    std::string row;
    for (int y = 0; y < kSide; ++y) {
      const bool edge = y == 0 || y == kSide - 1;
      row.assign(kSide, edge ? signs[2] : signs[0]);
      row.front() = row.back() = signs[2];
      if (!edge && y > 2 && y < kSide - 3) row[kSide / 2] = signs[1];
      if (y % 4 == 3 && y < kSide - 3) std::memset(row.data() + 3, signs[1], kSide - 6);
      row += '\n';
      std::fwrite(row.data(), 1, row.size(), file);
    }
    std::fclose(file);
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  const robosim::test::TemporaryFolder folder_;
  const std::filesystem::path path_ = folder_ / "large.map";
};

double peak_megabytes() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

void BM_ReadAndCopy400MB(benchmark::State& state) {
  const LargeMap map(digits);
  std::vector<char> chunk(kChunk);
  for (auto _ : state) {
    const int file = ::open(map.path().c_str(), O_RDONLY | O_CLOEXEC);
    constexpr std::size_t size = std::size_t{kSide} * (kSide + 1);
    auto* pages =
        static_cast<char*>(::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
    std::size_t at = 0;
    for (ssize_t n; (n = ::read(file, chunk.data(), chunk.size())) > 0; at += static_cast<std::size_t>(n))
      std::memcpy(pages + at, chunk.data(), static_cast<std::size_t>(n));
    benchmark::DoNotOptimize(pages[at / 2]);
    ::close(file);
    ::munmap(pages, size);
  }
  state.SetBytesProcessed(state.iterations() * std::int64_t{kSide} * (kSide + 1));
}
BENCHMARK(BM_ReadAndCopy400MB)->Unit(benchmark::kMillisecond);

void BM_ReadMap400MB(benchmark::State& state) {
  const LargeMap file(static_cast<Form>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(read_map(file.path()).width);
  state.SetBytesProcessed(state.iterations() * std::int64_t{kSide} * (kSide + 1));
  state.counters["peak_MB"] = peak_megabytes();
}
BENCHMARK(BM_ReadMap400MB)->Arg(digits)->Arg(displayed)->ArgName("displayed")->Unit(benchmark::kMillisecond);

void BM_TraceNetworkD(benchmark::State& state) {
  const Map map = read_map(find_map("d"));
  const Start start = default_start(map);
  for (auto _ : state) benchmark::DoNotOptimize(trace_network(map, start).stations.size());
}
BENCHMARK(BM_TraceNetworkD)->Unit(benchmark::kMicrosecond);

void BM_BuildStripesDashed(benchmark::State& state) {
  const Map map = read_map(find_map("dashed"));
  for (auto _ : state) benchmark::DoNotOptimize(Stripes(map, 0.2).all().size());
}
BENCHMARK(BM_BuildStripesDashed)->Unit(benchmark::kMicrosecond);

// Measures one query of the distance to the nearest line, as a sensor makes it.
void BM_NearestStripeOval(benchmark::State& state) {
  const Map map = read_map(find_map("oval"));
  const Stripes stripes(map, 0.05);
  robosim::Vec2 p{0.3, 0.3};
  for (auto _ : state) {
    p = {p.x < 2.2 ? p.x + 0.0037 : 0.3, p.y < 1.4 ? p.y + 0.0023 : 0.3};
    const CellAt cell{static_cast<int>(p.x / map.cell_m),
                      map.height - 1 - static_cast<int>(p.y / map.cell_m)};
    double nearest = 1.0;
    for (const std::uint32_t i : stripes.near(cell))
      nearest = std::min(nearest, distance(stripes.all()[i], p));
    benchmark::DoNotOptimize(nearest);
  }
}
BENCHMARK(BM_NearestStripeOval);

void BM_GenerateTreeOfAMillionStations(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(generate(Family::tree, 1'000'000, 1).cells.size());
  state.counters["peak_MB"] = peak_megabytes();
}
BENCHMARK(BM_GenerateTreeOfAMillionStations)->Unit(benchmark::kMillisecond);

void BM_TrueGraphOfAMillionStations(benchmark::State& state) {
  const Map map = generate(Family::tree, 1'000'000, 1);
  const Start start = default_start(map);
  for (auto _ : state) benchmark::DoNotOptimize(true_graph(map, start).stations.size());
  state.counters["peak_MB"] = peak_megabytes();
}
BENCHMARK(BM_TrueGraphOfAMillionStations)->Unit(benchmark::kMillisecond);

}  // namespace
