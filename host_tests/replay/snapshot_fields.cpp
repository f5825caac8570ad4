// SPDX-License-Identifier: MIT
// What stands where is the kernel's own account of it, feature by feature: here nothing of it is written down again.
#include "replay/snapshot_fields.h"

#include <ingot/world/snapshot.h>

#include <cstring>
#include <type_traits>

namespace replay {

namespace {

/// Takes the fields off the bytes one by one, under the names that the kernel gives its numbers. Reals are as wide as the snapshot says.
class Reader {
public:
    Reader(const std::vector<uint8_t>& bytes, size_t from, size_t to, SnapshotFields& into)
        : begin_(bytes.data()), next_(begin_ + from), end_(begin_ + to), into_(into) {}

    void at_slot(int slot) { slot_ = slot; }

    template <class T, class = std::enable_if_t<std::is_unsigned_v<T>>>
    void operator()(const char* name, T& number) {
        number = static_cast<T>(add(name, sizeof number, false));
    }
    void operator()(const std::string& name, ingot::scalar&) { (void)add(name, into_.doubles ? 8 : 4, true); }
    void operator()(const std::string& name, ingot::Vector& v) {
        (*this)(name + ".x", v.x);
        (*this)(name + ".y", v.y);
        (*this)(name + ".z", v.z);
    }
    void operator()(const std::string& name, ingot::Matrix& m) {
        (*this)(name + ".c0", m.c0);
        (*this)(name + ".c1", m.c1);
        (*this)(name + ".c2", m.c2);
    }
    bool at_end() const { return next_ == end_ && !overrun_; }
    bool overrun() const { return overrun_; }

private:
    uint64_t add(const std::string& name, unsigned size, bool is_real) {
        overrun_ = overrun_ || static_cast<size_t>(end_ - next_) < size;
        const size_t offset = static_cast<size_t>(next_ - begin_);
        uint64_t bits = 0;
        for (unsigned byte_i = 0; byte_i < size && !overrun_; ++byte_i) bits |= static_cast<uint64_t>(*next_++) << (8 * byte_i);
        SnapshotField field;
        field.slot = slot_;
        field.name = name;
        field.is_real = is_real;
        field.bits = bits;
        field.offset = offset;
        field.size = size;
        into_.fields.push_back(field);
        return bits;
    }

    const uint8_t* const begin_;
    const uint8_t* next_;
    const uint8_t* const end_;
    SnapshotFields& into_;
    int slot_ = -1;
    bool overrun_ = false;
};

bool has(uint32_t parts, uint32_t part) { return (parts & part) != 0; }

/// The numbers of all features of the parts that stand in one place.
template <class Level>
void read_numbers(Reader& in, uint32_t parts) {
    ingot::features::All::over_all([&](auto feature) {
        typename Level::template Numbers<decltype(feature)> numbers{};
        if (has(parts, decltype(feature)::part)) numbers.numbers(in, parts);
    });
}

void read_body(Reader& in, uint32_t parts) {
    ingot::SavedBody body{};
    body.numbers(in, parts);
    uint8_t shape_count = 1;
    if (has(parts, ingot::features::Compounds::part)) in("shapes", shape_count);
    for (int shape_i = 0; shape_i < shape_count; ++shape_i) read_numbers<ingot::OfShape>(in, parts);
    read_numbers<ingot::OfBody>(in, parts);
}

}  // namespace

double SnapshotField::value(bool doubles) const {
    if (!is_real) return static_cast<double>(bits);
    if (doubles) {
        double number;
        std::memcpy(&number, &bits, sizeof number);
        return number;
    }
    const auto low = static_cast<uint32_t>(bits);
    float number;
    std::memcpy(&number, &low, sizeof number);
    return number;
}

std::string read_fields(const std::vector<uint8_t>& bytes, SnapshotFields& snapshot) {
    const size_t header_size = ingot::snapshot_header_size(), checksum_size = ingot::snapshot_checksum_size;
    if (bytes.size() < header_size + checksum_size) return "too short for a snapshot";
    ingot::SnapshotHeader header{};
    ingot::ByteReader of_header(bytes.data(), bytes.size());
    header.numbers(of_header);
    if (header.magic != ingot::snapshot_magic || header.length != bytes.size()) return "not a snapshot";
    if (header.format != ingot::snapshot_format) return "a snapshot of another format";

    snapshot = {};
    const uint32_t parts = header.parts;
    snapshot.doubles = has(parts, ingot::SnapshotPart::doubles);
    snapshot.signature = header.signature;
    Reader in(bytes, header_size, bytes.size() - checksum_size, snapshot);
    ingot::SavedWorld whole{};
    whole.numbers(in);
    read_numbers<ingot::OfWorld>(in, parts);
    uint8_t byte_of_field = 0;
    for (uint32_t byte_i = 0; byte_i < header.field_size && !in.overrun(); ++byte_i) in("force_field", byte_of_field);
    for (uint32_t slot = 0; slot < whole.slots_used && !in.overrun(); ++slot) {
        in.at_slot(static_cast<int>(slot));
        uint32_t generation = 0;
        in("generation", generation);
        if (generation % 2 == 1) read_body(in, parts);
    }
    in.at_slot(-1);
    ingot::Index manifolds = 0;
    if (has(parts, ingot::features::Manifolds::part)) in("manifolds", manifolds);
    for (int manifold_i = 0; manifold_i < manifolds && !in.overrun(); ++manifold_i) read_numbers<ingot::OfManifold>(in, parts);
    ingot::features::All::over_all([&](auto feature) {
        using F = decltype(feature);
        ingot::Index entries = 0;
        if (F::has_entries && has(parts, F::part)) in("entries", entries);
        typename F::OfEntry entry{};
        for (int entry_i = 0; entry_i < entries && !in.overrun(); ++entry_i) entry.numbers(in, parts);
    });
    return in.at_end() ? "" : "a snapshot whose counts do not fit its length";
}

}  // namespace replay
