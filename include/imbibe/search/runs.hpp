// The neighbours of every particle as *runs*: stretches of at most one SIMD width of consecutive particles in the
// order sorted by cell. A pair loop loads a run with one plain load per number and masks what is beyond its count.
#pragma once

#include <imbibe/core/build_options.hpp>
#include <imbibe/core/memory.hpp>

#include <bit>
#include <cstdint>
#include <vector>

namespace imbibe::search {

/// `count` consecutive neighbours from `first` on, seen through periodic image `shift` (0: none). Of a particle's runs
/// those that are seen through none come first.
struct Run {
    std::uint32_t first; ///< in the sorted order
    std::uint16_t count; ///< how many
    std::uint16_t shift; ///< the number of the periodic image; 0: none
};

/// The runs of all particles of one phase in one other (or the same) phase. Kept in blocks of particles so that
/// threads build and read them independently. Memory is reused from step to step, but where particles become so many
/// more or fewer that blocks of another size are better.
class IMBIBE_PER_BUILD RunList {
public:
    /// The runs of one block of particles.
    using Block = AlignedVector<Run>;
    /// Every block begins at a multiple of so many particles.
    static constexpr int smallest_block = 256;

    /// The runs of one particle, to loop over.
    struct Range {
        /// The first.
        const Run* begin_;
        /// One past the last.
        const Run* end_;
        /// The first.
        const Run* begin() const { return begin_; }
        /// One past the last.
        const Run* end() const { return end_; }
    };

    /// Makes room for n particles. A block keeps the memory it once had; how much of it is used, `finish` says.
    /// @param n how many particles
    /// @param threads how many will share the blocks: 8 blocks for each, at least, of more than `smallest_block`
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
    /// No particle has a neighbour.
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
