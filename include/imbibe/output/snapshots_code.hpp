// The code of snapshots.hpp: writes the series of all phases.
#pragma once

#include <imbibe/output/snapshots.hpp>

namespace imbibe {

template <int dim, class Real>
void Snapshots::write(const detail::SceneStore<dim, Real>& scene, double seconds, const detail::Origin<dim>& origin) {
    static_assert(sizeof(std::uint32_t) == sizeof(std::int32_t));
    for (const auto& s : scene.phases) {
        const auto array_of = [&](const detail::FieldRow& field) {
            return VtkArray::of(std::string(field.name), std::string(field.unit), field.rank, dim,
                                s.column(field.first), s.stride());
        };
        VtkFile file(static_cast<std::size_t>(s.size()), array_of(s.row->field_at(s.row->position)));
        for (const detail::FieldRow& field : s.row->fields)
            if (field.shown && field.first != s.row->position)
                file.add(array_of(field));
        file.add(VtkArray::scalar("id", "1", reinterpret_cast<const std::int32_t*>(s.ids.data())));
        file.constant("spacing", s.numbers().spacing);
        const char* const names[] = {"origin_x", "origin_y", "origin_z"};
        for (std::size_t d = 0; d < dim; ++d)
            if (origin[d] != 0)
                file.constant(names[d], origin[d]);
        series(file_name(scene, s)).write(seconds, std::move(file));
    }
}

} // namespace imbibe
