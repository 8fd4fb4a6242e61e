// A box of four dimensions.
// expect: NotTwoOrThreeDimensions
// expect: a scene or a shape has 2 or 3 dimensions
#include <imbibe/geometry/box.hpp>

#include "scene.hpp"

int main() {
    const sph::Box<4> box({0, 0, 0, 0}, {1, 1, 1, 1});
}
