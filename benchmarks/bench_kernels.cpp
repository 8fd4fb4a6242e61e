// Measures every kernel by itself: value and gradient, in float and double, one number at a time and in packs of the
// machine's width. Counter `evaluation` is the time per number. Run it:
//
//   build-benchmark/benchmarks/bench_kernels
//   build-benchmark/benchmarks/bench_kernels --benchmark_filter='Wendland C2'
#include "support/measure.hpp"

#include <imbibe/core/term.hpp>
#include <imbibe/kernels/kernels.hpp>

#include <array>
#include <string>

namespace {

using namespace imbibe;

// In the cache of the first level, and long enough that the loop does not count.
constexpr std::size_t distances = 1024;

struct Value {
    template <class Kernel, int dim, class T>
    static T of(Kernel kernel, const Pair<dim, T>& ab) {
        return ab.value(kernel);
    }
};
struct Gradient {
    template <class Kernel, int dim, class T>
    static T of(Kernel kernel, const Pair<dim, T>& ab) {
        return ab.gradient(kernel);
    }
};

template <class Kernel, class What, int dim, class Real, int width>
void evaluate(benchmark::State& state) {
    using T = Pack<Real, width>;
    std::array<Real, distances> r, w{};
    for (std::size_t k = 0; k < distances; ++k) // from the centre to a little beyond the rim, in no order
        r[k] = static_cast<Real>(1.05e-2 * static_cast<double>(k * 389 % distances) / distances);
    Pair<dim, T> ab{};
    ab.set(SupportRadius(1e-2));
    for (auto _ : state) {
        for (std::size_t k = 0; k < distances; k += width) {
            ab.distance = T::load(r.data() + k);
            const T result = What::of(Kernel{}, ab);
            __builtin_memcpy(w.data() + k, &result, sizeof(T));
        }
        benchmark::DoNotOptimize(w.data());
        benchmark::ClobberMemory();
    }
    bench::per_item(state, "evaluation", distances);
    state.counters["width"] = width;
}

template <class Kernel, class What, int dim, class Real>
void register_widths(const std::string& what) {
    const std::string name = Kernel::name + ("/" + what) + "/" + bench::real_name<Real>;
    benchmark::RegisterBenchmark((name + "/1").c_str(), evaluate<Kernel, What, dim, Real, 1>);
    if constexpr (native_width < Real >> 1)
        benchmark::RegisterBenchmark((name + "/" + std::to_string(native_width<Real>)).c_str(),
                                     evaluate<Kernel, What, dim, Real, native_width<Real>>);
}

template <int dim, class... Kernel>
void register_kernels() {
    (register_widths<Kernel, Value, dim, float>("value"), ...);
    (register_widths<Kernel, Gradient, dim, float>("gradient"), ...);
    (register_widths<Kernel, Value, dim, double>("value"), ...);
    (register_widths<Kernel, Gradient, dim, double>("gradient"), ...);
}

} // namespace

int main(int argc, char** argv) {
    register_kernels<3, CubicSpline, QuinticSpline, WendlandC2, WendlandC4, WendlandC6, Poly6, Spiky,
                     ViscosityKernel>();
    register_kernels<2, ViscosityKernel2D>(); // a kernel of the plane only
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv))
        return 1;
    benchmark::RunSpecifiedBenchmarks();
}
