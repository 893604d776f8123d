#include "limber/data/assignment.hpp"

#include <algorithm>
#include <limits>

#include "limber/common/mapped.hpp"

namespace limber {

namespace {

constexpr std::size_t kNobody = std::numeric_limits<std::size_t>::max();

/// Rows are let in one after the other, each on a shortest alternating path (Kuhn and Munkres, with
/// potentials that keep every reduced cost at 0 or above). The last column stands for "no row yet".
class Assigner {
 public:
  explicit Assigner(const Eigen::MatrixXd& gain)
      : gain_(gain),
        size_(std::size_t(gain.rows())),
        row_potential_(size_, 0.0),
        column_potential_(size_ + 1, 0.0),
        row_of_(size_ + 1, kNobody) {}

  std::vector<Eigen::Index> run() {
    for (std::size_t row = 0; row < size_; ++row) {
      let_in(row);
    }
    std::vector<Eigen::Index> column_of(size_);
    for (std::size_t column = 0; column < size_; ++column) {
      column_of[row_of_[column]] = Eigen::Index(column);
    }
    return column_of;
  }

 private:
  void let_in(std::size_t row) {
    row_of_[size_] = row;
    std::vector<double> distance(size_, std::numeric_limits<double>::infinity());
    std::vector<std::size_t> before(size_, size_);
    std::vector<char> done(size_ + 1, 0);
    std::size_t column = size_;
    while (row_of_[column] != kNobody) {
      done[column] = 1;
      const std::size_t nearest = relax(row_of_[column], column, done, distance, before);
      const double step = distance[nearest];
      for (std::size_t c = 0; c <= size_; ++c) {
        if (done[c] != 0) {
          row_potential_[row_of_[c]] += step;
          column_potential_[c] -= step;
        } else {
          distance[c] -= step;
        }
      }
      column = nearest;
    }
    while (column != size_) {
      row_of_[column] = row_of_[before[column]];
      column = before[column];
    }
    row_of_[size_] = kNobody;
  }

  /// Shortens distances by way of `row`, which holds `column`; the nearest column not done yet.
  std::size_t relax(std::size_t row, std::size_t column, const std::vector<char>& done,
                    std::vector<double>& distance, std::vector<std::size_t>& before) const {
    std::size_t nearest = kNobody;
    for (std::size_t c = 0; c < size_; ++c) {
      if (done[c] != 0) {
        continue;
      }
      const double cost =
          -gain_(Eigen::Index(row), Eigen::Index(c)) - row_potential_[row] - column_potential_[c];
      if (cost < distance[c]) {
        distance[c] = cost;
        before[c] = column;
      }
      nearest = nearest == kNobody || distance[c] < distance[nearest] ? c : nearest;
    }
    return nearest;
  }

  const Eigen::MatrixXd& gain_;
  std::size_t size_;
  std::vector<double> row_potential_;
  std::vector<double> column_potential_;
  std::vector<std::size_t> row_of_;
};

}  // namespace

std::vector<Eigen::Index> best_assignment(const Eigen::MatrixXd& gain) {
  return Assigner(gain).run();
}

double assignment_margin(const Eigen::MatrixXd& gain, const std::vector<Eigen::Index>& column) {
  double margin = std::numeric_limits<double>::infinity();
  for (Eigen::Index a = 0; a < gain.rows(); ++a) {
    for (Eigen::Index b = a + 1; b < gain.rows(); ++b) {
      const Eigen::Index of_a = column[a];
      const Eigen::Index of_b = column[b];
      margin = std::min(margin, gain(a, of_a) + gain(b, of_b) - gain(a, of_b) - gain(b, of_a));
    }
  }
  return margin;
}

double assigned_sum(const Eigen::MatrixXd& gain, const std::vector<Eigen::Index>& column) {
  return sum_of<double>(gain.rows(), [&](Eigen::Index i) { return gain(i, column[i]); });
}

}  // namespace limber
