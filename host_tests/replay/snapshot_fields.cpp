// SPDX-License-Identifier: MIT
#include "replay/snapshot_fields.h"

#include <ingot/world/snapshot_bytes.h>

#include <cstring>

namespace replay {

namespace {

/// Takes the fields off the bytes one by one, under the name of what they belong to.
class Reader {
public:
    Reader(const std::vector<uint8_t>& bytes, size_t from, size_t to, SnapshotFields& into)
        : begin_(bytes.data()), next_(begin_ + from), end_(begin_ + to), into_(into) {}

    void at_slot(int slot) { slot_ = slot; }

    uint64_t integer(const char* name, unsigned size) { return add(name, size, false); }
    void real(const std::string& name) { (void)add(name, into_.doubles ? 8 : 4, true); }
    void vector(const std::string& name) {
        for (const char* axis : {".x", ".y", ".z"}) real(name + axis);
    }
    void matrix(const std::string& name) {
        for (const char* column : {".c0", ".c1", ".c2"}) vector(name + column);
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

using Part = ingot::SnapshotPart;

void read_material(Reader& in, unsigned parts) {
    if ((parts & Part::rolling) != 0) in.real("rolling_resistance");
    if ((parts & Part::belts) != 0) in.vector("surface_velocity");
}

void read_body(Reader& in, unsigned parts) {
    (void)in.integer("flags", 1);
    in.matrix("A");
    in.vector("L");
    in.vector("tau_T");
    in.vector("inv_I_ratio");
    in.real("inv_I_scale");
    if ((parts & Part::compensation) != 0) in.matrix("A_low");
    if ((parts & Part::energy) != 0) in.real("E_0");
    if ((parts & Part::translation) != 0) {
        in.vector("r_CM");
        in.vector("v_CM");
        in.vector("F_T");
        in.real("inv_M");
    }
    const bool several = (parts & Part::compounds) != 0;
    const uint64_t shape_count = several ? in.integer("shapes", 1) : (parts & Part::surfaces) != 0 ? 1 : 0;
    for (uint64_t shape_i = 0; shape_i < shape_count; ++shape_i) {
        (void)in.integer("shape.kind", 1);
        in.vector("shape.size");
        in.real("shape.offset");
        in.real("restitution");
        in.real("friction");
        if (!several) read_material(in, parts);
        if (!several) continue;
        in.vector("shape.r");
        in.matrix("shape.A");
        if ((parts & Part::sensors) != 0) (void)in.integer("sensor", 1);
        read_material(in, parts);
    }
    if ((parts & Part::filters) != 0) {
        (void)in.integer("filter.category", 4);
        (void)in.integer("filter.mask", 4);
    }
    if ((parts & Part::sensors) != 0 && !several) (void)in.integer("sensor", 1);
    if ((parts & Part::sleep) != 0) {
        (void)in.integer("awake", 1);
        in.real("rest_time");
    }
}

void read_anchors(Reader& in) {
    for (int axis = 0; axis < 3; ++axis) {
        for (int point_i = 0; point_i < ingot::Manifold::points_max; ++point_i) in.real("on_A");
        for (int point_i = 0; point_i < ingot::Manifold::points_max; ++point_i) in.real("on_B");
    }
    for (int point_i = 0; point_i < ingot::Manifold::points_max; ++point_i) in.real("found_at");
    in.vector("n_A");
    in.vector("n_B");
    in.real("margin");
}

void read_manifold(Reader& in, uint16_t parts) {
    (void)in.integer("body_A", 2);
    (void)in.integer("body_B", 2);
    (void)in.integer("points", 2);
    in.vector("n");
    for (int point_i = 0; point_i < ingot::Manifold::points_max; ++point_i) {
        in.vector("P");
        in.real("separation");
        (void)in.integer("feature", 4);
        in.real("j");
        in.real("j_before");
    }
    in.real("mu");
    in.real("e");
    in.vector("j_friction");
    in.vector("j_reference");
    in.real("j_torsion");
    (void)in.integer("substeps", 2);
    if ((parts & Part::anchors) != 0) read_anchors(in);
    if ((parts & Part::unsettled) != 0) (void)in.integer("unsettled", 1);
    if ((parts & Part::rolling) != 0) in.vector("j_rolling");
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
    snapshot.doubles = (header.parts & Part::doubles) != 0;
    snapshot.signature = header.signature;
    Reader in(bytes, header_size, bytes.size() - checksum_size, snapshot);
    (void)in.integer("world_tag", 2);
    (void)in.integer("steps", 4);
    const uint64_t slots_used = in.integer("slots_used", 4);
    (void)in.integer("free_hint", 4);
    if ((header.parts & Part::translation) != 0) in.vector("gravity");
    if ((header.parts & Part::energy) != 0) in.real("h_before");
    if ((header.parts & Part::field) != 0) {
        in.real("t");
        in.real("t_low");
        for (uint32_t byte_i = 0; byte_i < header.field_size && !in.overrun(); ++byte_i) (void)in.integer("force_field", 1);
    }
    for (uint64_t slot = 0; slot < slots_used && !in.overrun(); ++slot) {
        in.at_slot(static_cast<int>(slot));
        if (in.integer("generation", 4) % 2 == 1) read_body(in, header.parts);
    }
    if ((header.parts & Part::manifolds) != 0) {
        in.at_slot(-1);
        const uint64_t manifolds = in.integer("manifolds", 2);
        for (uint64_t manifold_i = 0; manifold_i < manifolds && !in.overrun(); ++manifold_i) read_manifold(in, header.parts);
    }
    return in.at_end() ? "" : "a snapshot whose counts do not fit its length";
}

}  // namespace replay
