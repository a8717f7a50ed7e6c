// Represents a network of lines as a graph, to compare the network that firmware has explored with the true
// one.
#pragma once

#include <gmock/gmock.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace robosim::testing {

/// Stations (one arm, or none if isolated) and junctions (three or four arms), in any numbering.
struct Graph {
  /// The other end of a line.
  struct End {
    int node = kBlocked;  ///< index into `nodes`
    int arm = 0;          ///< index of this line's arm at that node
  };
  static constexpr int kBlocked = -1;  ///< an obstacle is on the line

  struct Node {
    std::vector<End> arms;  ///< in counter-clockwise order, starting with any arm
  };
  std::vector<Node> nodes;

  int stations() const;
  int junctions() const;
};

/// Returns "" if the graphs are equal except for the numbering of nodes and the choice of first arms.
/// Otherwise returns a sentence about a difference.
std::string difference(const Graph& truth, const Graph& found);

/// Matches an equal graph: EXPECT_THAT(explored, IsTheSameGraphAs(robot.true_graph())).
class IsTheSameGraphAs {
 public:
  explicit IsTheSameGraphAs(Graph truth) : truth_(std::move(truth)) {}
  using is_gtest_matcher = void;
  bool MatchAndExplain(const Graph& found, std::ostream* out) const;
  void DescribeTo(std::ostream* out) const;
  void DescribeNegationTo(std::ostream* out) const;

 private:
  Graph truth_;
};

/// Prints "4 stations, 2 junctions".
void PrintTo(const Graph& graph, std::ostream* out);

}  // namespace robosim::testing
