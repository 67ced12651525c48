#pragma once
// When a front arrives that moves through matter at a given speed: |grad t| = slowness, solved on
// square cells of constant slowness [s/m] with t and its gradient at their nodes. Nodes are settled
// in the order of time (Sethian, Level Set Methods and Fast Marching Methods, 1999); a node's time
// is the least over straight rays from the edges of settled neighbours, along which t is cubic
// (after Potter & Cameron, Jet Marching Methods, 2021), so that errors are small where fronts are
// smooth, also along edges of matter.
#include <cstddef>
#include <utility>
#include <vector>

namespace brisance {

/// What no front reaches has this time: finite, so that files and sums stay so. [s]
constexpr double never = 1e30;

class Eikonal {
 public:
  /// Square cells of size h [m], x fastest.
  struct Box {
    double low[2];
    double h;
    int cells[2];
  };

  /// Cells of slowness 0 let nothing pass.
  Eikonal(const Box& box, std::vector<double> slowness);

  const Box& box() const { return box_; }
  int nodes(int direction) const { return box_.cells[direction] + 1; }
  double coordinate(int direction, int i) const { return box_.low[direction] + i * box_.h; }
  /// Whether any cell around a node lets the front pass.
  bool open(int i, int j) const;

  /// Lets a front start at a node not later than at that time, with that gradient.
  void start(int i, int j, double time, double gx, double gy);
  void march();
  /// By straight rays from the edges of the cell that holds the place; beside open cells, up to two
  /// of them away, by the gradient of the nearest node; `never` beyond.
  double at(double x, double y) const;

 private:
  struct Node {
    double t = never, gx = 0, gy = 0;
    bool settled = false;
  };

  int node(int i, int j) const { return i + nodes(0) * j; }
  double slowness(int i, int j) const;
  void propose(int node, double time, double gx, double gy);
  void spread(int i, int j);
  void from_edge(int to, int p, int q, double slowness);
  double beside(double x, double y) const;

  /// A ray to the origin from the edge between two nodes that lie at (px, py) and (qx, qy).
  struct Ray {
    double t, x, y;  ///< time on arrival, and the place on the edge
  };
  static Ray best_ray(const Node& p, double px, double py, const Node& q, double qx, double qy,
                      double slowness);

  Box box_;
  std::vector<double> slowness_;
  std::vector<Node> nodes_;
  std::vector<std::pair<double, int>> heap_;  ///< earliest first; outdated entries stay in it
};

}  // namespace brisance
