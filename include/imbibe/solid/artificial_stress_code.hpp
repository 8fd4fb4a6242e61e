// The code of artificial_stress.hpp: the tensile part of a stress, by Eigen's decomposition.
#pragma once

#include <imbibe/solid/artificial_stress.hpp>

#include <Eigen/Eigenvalues>

namespace imbibe::detail {

template <int dim>
SymmetricTensor<double, dim> positive_eigenpart_of(const SymmetricTensor<double, dim>& t) {
    using Matrix = Eigen::Matrix<double, dim, dim>;
    Matrix all;
    for (int i = 0; i < dim; ++i)
        for (int j = 0; j < dim; ++j)
            all(i, j) = t(i, j);
    Eigen::SelfAdjointEigenSolver<Matrix> axes;
    axes.computeDirect(all);
    const Matrix& n = axes.eigenvectors();
    const Matrix positive = n * axes.eigenvalues().cwiseMax(0.0).asDiagonal() * n.transpose();
    SymmetricTensor<double, dim> result{};
    for (int i = 0; i < dim; ++i)
        for (int j = i; j < dim; ++j)
            result(i, j) = positive(i, j);
    return result;
}

IMBIBE_CODE SymmetricTensor<double, 2> positive_eigenpart(const SymmetricTensor<double, 2>& t) {
    return positive_eigenpart_of(t);
}
IMBIBE_CODE SymmetricTensor<double, 3> positive_eigenpart(const SymmetricTensor<double, 3>& t) {
    return positive_eigenpart_of(t);
}

} // namespace imbibe::detail
