// Symmetric positive definite systems of a few unknowns.
// For the steps of descent and the evidence of ranking; large systems are not its business.
#pragma once

#include <optional>
#include <vector>

namespace parti::sketch {

/// n x n, row by row.
struct SquareMatrix {
  explicit SquareMatrix(size_t size) : n(size), values(size * size, 0.0) {}
  double& operator()(size_t row, size_t column) { return values[row * n + column]; }
  double operator()(size_t row, size_t column) const { return values[row * n + column]; }

  size_t n;
  std::vector<double> values;
};

/// The lower triangle L with L L^T = matrix (whose upper triangle is not read); nothing where the
/// matrix is not positive definite. Cost: n^3 / 6.
std::optional<SquareMatrix> Cholesky(const SquareMatrix& matrix);

/// x with L L^T x = right.
std::vector<double> Solve(const SquareMatrix& lower, std::vector<double> right);

/// log det(L L^T).
double LogDeterminant(const SquareMatrix& lower);

}  // namespace parti::sketch
