#include "sketch/cholesky.h"

#include <cmath>

namespace parti::sketch {

std::optional<SquareMatrix> Cholesky(const SquareMatrix& matrix) {
  SquareMatrix lower(matrix.n);
  for (size_t i = 0; i < matrix.n; ++i) {
    for (size_t j = 0; j <= i; ++j) {
      double sum = matrix(i, j);
      for (size_t k = 0; k < j; ++k) sum -= lower(i, k) * lower(j, k);
      if (i == j && !(sum > 0)) return std::nullopt;
      lower(i, j) = i == j ? std::sqrt(sum) : sum / lower(j, j);
    }
  }
  return lower;
}

std::vector<double> Solve(const SquareMatrix& lower, std::vector<double> right) {
  for (size_t i = 0; i < lower.n; ++i) {
    for (size_t k = 0; k < i; ++k) right[i] -= lower(i, k) * right[k];
    right[i] /= lower(i, i);
  }
  for (size_t i = lower.n; i-- > 0;) {
    for (size_t k = i + 1; k < lower.n; ++k) right[i] -= lower(k, i) * right[k];
    right[i] /= lower(i, i);
  }
  return right;
}

double LogDeterminant(const SquareMatrix& lower) {
  double sum = 0;
  for (size_t i = 0; i < lower.n; ++i) sum += 2 * std::log(lower(i, i));
  return sum;
}

}  // namespace parti::sketch
