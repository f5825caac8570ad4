// SPDX-License-Identifier: MIT
// The bytes of a snapshot: numbers from the lowest byte up, whatever the machine, and no padding.
//
// What a snapshot holds is written down once, as functions that hand each number to a stream: ByteWriter, ByteReader or
// ByteCounter. So what is saved, what is loaded and the size of both cannot disagree.
#pragma once

#include "../body/check_body.h"
#include "../body/body_tiles.h"
#include "../shape/surface.h"
#include "../narrow_phase/manifold_record.h"

#include <stddef.h>

namespace ingot { inline namespace INGOT_ABI {

#if INGOT_DOUBLE
using ScalarBits = uint64_t;
#else
using ScalarBits = uint32_t;
#endif

/// Takes numbers, vectors and matrices apart into what a stream knows: unsigned integers. Numbers have names: the bytes do without, host_tests/replay
/// reads them.
template <class Stream>
class NumberStream {
public:
    template <class T>
    INGOT_ALWAYS_INLINE constexpr void operator()(const char*, T& number) {
        (*this)(number);
    }
    /// Of the numbers that follow, all together: what tells one force_field from another with as many numbers.
    static constexpr void name(const char*) {}
    constexpr void operator()(uint8_t& number) { stream().integer(number); }
    constexpr void operator()(uint16_t& number) { stream().integer(number); }
    constexpr void operator()(uint32_t& number) { stream().integer(number); }
    constexpr void operator()(uint64_t& number) { stream().integer(number); }
    /// Of an Index. What none can be is read as more than any capacity.
    constexpr void operator()(int32_t& number) {
        uint32_t bits = static_cast<uint32_t>(number);
        stream().integer(bits);
        number = static_cast<int32_t>(bits < 0x7fffffffu ? bits : 0x7fffffffu);
    }
    constexpr void operator()(scalar& number) { stream().real(number); }
    constexpr void operator()(Vector& v) {
        (*this)(v.x);
        (*this)(v.y);
        (*this)(v.z);
    }
    constexpr void operator()(Matrix& m) {
        (*this)(m.c0);
        (*this)(m.c1);
        (*this)(m.c2);
    }

private:
    constexpr Stream& stream() { return static_cast<Stream&>(*this); }
};

/// Counts the bytes that the others would write or read.
class ByteCounter : public NumberStream<ByteCounter> {
public:
    template <class T>
    constexpr void integer(const T&) { count_ += sizeof(T); }
    constexpr void real(const scalar&) { count_ += sizeof(scalar); }
    constexpr size_t count() const { return count_; }

private:
    size_t count_ = 0;
};

/// Needs: room for all that is written; save_snapshot has counted it.
class ByteWriter : public NumberStream<ByteWriter> {
public:
    explicit ByteWriter(uint8_t* to) : next_(to) {}

    template <class T>
    void integer(T number) {
        for (unsigned byte_i = 0; byte_i < sizeof(T); ++byte_i) *next_++ = static_cast<uint8_t>(number >> (8 * byte_i));
    }
    void real(scalar number) {
        ScalarBits bits;
        INGOT_COPY_BYTES(&bits, &number, sizeof bits);
        integer(bits);
    }
    uint8_t* next() const { return next_; }

private:
    uint8_t* next_;
};

/// Past the end it reads zeros, and says that it did.
class ByteReader : public NumberStream<ByteReader> {
public:
    ByteReader(const uint8_t* from, size_t size) : next_(from), left_(size) {}

    template <class T>
    void integer(T& number) {
        const uint8_t* const from = next_;
        skip(sizeof(T));
        number = 0;
        if (overrun_) return;
        for (unsigned byte_i = 0; byte_i < sizeof(T); ++byte_i)
            number = static_cast<T>(number | static_cast<uint64_t>(from[byte_i]) << (8 * byte_i));
    }
    void real(scalar& number) {
        ScalarBits bits;
        integer(bits);
        INGOT_COPY_BYTES(&number, &bits, sizeof bits);
    }
    void skip(size_t size) {
        overrun_ = overrun_ || size > left_;
        const size_t step = size < left_ ? size : left_;
        next_ += step;
        left_ -= step;
    }
    /// True when exactly all bytes were read.
    bool at_end() const { return left_ == 0 && !overrun_; }

private:
    const uint8_t* next_;
    size_t left_;
    bool overrun_ = false;
};

/// Bits of SnapshotHeader::parts that the records below look at. The others stand at their features.
struct SnapshotPart {
    static constexpr uint32_t doubles = 1, translation = 2, compensation = 4, energy = 8, manifolds = 64, anchors = 128;
    static constexpr uint32_t joints = 1u << 30;
    static constexpr uint32_t locks = 1u << 31;  ///< without joints; with them it stands for their limits
    /// Manifolds are solved point by point: friction has no slow mean. With joints they are not: there it stands for rods, ropes and targets.
    static constexpr uint32_t pointwise = 1u << 20;
    /// Islands may be solved directly. With joints they are not: there it stands for gears.
    static constexpr uint32_t direct = 2048;
};

/// What comes first in a snapshot, whatever its scene.
struct SnapshotHeader {
    uint64_t magic;
    uint16_t format;       ///< of the bytes: snapshot_format
    uint16_t determinism;  ///< INGOT_DETERMINISM_VERSION: what A_low and E_0 mean belongs to it
    uint64_t signature;    ///< of the scene: see scene_signature
    uint32_t length;       ///< bytes in all, checksum included
    uint32_t parts;        ///< which numbers follow: for tools that do not know the scene; see SnapshotPart and Feature::part
    uint32_t field_size;   ///< bytes of the numbers of the force field

    template <class Stream>
    constexpr void numbers(Stream& each) {
        each(magic);
        each(format);
        each(determinism);
        each(signature);
        each(length);
        each(parts);
        each(field_size);
    }
};

/// The bytes 89 'i' 'n' 'g' 'o' 't' 0d 0a: not text, and spoilt by what takes it for text.
inline constexpr uint64_t snapshot_magic = 0x0a0d746f676e6989u;
/// Raised whenever the bytes after the header get another meaning.
inline constexpr uint16_t snapshot_format = 3;
inline constexpr size_t snapshot_checksum_size = 8;

constexpr size_t snapshot_header_size() {
    ByteCounter counter;
    SnapshotHeader header{};
    header.numbers(counter);
    return counter.count();
}

/// The state of one living body. omega, inv_I_world and the bounding radius are derived, and made anew.
struct SavedBody {
    static constexpr uint8_t kicked = 1, frozen = 2;  ///< flags

    uint8_t flags;
    Matrix A, A_low;
    Vector L, tau_T, inv_I_ratio, r_CM, v_CM, F_T;
    scalar inv_I_scale, inv_M, E_0;

    template <class Stream>
    constexpr void numbers(Stream& each, uint32_t parts) {
        each("flags", flags);
        each("A", A);
        each("L", L);
        each("tau_T", tau_T);
        each("inv_I_ratio", inv_I_ratio);
        each("inv_I_scale", inv_I_scale);
        if ((parts & SnapshotPart::compensation) != 0) each("A_low", A_low);
        if ((parts & SnapshotPart::energy) != 0) each("E_0", E_0);
        if ((parts & SnapshotPart::translation) == 0) return;
        each("r_CM", r_CM);
        each("v_CM", v_CM);
        each("F_T", F_T);
        each("inv_M", inv_M);
    }
};

/// Shape and material of one living body, in scenes with contacts.
struct SavedSurface {
    uint8_t kind;
    Vector size;
    scalar offset, e, mu;

    template <class Stream>
    constexpr void numbers(Stream& each) {
        each("shape.kind", kind);
        each("shape.size", size);
        each("shape.offset", offset);
        each("restitution", e);
        each("friction", mu);
    }
};
constexpr Shape shape_of(const SavedSurface& surface) { return {static_cast<ShapeKind>(surface.kind), surface.size, surface.offset}; }

/// Whether one living body sleeps, in scenes with sleep. Its island is known from the manifolds. Who is due is told from who is not: a
/// manifold that was found at rest and is then renewed from its anchors is the same but for rounding, and not to the bit.
struct SavedRest {
    uint8_t awake;  ///< 0: at rest, and its manifolds are kept; 1: awake; 2: at rest and due, see island/rest_view.h
    scalar rest_time;

    template <class Stream>
    constexpr void numbers(Stream& each) {
        each("awake", awake);
        each("rest_time", rest_time);
    }
};

/// What is kept of two bodies that touch, in scenes with manifolds.
struct SavedManifold {
    Index body_A, body_B;
    ManifoldRecord record;
    Vector j_reference;
    ManifoldAnchors anchors;

    template <class Stream>
    constexpr void numbers(Stream& each, uint32_t parts) {
        each("body_A", body_A);
        each("body_B", body_B);
        // How many, and above them the material of a level.
        auto points = static_cast<uint16_t>(record.manifold.count | record.manifold.material << 8);
        each("points", points);
        record.manifold.count = static_cast<int8_t>(points & 255);
        record.manifold.material = static_cast<uint8_t>(points >> 8);
        each("n", record.manifold.n);
        for (int point_i = 0; point_i < Manifold::points_max; ++point_i) {
            ManifoldPoint& point = record.manifold.points[point_i];
            each("P", point.P);
            each("separation", point.separation);
            each("feature", point.feature);
            each("j", record.j[point_i]);
            each("j_before", record.j_before[point_i]);
        }
        each("mu", record.mu);
        each("e", record.e);
        each("j_friction", record.j_friction);
        if ((parts & (SnapshotPart::pointwise | SnapshotPart::joints)) != SnapshotPart::pointwise) each("j_reference", j_reference);
        each("j_torsion", record.j_torsion);
        each("substeps", record.substeps);
        if ((parts & SnapshotPart::anchors) == 0) return;
        for (int axis = 0; axis < 3; ++axis) {
            for (scalar& number : anchors.on_A[axis]) each("on_A", number);
            for (scalar& number : anchors.on_B[axis]) each("on_B", number);
        }
        for (scalar& number : anchors.separation) each("found_at", number);
        each("n_A", anchors.n_A);
        each("n_B", anchors.n_B);
        each("margin", anchors.margin);
    }
};

/// A pair in bytes, to be sorted where the snapshot is written.
struct PairBytes {
    static constexpr int size = sizeof(Index);
    uint8_t bytes[3 * size];

    Index number(int number_i) const {
        uint32_t value = 0;
        for (int byte_i = 0; byte_i < size; ++byte_i) value = value << 8 | bytes[number_i * size + byte_i];  // bound: 4
        return static_cast<Index>(value);
    }
    PairKey key() const { return key_of(number(0), number(1)); }
    BodyPair pair() const { return {number(0), number(1), number(2)}; }
};
constexpr PairBytes bytes_of(const BodyPair& pair) {
    PairBytes all{};
    const Index numbers[3] = {pair.body_A, pair.body_B, pair.record};
    for (int i = 0; i < 3 * PairBytes::size; ++i)  // bound: 12; the highest byte of a number first
        all.bytes[i] = static_cast<uint8_t>(numbers[i / PairBytes::size] >> 8 * (PairBytes::size - 1 - i % PairBytes::size) & 0xff);
    return all;
}

/// 64 bits. A change within the eight bytes of one round, so of any one byte, always changes it: each round maps both what came
/// before and its eight bytes one to one. Cost: a multiplication for eight bytes.
uint64_t snapshot_checksum(const uint8_t* bytes, size_t size);

/// Everything that can be told without the scene's storage.
/// Errors: bad_snapshot (magic, length, checksum), other_version, other_scene.
Status check_snapshot_envelope(const uint8_t* bytes, size_t size, const SnapshotHeader& expected);

SavedBody saved_body(const BodyView& bodies, int slot);
void write_saved_body(const BodyView& bodies, int slot, const SavedBody& body);

/// True for a rotation as the kernel keeps it: see limits::orthogonality_kept.
bool is_kept_rotation(const Matrix& A);
/// True for what the body of a world can have become: numbers finite and within their ranges, A a rotation, the moments those
/// of a solid; an immovable or frozen body without motion and forces.
bool is_valid(const SavedBody& body, bool translates);
/// True for what a body can have become whose scene falls asleep after sleep_time, s: one at rest has no motion and no forces.
bool is_valid(const SavedRest& saved, const SavedBody& body, scalar sleep_time);
/// True for what World::add takes. can_move: a half space cannot.
bool is_valid(const SavedSurface& surface, bool can_move);
/// True for what two bodies of those slots can have become. Slots are looked at by the caller.
bool is_valid(const SavedManifold& saved);

} }  // namespace ingot
