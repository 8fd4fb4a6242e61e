// One part of a program whose parts are compiled with different options: runs the small scene and prints what it was
// compiled for and a sum that has every bit of how it ends. PART is the part's name.
#include "../small/scene.hpp"
#include <cstdio>

#define TEXT_OF_(x) #x
#define TEXT_OF(x) TEXT_OF_(x)
#define JOINED_(a, b) a##b
#define JOINED(a, b) JOINED_(a, b)

void JOINED(print_, PART)() {
    SmallScene scene = fallen_square();
    const auto water = scene.get<SmallWater>();
    double sum = 0;
    for (int i = 0; i < water.size(); ++i)
        sum += static_cast<double>(water[imbibe::position](i, 0)) * water.ids()[static_cast<std::size_t>(i)];
    std::printf("%s: packs of %d, %d threads, neighbours take %zu bytes, %a\n", TEXT_OF(PART), SmallScene::width,
                scene.threads(), scene.engine().list_bytes(), sum);
}
