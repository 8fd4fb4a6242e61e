#include "eigenvalues.hpp"

#include <Eigen/Eigenvalues>

double imbibe_test::greatest_eigenvalue(const Eigen::Ref<const Eigen::MatrixXd>& symmetric) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(symmetric, Eigen::EigenvaluesOnly);
    return solver.eigenvalues().maxCoeff();
}
