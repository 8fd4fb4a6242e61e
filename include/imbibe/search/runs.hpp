// The neighbours of every particle as *runs*: stretches of at most one SIMD width of consecutive particles in the order
// sorted by cell. A pair loop loads a run with one plain load per number and masks the lanes beyond its count.
#pragma once

#include <imbibe/core/build_options.hpp>
#include <imbibe/core/memory.hpp>
#include <imbibe/core/compiler_hints.hpp>

#include <bit>
#include <cstdint>
#include <vector>

namespace imbibe::search {

/// One to 16 consecutive neighbours, or a mark behind runs that are seen through a periodic image, in 4 bytes, because
/// lists are most of a step's memory traffic.
///
/// A particle without neighbours through images has its runs and no mark. Otherwise the runs seen through no image come
/// first, and after all runs seen through the same image stands its mark (image 0: none).
class Run {
public:
    /// The greatest number of neighbours in a run.
    static constexpr std::uint32_t most_neighbours = 16;
    /// The greatest number of particles in a phase: 28 bits hold their numbers and the 27 marks.
    static constexpr std::uint32_t most_particles = (std::uint32_t{1} << 28) - 27;

    /// Uninitialised.
    Run() = default;
    /// `count` neighbours from `first` on, which is below `most_particles`.
    Run(std::uint32_t first, std::uint32_t count) : bits(first - (count << 28)) {}
    /// The mark of a periodic image.
    static Run mark_of(int image) { return {most_particles + static_cast<std::uint32_t>(image), 1}; }

    /// The first neighbour, in the sorted order.
    std::size_t first() const { return bits & ~(~std::uint32_t{0} << 28); }
    /// How many there are.
    std::size_t count() const { return most_neighbours - std::size_t{bits >> 28}; }
    /// Is it a mark?
    bool is_mark() const { return bits >= mark_of(0).bits; }
    /// The periodic image of a mark.
    int image() const { return static_cast<int>(bits - mark_of(0).bits); }
    /// The next mark, or this one if it is a mark. A call of a pure function: with the loop inlined, g++ would not know
    /// that the code behind it is ever reached, and would no longer hoist loop-invariant values out of the loop over
    /// particles.
    [[gnu::pure, gnu::noinline]] const Run* mark() const {
        const Run* run = this;
        while (!run->is_mark())
            ++run;
        return run;
    }
    /// The same run, or the same mark.
    friend bool operator==(Run, Run) = default;

private:
    std::uint32_t bits; ///< in the upper four bits, 16 less the number of neighbours; below them the first
};

/// The runs of all particles of one phase in another (or the same) phase. Kept in blocks of particles so that threads
/// build and read them independently. Memory is reused from step to step, unless the number of particles changes so
/// much that another block size is better.
class IMBIBE_PER_BUILD RunList {
public:
    /// The runs of one block of particles.
    using Block = AlignedVector<Run>;
    /// Every block begins at a multiple of this number of particles.
    static constexpr int smallest_block = 256;

    /// The runs and marks of one particle. A plain loop over it sees the marks too; `for_each` does not.
    struct Range {
        /// The first.
        const Run* begin_;
        /// One past the last.
        const Run* end_;
        /// The first.
        const Run* begin() const { return begin_; }
        /// One past the last.
        const Run* end() const { return end_; }
        /// Is there none?
        bool is_empty() const { return begin_ == end_; }

        /// Calls use(begin, end, image) for the runs from `begin` to `end` that are seen through one periodic image,
        /// for every image with runs. There must be a run.
        template <class Use>
        IMBIBE_INLINE void for_each_image(const Use& use) const {
            const bool marked = end_[-1].is_mark();
            const Run* run = begin_;
            do {
                const Run* const end = marked ? run->mark() : end_;
                use(run, end, marked ? end->image() : 0);
                run = end + 1;
            } while (marked && run != end_);
        }
        /// Calls use(run, image) for every run.
        template <class Use>
        void for_each(const Use& use) const {
            if (!is_empty())
                for_each_image([&](const Run* run, const Run* end, int image) {
                    for (; run != end; ++run)
                        use(*run, image);
                });
        }
    };

    /// Makes room for n particles. A block keeps its memory; `finish` says how much of it is used.
    /// @param n how many particles
    /// @param threads how many will share the blocks: at least 8 blocks for each, of more than `smallest_block`
    void resize(int n, int threads) {
        // The longer a block is, the fewer pages of memory it lies in.
        const int enough = threads > 8 ? 8 * threads : 64, now = n / block_size();
        if (now >= 4 * enough || (now < enough && block_size() > smallest_block)) {
            int size = smallest_block;
            while (n / size >= 2 * enough)
                size *= 2;
            blocks.clear();
            block_bits = std::countr_zero(static_cast<unsigned>(size));
        }
        resize_in_blocks(n);
    }
    /// Makes lists without neighbours for n particles.
    void clear_all(int n) {
        resize_in_blocks(n);
        for (auto& e : ends)
            e = 0;
        nothing = true;
    }
    /// How many particles.
    int size() const { return particles; }
    /// Particles in a block: the more there are, the larger.
    int block_size() const { return 1 << block_bits; }
    /// How many blocks.
    int block_count() const { return static_cast<int>(blocks.size()); }
    /// The runs of block b, to fill.
    Block& block(int b) { return blocks[static_cast<std::size_t>(b)]; }
    /// Says that the runs of particle i end at `end` in its block, where those of the next one begin.
    void finish(int i, std::uint32_t end) { ends[static_cast<std::size_t>(i)] = end; }
    /// Says that all runs are there.
    void finish() {
        nothing = true;
        for (int end = 0; nothing && end < particles;) {
            end = particles - end > block_size() ? end + block_size() : particles;
            nothing = ends[static_cast<std::size_t>(end - 1)] == 0;
        }
    }
    /// The runs of particle i.
    Range operator[](int i) const {
        const auto k = static_cast<std::size_t>(i);
        const Run* base = blocks[k >> block_bits].data();
        return {base + (k == k >> block_bits << block_bits ? 0 : ends[k - 1]), base + ends[k]};
    }
    /// The runs of particles of one block, one particle after the other.
    class Walk {
    public:
        /// Of the block of particle `first`, from there on.
        Walk(const RunList& list, int first)
            : base(list.blocks[static_cast<std::size_t>(first) >> list.block_bits].data()), here(list[first].begin_),
              ends(list.ends.data() + first) {}
        /// Those of the next particle, of the same block.
        Range next() {
            const Run* const from = here;
            here = base + *ends++;
            return {from, here};
        }

    private:
        const Run *base, *here;
        const std::uint32_t* ends;
    };

    /// Bytes held for particles, for reports.
    std::size_t bytes() const {
        std::size_t sum = ends.capacity() * sizeof(std::uint32_t);
        for (const auto& b : blocks)
            sum += b.capacity() * sizeof(Run);
        return sum;
    }
    /// Has no particle a neighbour?
    bool is_empty() const { return nothing; }

private:
    int particles = 0;
    int block_bits = std::countr_zero(static_cast<unsigned>(smallest_block)); ///< a block is 2^block_bits particles
    bool nothing = true;
    std::vector<Block> blocks;
    AlignedVector<std::uint32_t> ends;

    void resize_in_blocks(int n) {
        particles = n;
        nothing = n == 0;
        blocks.resize(static_cast<std::size_t>(n / block_size() + (n % block_size() != 0)));
        ends.resize(static_cast<std::size_t>(n));
    }
};

} // namespace imbibe::search
