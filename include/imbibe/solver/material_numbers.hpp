// All numbers of a phase's material or of a coupling, by name: to compare two of them and report differences.
#pragma once

#include <imbibe/core/numbers_of.hpp>
#include <imbibe/core/phase.hpp>

#include <string>
#include <utility>
#include <vector>

namespace imbibe::detail {

/// The name of a number, "sound speed", and its value with unit, "28 m/s".
using NamedNumbers = std::vector<std::pair<std::string, std::string>>;

/// Those of the coefficients, by the name of their type, all numbers of a type as one. A type with other members than
/// numbers, which a program's own may have, is left out.
template <class... Terms>
void add_coefficients(NamedNumbers& numbers, const Coefficients<Terms...>& coefficients) {
    [[maybe_unused]] const auto add = [&]<class Parameters>(const Parameters& parameters) {
        if (const std::string all = numbers_of(parameters); !all.empty())
            numbers.emplace_back(type_name<Parameters>(), all);
    };
    std::apply([&]([[maybe_unused]] const auto&... parameters) { (add(parameters), ...); }, coefficients.all);
}
/// Those of a phase's material, with its spacing and support radius, or of a coupling.
template <class Owner>
NamedNumbers numbers_of_owner(const Owner& owner) {
    NamedNumbers numbers;
    [[maybe_unused]] const auto add = [&](const char* what, double value, const char* unit) {
        numbers.emplace_back(what, exact_text(value) + unit);
    };
    if constexpr (requires { owner.spacing; }) {
        add("spacing", owner.spacing, " m");
        add("density", owner.density, " kg/m^3");
        add("sound speed", owner.sound_speed, " m/s");
        add("support radius", owner.support_radius, " m");
    }
    if constexpr (requires { owner.viscosity; })
        add("viscosity", owner.viscosity, " Pa s");
    if constexpr (requires { owner.shear_modulus; })
        add("shear modulus", owner.shear_modulus, " Pa");
    add_coefficients(numbers, owner.coefficients);
    return numbers;
}

} // namespace imbibe::detail
