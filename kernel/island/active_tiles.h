// SPDX-License-Identifier: MIT
// Which tiles a step has to look at, in scenes that name `sleeps`.
#pragma once

#include "../base/config.h"

namespace ingot { inline namespace INGOT_ABI {

/// Tiles with a body that is awake or settling, as two levels of bits: a bit a tile, and a bit for each word of those that is not zero. So a step
/// finds them in their order without looking at the others. Cost of a walk: a few instructions a tile that is active, and one look for every 1024
/// that are not.
struct ActiveTiles {
    static constexpr int bits_of_word = 32;
    static constexpr int words_for(int bits) { return (bits + bits_of_word - 1) / bits_of_word; }

    uint32_t* tile_bits;  ///< a bit a tile
    uint32_t* word_bits;  ///< a bit a word of tiles
    int word_count;       ///< of words

    void add(int tile_i) const {
        const int word_i = tile_i / bits_of_word;
        tile_bits[word_i] |= 1u << tile_i % bits_of_word;
        word_bits[word_i / bits_of_word] |= 1u << word_i % bits_of_word;
    }
    void drop(int tile_i) const {
        const int word_i = tile_i / bits_of_word;
        tile_bits[word_i] &= ~(1u << tile_i % bits_of_word);
        if (tile_bits[word_i] == 0) word_bits[word_i / bits_of_word] &= ~(1u << word_i % bits_of_word);
    }
    bool any() const {
        uint32_t all = 0;
        // bound: max_bodies / lanes / 1024, rounded up
        for (int i = 0; i < word_count; ++i) all |= word_bits[i];
        return all != 0;
    }
    /// Calls each(tile_i) in the order of tiles. It may drop the tile it is called for.
    template <class Each>
    INGOT_INLINE void for_each(const Each& each) const {
        for (int i = 0; i < word_count; ++i) {
            // bound: 32: a bit falls out each turn
            for (uint32_t some = word_bits[i]; some != 0; some &= some - 1) {
                const int word_i = i * bits_of_word + INGOT_LOWEST_BIT(some);
                // bound: 32: a bit falls out each turn
                for (uint32_t bits = tile_bits[word_i]; bits != 0; bits &= bits - 1) each(word_i * bits_of_word + INGOT_LOWEST_BIT(bits));
            }
        }
    }
};

} }  // namespace ingot
