// A host whose Eigen keeps the numbers of a matrix row by row (EIGEN_DEFAULT_TO_ROW_MAJOR): the views of a scene are of
// the library's memory all the same, which has column after column, and the host's own matrices are taken as they are.
#include "scene.hpp"
#include <cstdio>
#include <imbibe/search/neighbour_search.hpp>

#ifndef EIGEN_DEFAULT_TO_ROW_MAJOR
#error "compile this with -DEIGEN_DEFAULT_TO_ROW_MAJOR"
#endif

// Pairs that the search finds among points.
template <class Points>
static int pairs_among(const Points& points) {
    imbibe::search::NeighbourSearch<2, float> search(0.26);
    const int set = search.add(points);
    search.update();
    int pairs = 0;
    for (int i = 0; i < search.size(set); ++i)
        pairs += search.count(set, i);
    return pairs;
}

int main() {
    SmallScene scene = fallen_square();
    const auto& water = scene.engine().state<SmallWater>();
    const auto x = scene.get<SmallWater>()[imbibe::position];
    int wrong = 0;
    for (int i = 0; i < water.size(); ++i)
        for (int d = 0; d < 2; ++d)
            wrong += x(i, d) != water.points().x[static_cast<std::size_t>(d)][i];

    const Eigen::MatrixXf copy = x; // row by row
    int pairs = 0;
    for (Eigen::Index i = 0; i < copy.rows(); ++i)
        for (Eigen::Index j = 0; j < copy.rows(); ++j)
            pairs += i != j && (copy.row(i) - copy.row(j)).squaredNorm() < 0.26f * 0.26f;
    std::printf("%d coordinates of the view are wrong; %d pairs, of which the search finds %d in it and %d in a copy\n",
                wrong, pairs, pairs_among(x), pairs_among(copy));
    return wrong == 0 && pairs > 400 && pairs_among(x) == pairs && pairs_among(copy) == pairs ? 0 : 1;
}
