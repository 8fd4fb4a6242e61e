// The code of layout_checks.hpp: looks at how particles lie, and puts it into words.
#pragma once

#include <imbibe/solver/layout_checks.hpp>

namespace imbibe::detail {

IMBIBE_CODE std::vector<char> sample_of(const Outline& phase, int dim) {
    std::vector<char> chosen(static_cast<std::size_t>(phase.size()), 1);
    if (dim == 3)
        for (std::size_t i = 0; i < chosen.size(); ++i)
            chosen[i] = (phase.ids[i] * 2654435761u >> 16) % 5 == 0;
    return chosen;
}

IMBIBE_CODE std::string warning_of_crowding(const Outline& phase, long long first_new, const OutlineOfScene& scene) {
    std::vector<char> added = sample_of(phase, scene.dim);
    const auto leave_out_the_old = [&] {
        for (std::size_t i = 0; i < added.size(); ++i)
            added[i] = added[i] && phase.ids[i] >= first_new;
    };
    leave_out_the_old();
    const double reach = 3 * phase.spacing;
    const double share = scene.dim == 2 ? sq(phase.spacing / reach) * WendlandC2::normalisation<2>()
                                        : power<3>(phase.spacing / reach) * WendlandC2::normalisation<3>();
    std::vector<double> filled(added.size());
    const auto count_crowded = [&] {
        for_surroundings(phase.now, added, reach, scene, [&](int i, const auto& nearby) {
            double sum = WendlandC2::value(0.0);
            nearby([&](const Coordinates&, double distance) { sum += WendlandC2::value(distance / reach); });
            filled[static_cast<std::size_t>(i)] = share * sum;
        });
        return std::count_if(filled.begin(), filled.end(), [](double sum) { return sum > 1.3; });
    };
    if (count_crowded() == 0)
        return {};
    added.assign(added.size(), 1);
    leave_out_the_old();
    const auto crowded = count_crowded();
    const auto worst = std::max_element(filled.begin(), filled.end());
    return text(phase.name, ": ", crowded, " of ", std::count(added.begin(), added.end(), char(1)),
                " particles lie where others of ", phase.name, " are: around that at ",
                scene.text_of(phase.now.at(static_cast<int>(worst - filled.begin()))), " particles fill ", *worst,
                " of the space (sum V W over 3 spacings; 1.3 is allowed). Each was added ", "with a spacing of ",
                phase.spacing, " m and has the mass density * spacing^dim, so the phase is too ",
                "heavy, and its pressure will throw them. Leave the second shape out of the first, fill(a - b, ",
                "spacing), add where there is room, or give the spacing of the points");
}

IMBIBE_CODE bool varies_less(const Coordinates& sum, std::array<Coordinates, 3> squares, int dim, double n,
                             double least) {
    // The matrix of variances minus `least` is positive where all pivots of its elimination are.
    const auto size = static_cast<std::size_t>(dim);
    auto& m = squares;
    for (std::size_t row = 0; row < size; ++row)
        for (std::size_t k = 0; k < size; ++k)
            m[row][k] = m[row][k] / n - sum[row] * sum[k] / (n * n) - (row == k ? least : 0);
    for (std::size_t k = 0; k < size; ++k) {
        if (!(m[k][k] > 0))
            return true;
        for (std::size_t row = k + 1; row < size; ++row)
            for (std::size_t column = size; column-- > k;)
                m[row][column] -= m[row][k] / m[k][k] * m[k][column];
    }
    return false;
}

IMBIBE_CODE std::vector<char> thin_among(const std::vector<char>& chosen, const Outline& phase, double layers,
                                         double reach, const OutlineOfScene& scene) {
    std::vector<char> thin(chosen.size());
    const double least = (sq(layers - 0.5) - 1) / 12 * sq(phase.spacing);
    for_surroundings(phase.at_rest, chosen, reach, scene, [&](int i, const auto& nearby) {
        Coordinates sum{};
        std::array<Coordinates, 3> squares{};
        double n = 1;
        nearby([&](const Coordinates& offset, double) {
            for (std::size_t row = 0; row < 3; ++row) {
                sum[row] += offset[row];
                for (std::size_t k = 0; k < 3; ++k)
                    squares[row][k] += offset[row] * offset[k];
            }
            n += 1;
        });
        // Alone, a particle has no thickness to judge.
        thin[static_cast<std::size_t>(i)] = n > 1 && varies_less(sum, squares, scene.dim, n, least);
    });
    return thin;
}

IMBIBE_CODE ThinParts thin_parts(const Outline& phase, double layers, double reach, const OutlineOfScene& scene) {
    const std::vector<char> sample = sample_of(phase, scene.dim), all(sample.size(), 1);
    std::vector<char> thin = thin_among(sample, phase, layers, reach, scene);
    if (100 * std::count(thin.begin(), thin.end(), char(1)) <= std::count(sample.begin(), sample.end(), char(1)))
        return {};
    thin = thin_among(all, phase, layers, reach, scene);
    const auto one = std::find(thin.begin(), thin.end(), char(1));
    return {std::count(thin.begin(), thin.end(), char(1)), phase.at_rest.at(static_cast<int>(one - thin.begin()))};
}

IMBIBE_CODE std::string warning_of_one_layer(const Outline& solid, const OutlineOfScene& scene) {
    const ThinParts thin = thin_parts(solid, 2, 2.1 * solid.spacing, scene);
    if (thin.number == 0)
        return {};
    return text(
        solid.name, ": ", thin.number, " of ", solid.size(), " particles lie in parts that are one particle thick, ",
        "such as at ", scene.text_of(thin.place), ". Nothing but hourglass control or ",
        "artificial stress resists its bending, which is many times too stiff or none at all. Give it at least 2 "
        "layers, with ",
        "bending_modulus(), better 4: a spacing of ", solid.spacing / 4, " m for what is ", solid.spacing, " m thick");
}

IMBIBE_CODE std::string warning_of_thin_wall(const Outline& wall, const Outline& fluid, double reach,
                                             const OutlineOfScene& scene) {
    const int needed = layers_needed(reach, wall.spacing);
    if (needed < 2) // none is thinner
        return {};
    const ThinParts thin = thin_parts(wall, needed, reach + wall.spacing, scene);
    if (thin.number == 0)
        return {};
    return text(wall.name, ": ", thin.number, " of ", wall.size(), " particles lie in parts of fewer than ", needed,
                " layers, such as at ", scene.text_of(thin.place), ". ", fluid.name, " reaches ", reach, " m, ",
                reach / wall.spacing, " spacings of ", wall.name, ", and goes through what is thinner. Give it ",
                needed, " layers or more, ", needed * wall.spacing, " m");
}

IMBIBE_CODE std::string warning_of_wide_spacing(const Outline& a, const Outline& b, double reach) {
    const auto &wide = a.spacing < b.spacing ? b : a, &fine = a.spacing < b.spacing ? a : b;
    const double least = 1.3 * wide.spacing * (1 - 1e-9);
    if (reach >= least || wide.support_radius < least) // that is said of the phase itself
        return {};
    return text(fine.name, " and ", wide.name, " see each other over ", reach, " m, ", reach / wide.spacing,
                " spacings of ", wide.name, " (", wide.spacing, " m): ", fine.name,
                " finds gaps there and goes through. At least 1.3 spacings are needed: give ", wide.name,
                " a spacing of at most ", reach / 1.3, " m");
}

IMBIBE_CODE std::optional<Coordinates> lattice_of(const Outline& phase, int dim) {
    if (phase.size() < 2)
        return {};
    Coordinates first{};
    for (std::size_t d = 0; d < static_cast<std::size_t>(dim); ++d) {
        const double at = phase.now.at(d, 0) / phase.spacing;
        first[d] = at - std::floor(at);
        for (int i = 1; i < phase.size(); ++i)
            if (const double away = phase.now.at(d, i) / phase.spacing - at; std::abs(away - std::round(away)) > 0.01)
                return {};
    }
    return first;
}

IMBIBE_CODE std::string warning_of_other_lattice(const Outline& a, const Outline& b, double nearest, int dim) {
    const double gap = nearest / a.spacing;
    if (std::abs(a.spacing - b.spacing) > 1e-6 * a.spacing || gap > 1.6 ||
        (gap > 0.95 && gap < (dim == 2 ? 1.13 : 1.24)))
        return {};
    const auto of_a = lattice_of(a, dim), of_b = lattice_of(b, dim);
    if (!of_a || !of_b)
        return {};
    std::string shares;
    double most = 0;
    for (std::size_t d = 0; d < static_cast<std::size_t>(dim); ++d) {
        double apart = (*of_a)[d] - (*of_b)[d];
        apart = std::abs(apart - std::round(apart));
        most = std::max(most, apart);
        shares += text(d == 0 ? "" : ", ", apart);
    }
    if (most < 0.02)
        return {};
    return text(a.name, " and ", b.name, " touch (a pair is ", nearest, " m apart) and lie on lattices of spacing ",
                a.spacing, " m that differ by (", shares, ") spacings, so the gap between them is not a spacing ",
                "everywhere. Fill both with one anchor, as in fill(shape, spacing, anchor): without it a lattice ",
                "begins in the lower corner of the shape's bounds");
}

} // namespace imbibe::detail
