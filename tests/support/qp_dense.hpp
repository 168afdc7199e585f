// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A quadratic programme written out row by row, and judges that share nothing with the solver: KKT residuals, Farkas
// certificates, and the optimum by trying every active set of a small programme.
#ifndef TERN_TESTS_SUPPORT_QP_DENSE_HPP
#define TERN_TESTS_SUPPORT_QP_DENSE_HPP

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "qp/solver.hpp"

namespace tern_test {

using Column = std::vector<double>;

inline double dense_dot(const Column& a, const Column& b) {
  double total = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) total += a[i] * b[i];
  return total;
}

/// a'x <= b, with |normal| to measure violations by (1 for a zero normal).
struct DenseRow {
  tern::QpConstraint name;
  Column a;
  double b;
  double length;
};

/// Unknown i of axis c is element c * n + i.
struct DenseQp {
  std::vector<Column> hessian;
  Column linear;
  std::vector<DenseRow> rows;

  const DenseRow* find(const tern::QpConstraint& name) const {
    for (const DenseRow& row : rows) {
      if (row.name.point == name.point && row.name.plane == name.plane) return &row;
    }
    return nullptr;
  }
};

inline DenseRow dense_row(const tern::QpProblem& problem, int point, int plane) {
  const tern::QpPoint& p = problem.points[point];
  const tern::Halfspace& h = problem.planes[plane];
  const double normal[3] = {h.normal.x, h.normal.y, h.normal.z};
  const double offset[3] = {p.offset.x, p.offset.y, p.offset.z};
  const int n = problem.unknowns;
  DenseRow row{{point, plane}, Column(static_cast<std::size_t>(3 * n), 0.0), h.offset, 0.0};
  for (int c = 0; c < 3; ++c) {
    row.b -= normal[c] * offset[c];
    row.length += normal[c] * normal[c];
    for (int t = 0; t < p.terms; ++t) {
      row.a[static_cast<std::size_t>(c * n + p.first + t)] += normal[c] * p.coefficient[t];
    }
  }
  row.length = row.length > 0.0 ? std::sqrt(row.length) : 1.0;
  return row;
}

inline DenseQp expand(const tern::QpProblem& problem) {
  const int n = problem.unknowns;
  const auto size = static_cast<std::size_t>(3 * n);
  DenseQp dense{std::vector<Column>(size, Column(size, 0.0)), Column(size, 0.0), {}};
  for (int c = 0; c < 3; ++c) {
    for (int i = 0; i < n; ++i) {
      const auto row = static_cast<std::size_t>(c * n + i);
      dense.linear[row] = problem.linear[c][i];
      for (int d = 0; d <= std::min(i, tern::kQpBand); ++d) {
        const auto column = row - static_cast<std::size_t>(d);
        dense.hessian[row][column] = dense.hessian[column][row] = problem.hessian[i][d];
      }
    }
  }
  for (int g = 0; g < problem.group_count; ++g) {
    const tern::QpGroup& group = problem.groups[g];
    for (int k = group.point_begin; k < group.point_end; ++k) {
      for (int p = group.plane_begin; p < group.plane_end; ++p) dense.rows.push_back(dense_row(problem, k, p));
    }
  }
  return dense;
}

inline Column dense_unknowns(const tern::QpProblem& problem, const tern::QpSolution& solution) {
  Column x;
  for (int c = 0; c < 3; ++c) x.insert(x.end(), solution.x[c], solution.x[c] + problem.unknowns);
  return x;
}

inline Column dense_times(const std::vector<Column>& matrix, const Column& x) {
  Column y;
  for (const Column& row : matrix) y.push_back(dense_dot(row, x));
  return y;
}

inline double dense_objective(const DenseQp& dense, const Column& x) {
  return 0.5 * dense_dot(x, dense_times(dense.hessian, x)) + dense_dot(dense.linear, x);
}

/// Part of a row's largest term by which two ways to add the row up may differ.
constexpr double kDenseRounding = 1e-15;

/// Violation of the worst row, over its normal's length, less what rounding may have made of it.
inline double dense_violation(const DenseQp& dense, const Column& x) {
  double worst = 0.0;
  for (const DenseRow& row : dense.rows) {
    double largest = std::fabs(row.b);
    for (std::size_t i = 0; i < x.size(); ++i) largest = std::max(largest, std::fabs(row.a[i] * x[i]));
    worst = std::max(worst, (dense_dot(row.a, x) - row.b - kDenseRounding * largest) / row.length);
  }
  return worst;
}

/// Residuals of an answer that claims to be optimal. With all of them small it is: the programme is convex.
struct Kkt {
  double stationarity = 0.0;  ///< over the sum of absolute values of the terms, worst element, each over sqrt(H_ii)
  double violation = 0.0;
  double gap = 0.0;   ///< between primal and dual objective, over the sum of absolute values of their terms
  double sign = 0.0;  ///< most negative multiplier
  bool rows_known = true;
};

inline Kkt judge(const DenseQp& dense, const tern::QpProblem& problem, const tern::QpSolution& solution) {
  Kkt kkt;
  const Column x = dense_unknowns(problem, solution);
  Column residual = dense_times(dense.hessian, x);
  double scale = 0.0;
  double terms = std::fabs(dense_dot(x, residual)) + std::fabs(dense_dot(dense.linear, x));
  const auto weigh = [&](std::size_t i, double v) {
    scale = std::max(scale, std::fabs(v) / std::sqrt(dense.hessian[i][i]));
  };
  for (std::size_t i = 0; i < x.size(); ++i) {
    weigh(i, residual[i]);
    weigh(i, dense.linear[i]);
    residual[i] += dense.linear[i];
  }
  for (int j = 0; j < solution.active_count; ++j) {
    const DenseRow* row = dense.find(solution.active[j]);
    if (row == nullptr) return kkt.rows_known = false, kkt;
    kkt.sign = std::min(kkt.sign, solution.multiplier[j]);
    kkt.gap += solution.multiplier[j] * (row->b - dense_dot(row->a, x));
    terms += std::fabs(solution.multiplier[j] * row->b);
    for (std::size_t i = 0; i < x.size(); ++i) {
      weigh(i, solution.multiplier[j] * row->a[i]);
      residual[i] += solution.multiplier[j] * row->a[i];
    }
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    kkt.stationarity = std::max(kkt.stationarity, std::fabs(residual[i]) / std::sqrt(dense.hessian[i][i]));
  }
  if (scale > 0.0) kkt.stationarity /= scale;
  if (terms > 0.0) kkt.gap = std::fabs(kkt.gap) / terms;
  kkt.violation = dense_violation(dense, x);
  return kkt;
}

/// A certificate excludes every x with sum |x_i| < radius: y >= 0, and gap = -b'y = radius * max |A'y|.
inline double certified_radius(const DenseQp& dense, const tern::QpSolution& solution) {
  double gap = 0.0;
  Column combination(dense.linear.size(), 0.0);
  for (int j = 0; j < solution.active_count; ++j) {
    const DenseRow* row = dense.find(solution.active[j]);
    if (row == nullptr || solution.multiplier[j] < 0.0) return 0.0;
    gap -= solution.multiplier[j] * row->b;
    for (std::size_t i = 0; i < combination.size(); ++i) combination[i] += solution.multiplier[j] * row->a[i];
  }
  double residual = 1e-300;
  for (const double v : combination) residual = std::max(residual, std::fabs(v));
  return gap / residual;
}

/// Gaussian elimination with complete pivoting of rows; nothing for a singular matrix.
inline std::optional<Column> dense_solve(std::vector<Column> m, Column rhs) {
  const std::size_t n = rhs.size();
  for (std::size_t c = 0; c < n; ++c) {
    std::size_t best = c;
    for (std::size_t r = c + 1; r < n; ++r) {
      if (std::fabs(m[r][c]) > std::fabs(m[best][c])) best = r;
    }
    if (std::fabs(m[best][c]) < 1e-11) return std::nullopt;
    std::swap(m[c], m[best]);
    std::swap(rhs[c], rhs[best]);
    for (std::size_t r = c + 1; r < n; ++r) {
      const double factor = m[r][c] / m[c][c];
      for (std::size_t k = c; k < n; ++k) m[r][k] -= factor * m[c][k];
      rhs[r] -= factor * rhs[c];
    }
  }
  for (std::size_t c = n; c-- > 0;) {
    for (std::size_t k = c + 1; k < n; ++k) rhs[c] -= m[c][k] * rhs[k];
    rhs[c] /= m[c][c];
  }
  return rhs;
}

/// The KKT point of the rows of `set` taken as equations, if it is primal and dual feasible to `tolerance`.
inline std::optional<Column> try_active_set(const DenseQp& dense, const std::vector<std::size_t>& set,
                                            double tolerance) {
  const std::size_t n = dense.linear.size();
  const std::size_t size = n + set.size();
  std::vector<Column> m(size, Column(size, 0.0));
  Column rhs(size, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) m[i][j] = dense.hessian[i][j];
    rhs[i] = -dense.linear[i];
    for (std::size_t s = 0; s < set.size(); ++s) m[i][n + s] = m[n + s][i] = dense.rows[set[s]].a[i];
  }
  for (std::size_t s = 0; s < set.size(); ++s) rhs[n + s] = dense.rows[set[s]].b;
  const auto solved = dense_solve(m, rhs);
  if (!solved) return std::nullopt;
  for (std::size_t s = 0; s < set.size(); ++s) {
    if ((*solved)[n + s] < -tolerance) return std::nullopt;
  }
  Column x(solved->begin(), solved->begin() + static_cast<std::ptrdiff_t>(n));
  if (dense_violation(dense, x) > tolerance) return std::nullopt;
  return x;
}

/// Tries all active sets of at most as many rows as unknowns, smallest first; nothing: infeasible (or only just
/// feasible).
inline std::optional<Column> enumerate(const DenseQp& dense, double tolerance) {
  std::vector<std::vector<std::size_t>> layer{{}};
  for (std::size_t size = 0; size <= dense.linear.size(); ++size) {
    std::vector<std::vector<std::size_t>> next;
    for (const auto& set : layer) {
      if (const auto x = try_active_set(dense, set, tolerance)) return x;
      for (std::size_t r = set.empty() ? 0 : set.back() + 1; r < dense.rows.size(); ++r) {
        next.push_back(set);
        next.back().push_back(r);
      }
    }
    layer = std::move(next);
  }
  return std::nullopt;
}

/// A programme, its solver and its answer, on the heap of the host.
struct QpBench {
  std::unique_ptr<tern::QpProblem> problem = std::make_unique<tern::QpProblem>();
  std::unique_ptr<tern::QpSolver> solver = std::make_unique<tern::QpSolver>();
  std::unique_ptr<tern::QpSolution> solution = std::make_unique<tern::QpSolution>();

  /// Runs to the end in slices of the given size; a slice that never ends shows as kRunning.
  tern::Status run(std::uint32_t slice = 1000000) {
    for (int k = 0; k < 10 * tern::kMaxQpIterations; ++k) {
      tern::Work work{slice};
      const tern::Status status = tern::qp_advance(*solver, *problem, work, *solution);
      if (status != tern::Status::kRunning) return status;
    }
    return tern::Status::kRunning;
  }

  tern::Status solve() {
    tern::qp_begin(*solver, *problem, nullptr, 0);
    return run();
  }

  tern::Status solve_from(const std::vector<tern::QpConstraint>& rows) {
    tern::qp_begin(*solver, *problem, rows.data(), static_cast<int>(rows.size()));
    return run();
  }

  // Building blocks.
  int add_plane(tern::Vec3 normal, double offset) {
    problem->planes[problem->plane_count] = {normal, offset};
    return problem->plane_count++;
  }
  /// offset + the given coefficients on the unknowns from `first` on.
  int add_point(tern::Vec3 offset, int first, const std::vector<double>& coefficients) {
    tern::QpPoint& point = problem->points[problem->point_count];
    point = {};
    point.offset = offset;
    point.first = static_cast<std::int16_t>(first);
    point.terms = static_cast<std::int16_t>(coefficients.size());
    std::copy(coefficients.begin(), coefficients.end(), point.coefficient);
    return problem->point_count++;
  }
  void add_group(int point_begin, int point_end, int plane_begin, int plane_end) {
    problem->groups[problem->group_count++] = {point_begin, point_end, plane_begin, plane_end};
  }
  /// The diagonal of H and f of an axis-equal programme without rows.
  void start(const std::vector<double>& diagonal) {
    tern::QpProblem& p = *problem;
    p.unknowns = static_cast<int>(diagonal.size());
    p.point_count = p.plane_count = p.group_count = 0;
    for (int i = 0; i < p.unknowns; ++i) {
      for (double& h : p.hessian[i]) h = 0.0;
      p.hessian[i][0] = diagonal[static_cast<std::size_t>(i)];
      for (auto& f : p.linear) f[i] = 0.0;
    }
  }
  void pull(int axis, int unknown, double f) { problem->linear[axis][unknown] = f; }
};

}  // namespace tern_test

#endif
