// The greatest eigenvalue of a small matrix, compiled once for all tests: Eigen's solver takes a compiler long.
#pragma once

#include <Eigen/Core>

namespace imbibe_test {

/// The greatest eigenvalue of a symmetric matrix, of which only the lower half is read.
double greatest_eigenvalue(const Eigen::Ref<const Eigen::MatrixXd>& symmetric);

} // namespace imbibe_test
