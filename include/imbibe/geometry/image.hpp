// Bodies from images: grey values in voxels, as from computed tomography, with a threshold between solid and pore.
#pragma once

#include <imbibe/geometry/passage.hpp>
#include <imbibe/geometry/shape.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace imbibe {

/// Grey values in voxels.
struct GreyImage {
    std::array<int, 3> size{}; ///< voxels along x, y, z
    std::vector<float> values; ///< size[0] * size[1] * size[2] of them; x runs fastest, z slowest
    Point<3> sides{0, 0, 0};   ///< of a voxel, in the file's unit; 0 if the file does not say

    /// The number of a voxel in `values`.
    [[nodiscard]] std::size_t index(int x, int y, int z) const {
        const auto n = [](int i) { return static_cast<std::size_t>(i); };
        return n(x) + n(size[0]) * (n(y) + n(size[1]) * n(z));
    }
    /// The value of a voxel.
    [[nodiscard]] float at(int x, int y, int z) const { return values[index(x, y, z)]; }
};

namespace detail {

/// Throws Error unless the image has voxels, as many as its size says, with finite values.
inline void check_image(const char* who, const GreyImage& image) {
    double number = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        require(image.size[axis] >= 1, who, ": the image is ", image.size[axis], " voxels long along ", "xyz"[axis],
                "; it must be at least 1.");
        number *= image.size[axis];
    }
    require(number == static_cast<double>(image.values.size()), who, ": an image of ", image.size[0], " x ",
            image.size[1], " x ", image.size[2], " voxels has ", image.values.size(), " values.");
    for (std::size_t i = 0; i < image.values.size(); ++i)
        if (!std::isfinite(image.values[i]))
            throw Error(text(who, ": voxel ", i, " of the image has the value ", image.values[i],
                             "; values must be finite. Look at the file it is from."));
}

} // namespace detail

/// The part of an image from voxel `first` to one before voxel `last`, along x, y and z. Throws Error if that is not in
/// the image.
[[nodiscard]] inline GreyImage crop(const GreyImage& image, const std::array<int, 3>& first,
                                    const std::array<int, 3>& last) {
    detail::check_image("crop", image);
    GreyImage part;
    part.sides = image.sides;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        require(first[axis] >= 0 && first[axis] < last[axis] && last[axis] <= image.size[axis], "crop: from voxel ",
                first[axis], " to ", last[axis], " along ", "xyz"[axis], "; the image has voxels 0 to ",
                image.size[axis], ", and the first must be below the last.");
        part.size[axis] = last[axis] - first[axis];
    }
    for (int z = first[2]; z < last[2]; ++z)
        for (int y = first[1]; y < last[1]; ++y)
            for (int x = first[0]; x < last[0]; ++x)
                part.values.push_back(image.at(x, y, z));
    return part;
}

/// Which grey values are solid.
enum class SolidIs {
    above, ///< those from the threshold on
    below  ///< those below the threshold
};

/// How the image continues beyond its sides.
enum class Beyond {
    open,     ///< empty
    solid,    ///< solid
    mirrored, ///< the mirror image
    repeated  ///< the image repeated
};

/// How an image becomes a body. Sides, threshold and which side of it is solid have no default, because files do not
/// say them reliably.
struct Voxels {
    Point<3> sides;                 ///< of a voxel, m: {2.25e-6, 2.25e-6, 2.25e-6}
    double threshold;               ///< grey value between solid and pore
    SolidIs solid;                  ///< which side of it is solid
    Beyond beyond = Beyond::open;   ///< what is beyond the image, as far as `bounds`
    Point<3> lower{0, 0, 0};        ///< where the image begins, m
    std::optional<Box<3>> bounds{}; ///< of the body, m; not given: those of the image
};

/// The solid of an image. Small: copies share the image.
///
/// The grey value at a point is interpolated linearly between the centres of voxels, which makes the surface smooth:
/// for a fibre it is right within 0.22 voxels (rms), with whole voxels within 0.28.
class ImageBody {
public:
    /// Throws Error for an image without voxels or with values that are not finite, for sides that are not finite and >
    /// 0 m or have other ratios than the file says, and for a threshold for which all or none is solid.
    ImageBody(GreyImage image, const Voxels& voxels)
        : image_(std::make_shared<const GreyImage>(std::move(image))), voxels_(voxels), inner_(box_of(*image_, voxels)),
          bounds_(voxels.bounds.value_or(inner_)) {
        require(bounds_.bounded(), "ImageBody: Voxels::bounds must be bounded. Give two corners.");
        const auto [least, greatest] = std::minmax_element(image_->values.begin(), image_->values.end());
        require(voxels.threshold > static_cast<double>(*least) && voxels.threshold <= static_cast<double>(*greatest),
                "ImageBody: threshold = ", voxels.threshold, " must lie between the grey values of the image, ", *least,
                " and ", *greatest, ", so that there is solid and pore.");
    }

    [[nodiscard]] const GreyImage& image() const { return *image_; } ///< its grey values
    [[nodiscard]] const Voxels& voxels() const { return voxels_; }   ///< as requested
    [[nodiscard]] const Box<3>& image_box() const { return inner_; } ///< what the image covers, m

    /// Whether a voxel is solid.
    [[nodiscard]] bool is_solid(std::size_t voxel) const {
        return is_solid(static_cast<double>(image_->values[voxel]));
    }

    /// Whether the point is in the solid.
    [[nodiscard]] bool contains(const Point<3>& point) const {
        if (!bounds_.contains(point))
            return false;
        Point<3> at = (point - inner_.lower()).cwiseQuotient(voxels_.sides); // in voxels; their centres at 0.5, 1.5 ...
        for (int axis = 0; axis < 3; ++axis) {
            const double length = image_->size[static_cast<std::size_t>(axis)];
            if (at[axis] >= 0 && at[axis] <= length)
                continue;
            if (voxels_.beyond == Beyond::repeated) {
                at[axis] -= length * std::floor(at[axis] / length);
                continue;
            }
            if (voxels_.beyond != Beyond::mirrored)
                return voxels_.beyond == Beyond::solid;
            const double turn = std::fmod(std::abs(at[axis]), 2 * length);
            at[axis] = turn > length ? 2 * length - turn : turn;
        }
        return is_solid(value(at));
    }

    /// The given bounds, or the box of the image.
    [[nodiscard]] Box<3> bounds() const { return bounds_; }

    /// The share of pore voxels in the image, 0 to 1.
    [[nodiscard]] double porosity() const {
        const auto solid = std::count_if(image_->values.begin(), image_->values.end(),
                                         [&](float v) { return is_solid(static_cast<double>(v)); });
        return 1 - static_cast<double>(solid) / static_cast<double>(image_->values.size());
    }

    /// Diameter (m) of the largest ball that passes through the pores along z; 0 if none does.
    [[nodiscard]] double pore_width() const {
        const double affordable = std::cbrt(bounds_.volume() / 3e7);
        return widest_passage(*this, 2, std::max(voxels_.sides.minCoeff(), affordable));
    }

private:
    [[nodiscard]] static Box<3> box_of(const GreyImage& image, const Voxels& voxels) {
        detail::check_image("ImageBody", image);
        detail::require_finite<3>("ImageBody", "Voxels::lower", voxels.lower);
        Point<3> size;
        for (int axis = 0; axis < 3; ++axis) {
            detail::require_positive("ImageBody", "side of a voxel", voxels.sides[axis],
                                     "Give the sides of a voxel in metres: {2e-6, 2e-6, 2e-6}.");
            size[axis] = image.size[static_cast<std::size_t>(axis)] * voxels.sides[axis];
        }
        if (image.sides.minCoeff() > 0) {
            const Point<3> ratio = voxels.sides.cwiseQuotient(image.sides);
            require(ratio.maxCoeff() < 1.001 * ratio.minCoeff(), "ImageBody: voxels of ", point_text<3>(voxels.sides),
                    " were asked for, and the file has voxels of ", image.sides[0], " x ", image.sides[1], " x ",
                    image.sides[2], " in its own unit, which are of another shape. Give sides in that ratio.");
        }
        return {voxels.lower, voxels.lower + size};
    }
    [[nodiscard]] bool is_solid(double value) const {
        return (value >= voxels_.threshold) == (voxels_.solid == SolidIs::above);
    }
    [[nodiscard]] double value(const Point<3>& at) const {
        std::array<int, 3> low, high;
        Point<3> part;
        for (int axis = 0; axis < 3; ++axis) {
            const auto k = static_cast<std::size_t>(axis);
            const int last = image_->size[k] - 1;
            if (voxels_.beyond == Beyond::repeated) {
                const double below = std::floor(at[axis] - 0.5);
                part[axis] = at[axis] - 0.5 - below;
                low[k] = below < 0 || below > last ? last : static_cast<int>(below);
                high[k] = low[k] == last ? 0 : low[k] + 1;
                continue;
            }
            const double from_centre = std::clamp(at[axis] - 0.5, 0.0, static_cast<double>(last));
            low[k] = std::min(static_cast<int>(from_centre), last);
            high[k] = std::min(low[k] + 1, last);
            part[axis] = from_centre - low[k];
        }
        double sum = 0;
        for (int corner = 0; corner < 8; ++corner) {
            double weight = 1;
            for (int axis = 0; axis < 3; ++axis)
                weight *= corner >> axis & 1 ? part[axis] : 1 - part[axis];
            const auto pick = [&](std::size_t k) { return corner >> k & 1 ? high[k] : low[k]; };
            sum += weight * static_cast<double>(image_->at(pick(0), pick(1), pick(2)));
        }
        return sum;
    }

    std::shared_ptr<const GreyImage> image_;
    Voxels voxels_;
    Box<3> inner_, bounds_;
};

/// The pieces of an image's solid or pores: voxels connected by their faces.
struct Pieces {
    std::vector<int> of_voxel;     ///< the piece of each voxel, from 0; -1 of the other kind
    std::vector<long long> number; ///< of voxels in each
    int largest = -1;              ///< the piece with most of them; -1: there is none
    /// Whether some piece reaches from the first to the last voxel along an axis.
    [[nodiscard]] bool lead_through(const GreyImage& image, int axis) const {
        std::vector<char> begins(number.size(), 0);
        std::array<int, 3> end = image.size;
        end[static_cast<std::size_t>(axis)] = 1;
        bool through = false;
        for (int z = 0; z < end[2]; ++z)
            for (int y = 0; y < end[1]; ++y)
                for (int x = 0; x < end[0]; ++x)
                    if (const int piece = of_voxel[image.index(x, y, z)]; piece >= 0)
                        begins[static_cast<std::size_t>(piece)] = 1;
        const int last = image.size[static_cast<std::size_t>(axis)] - 1;
        for (int z = 0; z < end[2]; ++z)
            for (int y = 0; y < end[1]; ++y)
                for (int x = 0; x < end[0]; ++x) {
                    const int piece =
                        of_voxel[image.index(axis == 0 ? last : x, axis == 1 ? last : y, axis == 2 ? last : z)];
                    through = through || (piece >= 0 && begins[static_cast<std::size_t>(piece)]);
                }
        return through;
    }
};

/// The pieces of the solid (or of the pores) of an image.
[[nodiscard]] inline Pieces pieces_of(const ImageBody& body, bool solid = true) {
    const GreyImage& image = body.image();
    Pieces pieces;
    pieces.of_voxel.assign(image.values.size(), -1);
    std::vector<std::array<int, 3>> front;
    const auto enter = [&](int x, int y, int z, int piece) {
        int& mine = pieces.of_voxel[image.index(x, y, z)];
        if (mine >= 0 || body.is_solid(image.index(x, y, z)) != solid)
            return false;
        mine = piece;
        ++pieces.number[static_cast<std::size_t>(piece)];
        front.push_back({x, y, z});
        return true;
    };
    for (int z = 0; z < image.size[2]; ++z)
        for (int y = 0; y < image.size[1]; ++y)
            for (int x = 0; x < image.size[0]; ++x) {
                const int piece = static_cast<int>(pieces.number.size());
                pieces.number.push_back(0);
                if (!enter(x, y, z, piece)) {
                    pieces.number.pop_back();
                    continue;
                }
                while (!front.empty()) {
                    const auto [i, j, k] = front.back();
                    front.pop_back();
                    if (i > 0)
                        enter(i - 1, j, k, piece);
                    if (j > 0)
                        enter(i, j - 1, k, piece);
                    if (k > 0)
                        enter(i, j, k - 1, piece);
                    if (i + 1 < image.size[0])
                        enter(i + 1, j, k, piece);
                    if (j + 1 < image.size[1])
                        enter(i, j + 1, k, piece);
                    if (k + 1 < image.size[2])
                        enter(i, j, k + 1, piece);
                }
            }
    if (!pieces.number.empty())
        pieces.largest =
            static_cast<int>(std::max_element(pieces.number.begin(), pieces.number.end()) - pieces.number.begin());
    return pieces;
}

/// The body without pieces that are not connected to its largest piece: nothing holds an island, so it floats off or
/// falls. The grey values of their voxels become the most certain pore value.
[[nodiscard]] inline ImageBody without_islands(const ImageBody& body) {
    const Pieces pieces = pieces_of(body);
    GreyImage image = body.image();
    const auto [least, greatest] = std::minmax_element(image.values.begin(), image.values.end());
    const float pore = body.voxels().solid == SolidIs::above ? *least : *greatest;
    for (std::size_t i = 0; i < image.values.size(); ++i)
        if (pieces.of_voxel[i] >= 0 && pieces.of_voxel[i] != pieces.largest)
            image.values[i] = pore;
    return {std::move(image), body.voxels()};
}

} // namespace imbibe
