// SPDX-License-Identifier: MIT
// A world and its snapshot, whose numbers are known by name: what is wrong with one of them is refused, and changes no bit of the world.
#pragma once

#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <string>

#include "replay/snapshot_fields.h"
#include "snapshot/life.h"

namespace life {

using Bytes = std::vector<uint8_t>;

/// A world, its snapshot, and the names and places of the numbers in that.
template <class S>
struct Sound {
    std::unique_ptr<World<S>> world{new World<S>};
    Bytes bytes;
    std::vector<replay::SnapshotField> fields;

    void keep() {
        bytes = saved(*world);
        replay::SnapshotFields read;
        ASSERT_EQ(replay::read_fields(bytes, read), "");
        fields = read.fields;
    }
    /// The n-th of this name that a body has; -1: that the world has.
    const replay::SnapshotField& field(int slot, const std::string& name, int nth = 0) const {
        for (const auto& one : fields)
            if (one.slot == slot && one.name == name && nth-- == 0) return one;
        ADD_FAILURE() << "no " << name << " of " << slot;
        return fields.front();
    }
    Bytes with(const replay::SnapshotField& field, uint64_t bits) const { return sealed(put(bytes, field.offset, bits, field.size)); }
    Bytes with_real(const replay::SnapshotField& field, scalar number) const {
        ingot::ScalarBits bits;
        memcpy(&bits, &number, sizeof bits);
        return with(field, bits);
    }
    static Bytes put(Bytes to, size_t offset, uint64_t bits, unsigned size) {
        for (unsigned byte_i = 0; byte_i < size; ++byte_i) to[offset + byte_i] = static_cast<uint8_t>(bits >> (8 * byte_i));
        return to;
    }
    static Bytes sealed(Bytes to) {
        const size_t end = to.size() - ingot::snapshot_checksum_size;
        return put(to, end, ingot::snapshot_checksum(to.data(), end), 8);
    }

    void refuses(const Bytes& damaged, const std::string& what) const {
        const auto victim = std::make_unique<World<S>>();
        copy(*victim, *world);
        EXPECT_EQ(ingot::load_snapshot(*victim, damaged.data(), damaged.size()), Status::bad_snapshot) << what;
        EXPECT_TRUE(same_bytes(*victim, *world)) << what << " changed the world";
    }
    void accepts(const Bytes& other, const std::string& what) const {
        const auto loaded = std::make_unique<World<S>>();
        EXPECT_EQ(ingot::load_snapshot(*loaded, other.data(), other.size()), Status::ok) << what;
        EXPECT_EQ(saved(*loaded), other) << what;
    }
    /// No number of a snapshot may be other than finite.
    void refuses_what_is_not_finite() const {
        for (const auto& one : fields)
            for (const scalar bad : {std::numeric_limits<scalar>::quiet_NaN(), std::numeric_limits<scalar>::infinity()})
                if (one.is_real) refuses(with_real(one, bad), one.name + " of " + std::to_string(one.slot));
    }
};

}  // namespace life
