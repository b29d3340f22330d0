#include "surgery/seam_knots.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "data/index.h"

namespace vasorod {
namespace {

// A vertex without a partner is inserted opposite: the squared slide, in local edges, that is as
// bad. Two vertices without partners cost as much as a slide by 0.6 of an edge.
constexpr double single_cost = 0.18;
// The shortest gap between knots that costs nothing, in local edges, and the cost of shorter ones.
constexpr double short_gap = 0.45, short_gap_cost = 4;
// The local edge is the mean over this many edges on each side of a vertex.
constexpr int edges_beside = 3;

// The mean edge at every vertex of a closed loop of length 1.
std::vector<double> local_edges(const std::vector<double>& corners) {
  const int n = static_cast<int>(corners.size());
  const int reach = std::min(edges_beside, (n - 1) / 2);
  std::vector<double> mean;
  for (int i = 0; i < n; ++i) {
    const double ahead = corners[index((i + reach) % n)] - corners[index((i - reach + n) % n)];
    mean.push_back((ahead > 0 ? ahead : ahead + 1) / (2 * reach));
  }
  return mean;
}

// Aligns the two lists of vertices by dynamic programming, as one aligns two sequences of letters.
class Alignment {
 public:
  Alignment(const SeamCorners& corners, const SeamRefusals& refusals)
      : corners_(corners),
        refusals_(refusals),
        mouth_edge_(local_edges(corners.mouth)),
        rim_edge_(local_edges(corners.rim)) {}

  std::vector<SeamKnot> run() {
    // The first tip meets the first vertex of the mouth behind it, the last one before it, or none.
    const int m = static_cast<int>(corners_.mouth.size());
    double best = std::numeric_limits<double>::infinity();
    std::vector<SeamKnot> knots;
    for (const auto& [partner, first, last] :
         {std::array{-1, 0, m}, {0, 1, m}, {m - 1, 0, m - 1}}) {
      double cost = single_cost;
      if (partner >= 0) {
        if (refused(partner, 0)) continue;
        const double slide =
            std::abs(std::remainder(corners_.mouth[index(partner)], 1.0)) / edge(partner, 0);
        cost = slide * slide;
      }
      first_ = first;
      last_ = last;
      std::vector<SeamKnot> inner;
      cost += align(inner);
      if (cost >= best) continue;
      best = cost;
      knots.assign(1, {partner, 0, 0.0});
      knots.insert(knots.end(), inner.begin(), inner.end());
    }
    spread(knots);
    return knots;
  }

 private:
  enum Kind { both, mouth_only, rim_only, kinds };
  struct Cell {
    double cost = std::numeric_limits<double>::infinity();
    int before = -1;  // kind of the knot before
  };

  bool is_tip(int rim) const { return rim == 0 || rim == corners_.other_tip; }
  double share(int mouth, int rim) const {
    const auto entry = refusals_.share.find({mouth, rim});
    return entry == refusals_.share.end() ? 0 : entry->second;
  }
  bool refused(int mouth, int rim) const { return share(mouth, rim) > 1; }
  double edge(int mouth, int rim) const {
    if (mouth < 0) return rim_edge_[index(rim)];
    if (rim < 0) return mouth_edge_[index(mouth)];
    return std::min(mouth_edge_[index(mouth)], rim_edge_[index(rim)]);
  }
  double position(int mouth, int rim) const {
    if (mouth < 0 || (rim >= 0 && is_tip(rim))) return corners_.rim[index(rim)];
    const double at = corners_.mouth[index(mouth)];
    return rim < 0 ? at : at + share(mouth, rim) * (corners_.rim[index(rim)] - at);
  }

  // The knot of a kind after i vertices of the mouth (from first_) and j of the rim (from 1).
  SeamKnot knot(int i, int j, int kind) const {
    const int mouth = kind == rim_only ? -1 : first_ + i - 1, rim = kind == mouth_only ? -1 : j;
    return {mouth, rim, position(mouth, rim)};
  }
  double own_cost(const SeamKnot& k) const {
    if (k.mouth < 0 || k.rim < 0) return single_cost;
    const double slide =
        (corners_.mouth[index(k.mouth)] - corners_.rim[index(k.rim)]) / edge(k.mouth, k.rim);
    return slide * slide;
  }
  double gap_cost(const SeamKnot& before, const SeamKnot& after) const {
    const double h = std::min(edge(before.mouth, before.rim), edge(after.mouth, after.rim));
    const double missing = short_gap - (after.position - before.position) / h;
    return missing > 0 ? short_gap_cost * missing * missing : 0;
  }

  double align(std::vector<SeamKnot>& knots) const {
    const int m = last_ - first_, n = static_cast<int>(corners_.rim.size()) - 1;
    const SeamKnot begin{-1, 0, 0.0}, end{-1, 0, 1.0};
    std::vector<std::array<Cell, kinds>> cells(index((m + 1) * (n + 1)));
    const auto cell = [&](int i, int j) -> auto& {
      return cells[index(i * (n + 1) + j)];
    };
    for (int i = 0; i <= m; ++i)
      for (int j = 0; j <= n; ++j)
        for (int kind = 0; kind < kinds; ++kind) {
          const int from_i = i - (kind != rim_only), from_j = j - (kind != mouth_only);
          if ((i == 0 && j == 0) || from_i < 0 || from_j < 0) continue;
          const SeamKnot here = knot(i, j, kind);
          if (kind == both && refused(here.mouth, here.rim)) continue;
          Cell& best = cell(i, j)[index(kind)];
          const double own = own_cost(here);
          if (from_i == 0 && from_j == 0) {
            best = {own + gap_cost(begin, here), -1};
            continue;
          }
          for (int before = 0; before < kinds; ++before) {
            const double so_far = cell(from_i, from_j)[index(before)].cost;
            if (so_far + own >= best.cost) continue;
            const double cost = so_far + own + gap_cost(knot(from_i, from_j, before), here);
            if (cost < best.cost) best = {cost, before};
          }
        }
    double least = std::numeric_limits<double>::infinity();
    int kind = -1;
    for (int last = 0; last < kinds; ++last) {
      const double cost = cell(m, n)[index(last)].cost + gap_cost(knot(m, n, last), end);
      if (cost >= least) continue;
      least = cost;
      kind = last;
    }
    for (int i = m, j = n; i > 0 || j > 0;) {
      knots.push_back(knot(i, j, kind));
      const int before = cell(i, j)[index(kind)].before;
      i -= kind != rim_only;
      j -= kind != mouth_only;
      kind = before;
    }
    std::reverse(knots.begin(), knots.end());
    return least;
  }

  // How readily a knot moves: one without a vertex of the mouth is inserted there anyway.
  double mobility(const SeamKnot& k) const {
    if (k.rim >= 0 && is_tip(k.rim)) return 0;
    if (k.mouth < 0) return stays(refusals_.rim_stays, k.rim) ? 0 : 1;
    if (k.rim < 0 && stays(refusals_.mouth_stays, k.mouth)) return 0;
    return 0.3;
  }
  static bool stays(const std::vector<char>& all, int i) {
    return index(i) < all.size() && all[index(i)] != 0;
  }

  // Moves knots apart that are closer than `short_gap`.
  void spread(std::vector<SeamKnot>& knots) const {
    for (int sweep = 0; sweep < 500; ++sweep) {
      double worst = 0;
      for (size_t k = 0; k < knots.size(); ++k) {
        SeamKnot& a = knots[k];
        SeamKnot& b = knots[(k + 1) % knots.size()];
        const bool around = k + 1 == knots.size();
        const double h = std::min(edge(a.mouth, a.rim), edge(b.mouth, b.rim));
        const double missing = short_gap * h - (b.position + around - a.position);
        const double of_a = mobility(a), of_b = mobility(b);
        if (missing <= 1e-6 * h || of_a + of_b == 0) continue;
        worst = std::max(worst, missing / h);
        a.position -= missing * of_a / (of_a + of_b);
        b.position += missing * of_b / (of_a + of_b);
      }
      if (worst < 1e-3) return;
    }
  }

  const SeamCorners& corners_;
  const SeamRefusals& refusals_;
  std::vector<double> mouth_edge_, rim_edge_;
  int first_ = 0, last_ = 0;  // the mouth's vertices that are aligned
};

}  // namespace

std::vector<SeamKnot> choose_knots(const SeamCorners& corners, const SeamRefusals& refusals) {
  return Alignment(corners, refusals).run();
}

}  // namespace vasorod
