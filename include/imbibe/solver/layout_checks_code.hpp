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
            nearby(
                [&](std::size_t, const Coordinates&, double distance) { sum += WendlandC2::value(distance / reach); });
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
        nearby([&](std::size_t, const Coordinates& offset, double) {
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

IMBIBE_CODE SurfaceSteps surface_steps(const Outline& phase, const Outline* fluid, const OutlineOfScene& scene) {
    using Place = Vector<double, 3>;
    const auto number = static_cast<std::size_t>(phase.size());
    const double spacing = phase.spacing;
    // The slope of a kernel over r, without its factor, and offsets in spacings.
    const auto slope = [](double distance, double reach) { return WendlandC2::derivative_over_q(distance / reach); };
    const auto place_of = [&](const Coordinates& offset) {
        return (1 / spacing) * Place{offset[0], offset[1], offset[2]};
    };
    std::vector<char> chosen(number, 1);
    if (fluid != nullptr) {
        std::vector<Coordinates> water;
        for (int i = 0; i < fluid->size(); ++i)
            water.push_back(fluid->now.at(i));
        const PlacesByCell cells(water, 2 * spacing, scene);
        PlacesByCell::Lookup lookup(cells);
        for (std::size_t i = 0; i < number; ++i) {
            chosen[i] = 0;
            lookup.for_each_near(phase.at_rest.at(static_cast<int>(i)),
                                 [&](int, const Coordinates&, double) { chosen[i] = 1; });
        }
    }

    // The normals: away from the particles on one side, over 3 spacings. At a flat face the sum is `flat` long.
    double flat = 0;
    for (int k = 1; k < 3; ++k)
        for (int a = -2; a <= 2; ++a)
            for (int b = scene.dim == 3 ? -2 : 0; b <= (scene.dim == 3 ? 2 : 0); ++b)
                if (const double r = std::sqrt(k * k + a * a + b * b); r < 3)
                    flat -= slope(r, 3) * k;
    std::vector<Place> normal(number, Place::zero());
    std::vector<char> outer(number, 0);
    for_surroundings(phase.at_rest, chosen, 3 * spacing, scene, [&](int k, const auto& nearby) {
        const auto i = static_cast<std::size_t>(k);
        Place sum = Place::zero();
        nearby([&](std::size_t, const Coordinates& offset, double distance) {
            sum -= slope(distance / spacing, 3) * place_of(offset);
        });
        outer[i] = norm(sum) > 0.5 * flat;
        if (outer[i])
            normal[i] = sum / norm(sum);
    });
    std::vector<char> smooth = outer;
    for_surroundings(phase.at_rest, outer, 2.5 * spacing, scene, [&](int k, const auto& nearby) {
        const auto i = static_cast<std::size_t>(k);
        nearby([&](std::size_t j, const Coordinates&, double) {
            smooth[i] = smooth[i] && (!outer[j] || dot(normal[i], normal[j]) > 0.866); // the cosine of 30 degrees
        });
    });
    SurfaceSteps steps;
    steps.of = std::count(outer.begin(), outer.end(), char(1));
    steps.looked_at = std::count(smooth.begin(), smooth.end(), char(1));
    if (steps.looked_at < 30 || 5 * steps.looked_at < steps.of)
        return steps;

    // L of all, from moments over 2 spacings, and with it t_b where the surface is smooth.
    std::vector<Tensor<double, 3>> correction(number);
    const std::vector<char> all(number, 1);
    const double share = scene.dim == 2 ? WendlandC2::normalisation<2>() / 16 : WendlandC2::normalisation<3>() / 32;
    for_surroundings(phase.at_rest, all, 2 * spacing, scene, [&](int k, const auto& nearby) {
        auto moments = Tensor<double, 3>::zero();
        nearby([&](std::size_t, const Coordinates& offset, double distance) {
            const Place x = place_of(offset);
            moments -= share * slope(distance / spacing, 2) * imbibe::outer(x, x);
        });
        if (scene.dim == 2)
            moments(2, 2) = 1;
        correction[static_cast<std::size_t>(k)] = inverse(moments + 1e-3 * identity<double, 3>());
    });
    std::vector<double> along(number, 0);
    for_surroundings(phase.at_rest, smooth, 2 * spacing, scene, [&](int k, const auto& nearby) {
        const auto i = static_cast<std::size_t>(k);
        Place t = Place::zero();
        nearby([&](std::size_t j, const Coordinates& offset, double distance) {
            t -= share * slope(distance / spacing, 2) * ((correction[i] + correction[j]) * place_of(offset));
        });
        along[i] = std::min(squared_norm(t - dot(t, normal[i]) * normal[i]), 4.0);
    });
    double sum = 0;
    for (const double part : along)
        sum += part;
    steps.unevenness = std::sqrt(sum / static_cast<double>(steps.looked_at));
    const auto worst = std::max_element(along.begin(), along.end());
    steps.place = phase.at_rest.at(static_cast<int>(worst - along.begin()));
    return steps;
}

IMBIBE_CODE std::string warning_of_steps(const Outline& phase, const Outline* fluid, const OutlineOfScene& scene) {
    const SurfaceSteps steps = surface_steps(phase, fluid, scene);
    if (steps.unevenness < 0.12)
        return {};
    return text(phase.name, ": its surface runs in steps across the lattice of its particles, such as at ",
                scene.text_of(steps.place), " (unevenness ", steps.unevenness, "; 0.12 is allowed). ",
                fluid == nullptr
                    ? "A solid bends up to twice too far for that, however fine"
                    : text("It brakes what slips along it, by up to a half, however fine. ", fluid->name, " is there"),
                ". Place its particles with fitted(shape, spacing)",
                fluid == nullptr ? "" : " or walls_of(shape, spacing, layers)", " instead of fill(shape, spacing)");
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
