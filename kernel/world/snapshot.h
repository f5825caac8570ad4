// SPDX-License-Identifier: MIT
// Two ways to keep a world, and to go on from there as if it had never been left, to the bit.
//
// memcpy of the whole object, for the same program on the same machine: a world holds no pointer. The fastest, and what
// rollback within one process wants. It checks nothing.
//
// save_snapshot and load_snapshot, for files and for other machines: the same bytes for every lane count, compiler and order of
// bytes in memory, checked by a checksum and then number by number. For worlds of one scalar and one scene.
//
// The bytes: SnapshotHeader; the world; each slot, and what lives in it; manifolds; lists; a checksum. Features say what stands in each of them: see
// features/feature.h.
#pragma once

#include "../base/version.h"
#include "../body/freeze_bad_bodies.h"
#include "signature.h"
#include "snapshot_bytes.h"
#include "world.h"

namespace ingot { inline namespace INGOT_ABI {

/// Where numbers of a feature stand in a snapshot.
struct OfWorld {
    template <class F>
    using Numbers = typename F::OfWorld;
};
struct OfBody {
    template <class F>
    using Numbers = typename F::OfBody;
};
struct OfShape {
    template <class F>
    using Numbers = typename F::OfShape;
};
struct OfManifold {
    template <class F>
    using Numbers = typename F::OfManifold;
};
struct OfEntry {
    template <class F>
    using Numbers = typename F::OfEntry;
};

template <class S>
constexpr uint32_t snapshot_parts() {
    uint32_t parts = sizeof(scalar) == sizeof(double) ? SnapshotPart::doubles : 0;
    if (stacks<S> && S::recycles_manifolds) parts |= SnapshotPart::anchors;
    if (stacks<S> && solves_pointwise<S>) parts |= SnapshotPart::pointwise;
    if (S::axis_locks) parts |= SnapshotPart::locks;
    if (has_gears<S>) parts |= features::JointPart::gears;
    features::All::over_named<S>([&parts](auto feature) { parts |= decltype(feature)::part; });
    return parts;
}

/// Bytes of the numbers that stand in one place, of all features that the scene names.
template <class Level, class S>
constexpr size_t saved_size() {
    ByteCounter counter;
    features::All::over_named<S>([&counter](auto feature) {
        typename Level::template Numbers<decltype(feature)> saved{};
        saved.numbers(counter, snapshot_parts<S>());
    });
    return counter.count();
}
/// They themselves; where: see NoNumbers.
template <class Level, class S, class... Where>
void write_numbers(ByteWriter& writer, const Storage<S>& storage, const Where&... where) {
    features::All::over_named<S>([&](auto feature) {
        typename Level::template Numbers<decltype(feature)> saved{};
        saved.take(storage, where...);
        saved.numbers(writer, snapshot_parts<S>());
    });
}
/// And back; context: see NoNumbers. Without storage it only checks.
template <class Level, class S, class Context, class... Where>
Status read_numbers(ByteReader& reader, Storage<S>* to, Context& context, const Where&... where) {
    bool sound = true;
    features::All::over_named<S>([&](auto feature) {
        typename Level::template Numbers<decltype(feature)> saved{};
        saved.numbers(reader, snapshot_parts<S>());
        sound = sound && saved.template is_valid<S>(context);
        if (to != nullptr) saved.put(*to, where...);
    });
    return sound ? Status::ok : Status::bad_snapshot;
}

/// Sizes in bytes, counted by the functions that write.
template <class S>
constexpr size_t saved_field_size() {
    ByteCounter counter;
    if constexpr (has_field<S>) {
        static_assert(features::names_its_numbers<typename S::force_field>,
                      "a snapshot holds the numbers of the force_field: give it a function numbers, see motion/force_field.h");
        typename S::force_field field{};
        field.numbers(counter);
    }
    return counter.count();
}
template <class S>
constexpr size_t saved_body_size() {
    ByteCounter counter;
    SavedBody body{};
    body.numbers(counter, snapshot_parts<S>());
    return counter.count() + (has_compounds<S> ? sizeof(uint8_t) : 0) + saved_size<OfBody, S>();
}
/// Of one list: a count, and its entries.
template <class S, class Feature>
constexpr size_t saved_list_size(int count) {
    if (!Feature::has_entries) return 0;
    ByteCounter counter;
    typename Feature::OfEntry entry{};
    entry.numbers(counter, snapshot_parts<S>());
    return sizeof(Index) + static_cast<size_t>(count) * counter.count();
}
/// Without lists.
template <class S>
constexpr size_t snapshot_size_of(size_t slots_used, size_t living, size_t shapes, size_t manifolds) {
    ByteCounter counter;
    SavedWorld world{};
    world.numbers(counter);
    return snapshot_header_size() + counter.count() + saved_size<OfWorld, S>() + saved_field_size<S>() + slots_used * sizeof(uint32_t) +
           living * saved_body_size<S>() + shapes * saved_size<OfShape, S>() +
           (stacks<S> ? sizeof(Index) + manifolds * saved_size<OfManifold, S>() : 0) + snapshot_checksum_size;
}

/// Bytes that a snapshot of any world of the scene fits in: that of a full one.
template <class S>
constexpr size_t snapshot_size() {
    size_t lists = 0;
    features::All::over_named<S>([&lists](auto feature) {
        using F = decltype(feature);
        lists += saved_list_size<S, F>(F::template entry_capacity<S>);
    });
    return lists + snapshot_size_of<S>(static_cast<size_t>(S::max_bodies), static_cast<size_t>(S::max_bodies),
                                       static_cast<size_t>(shape_capacity<S>), static_cast<size_t>(S::max_manifolds));
}

/// Of the traits of one feature.
template <class S, class Feature>
constexpr uint64_t traits_signature() {
    Signature signature;
    Feature::template traits<S>(signature);
    return signature.hash();
}

/// A number for all that makes snapshots of two scenes differ in their bytes or in the steps that follow: the scalar and every trait, lengths, speeds
/// and times to a nano of their unit; of a force_field the names and kinds of its numbers.
///
/// A feature of which a scene says no more than Scene does adds nothing: so the snapshots of a scene are not refused because a new trait exists.
template <class S>
constexpr uint64_t scene_signature() {
    Signature signature;
    signature(snapshot_parts<S>());
    if (INGOT_INDEX_BITS != 16) signature(INGOT_INDEX_BITS);
    int number = 0;
    features::All::over_all([&](auto feature) {
        using F = decltype(feature);
        ++number;
        if (traits_signature<S, F>() == traits_signature<Scene, F>()) return;
        signature(number);
        signature(traits_signature<S, F>());
    });
    return signature.hash();
}

/// The header of the scene's snapshots, but for the length.
template <class S>
constexpr SnapshotHeader expected_header() {
    constexpr uint64_t signature = scene_signature<S>();
    return {snapshot_magic, snapshot_format, INGOT_DETERMINISM_VERSION, signature, 0, snapshot_parts<S>(),
            static_cast<uint32_t>(saved_field_size<S>())};
}

/// Shapes of the body of a slot: they are its first. A body of a scene of one shape each has that, be it none.
template <class S>
int shape_count_of([[maybe_unused]] const Storage<S>& storage, [[maybe_unused]] int slot) {
    if constexpr (has_compounds<S>) {
        int count = 0;
        for (int shape_i = 0; shape_i < S::max_shapes_of_body; ++shape_i)
            if (storage.surfaces[slot * S::max_shapes_of_body + shape_i].shape.kind != ShapeKind::none) ++count;
        return count;
    }
    return 1;
}

template <class S>
void write_body(ByteWriter& writer, const Storage<S>& storage, int slot) {
    SavedBody body = saved_body(storage.bodies(), slot);
    body.numbers(writer, snapshot_parts<S>());
    uint8_t count = static_cast<uint8_t>(shape_count_of(storage, slot));
    if (has_compounds<S>) writer(count);
    for (int shape_i = 0; shape_i < count; ++shape_i) write_numbers<OfShape>(writer, storage, slot * S::max_shapes_of_body + shape_i);
    write_numbers<OfBody>(writer, storage, slot);
}

/// Contacts of the last step, in their order: their impulses are what the next step begins with.
template <class S>
void write_manifolds([[maybe_unused]] ByteWriter& writer, [[maybe_unused]] const Storage<S>& storage) {
    if constexpr (stacks<S>) {
        Index count = static_cast<Index>(saved_manifold_count(storage));
        writer(count);
        for_manifolds(storage, writer.next(), saved_size<OfManifold, S>(),
                      [&writer, &storage](const BodyPair& pair) { write_numbers<OfManifold>(writer, storage, pair); });
    }
}

/// Who is in sensors, who touches whom, what the last step told.
template <class S>
void write_lists(ByteWriter& writer, const Storage<S>& storage) {
    features::All::over_named<S>([&](auto feature) {
        using F = decltype(feature);
        if constexpr (F::has_entries) {
            Index count = F::entry_count(storage);
            writer(count);
            for (int entry_i = 0; entry_i < count; ++entry_i) {
                typename F::OfEntry saved{};
                saved.take(storage, entry_i);
                saved.numbers(writer, snapshot_parts<S>());
            }
        }
    });
}

/// Bytes of the snapshot of a world as it is.
template <class S>
size_t snapshot_size_of(const Storage<S>& storage) {
    const size_t manifold_count = static_cast<size_t>(saved_manifold_count(storage));
    size_t living = 0, shape_count = 0;
    for (int slot = 0; slot < storage.slots_used; ++slot) {  // bound: max_bodies
        if (!storage.lives(slot)) continue;
        ++living;
        shape_count += static_cast<size_t>(shape_count_of(storage, slot));
    }
    size_t lists = 0;
    features::All::over_named<S>([&](auto feature) { lists += saved_list_size<S, decltype(feature)>(feature.entry_count(storage)); });
    return lists + snapshot_size_of<S>(static_cast<size_t>(storage.slots_used), living, shape_count, manifold_count);
}

/// Writes the world, ready to be kept in a file or sent to another machine.
///
/// Holds:   all that decides the steps to come, ids, and what the last step told of sensors and events. Not in it, because derived: omega,
///          bounds, pairs that do not touch; and contacts of scenes with max_contacts, which are found anew in every step.
/// Returns: the bytes written, at most snapshot_size<S>(); fewer while the world has fewer bodies.
/// Errors:  no_room (fewer than that many bytes; nothing is written).
/// Cost:    O(slots used), about 150 bytes a body in float.
template <class S>
Result<size_t> save_snapshot(const World<S>& world, uint8_t* bytes, size_t room) {
    const Storage<S>& storage = world.storage_;
    const size_t size = snapshot_size_of(storage);
    if (bytes == nullptr || room < size) return {Status::no_room, 0};

    ByteWriter writer(bytes);
    SnapshotHeader header = expected_header<S>();
    header.length = static_cast<uint32_t>(size);
    header.numbers(writer);
    SavedWorld whole{storage.world_tag, storage.steps, static_cast<uint32_t>(storage.slots_used), static_cast<uint32_t>(storage.free_hint)};
    whole.numbers(writer);
    write_numbers<OfWorld>(writer, storage);
    if constexpr (has_field<S>) const_cast<typename S::force_field&>(storage.field).numbers(writer);  // a writer only reads

    for (int slot = 0; slot < storage.slots_used; ++slot) {  // bound: max_bodies
        uint32_t generation = storage.generation[slot];
        writer(generation);
        if (storage.lives(slot)) write_body(writer, storage, slot);
    }
    write_manifolds(writer, storage);
    write_lists(writer, storage);
    uint64_t checksum = snapshot_checksum(bytes, size - sizeof checksum);
    writer(checksum);
    return {Status::ok, size};
}

/// Reads the numbers of the whole. Without storage it only checks.
template <class S>
Status read_whole(ByteReader& reader, SavedWorld& whole, Storage<S>* to) {
    whole.numbers(reader);
    if (whole.slots_used > static_cast<uint32_t>(S::max_bodies) || whole.free_hint > whole.slots_used) return Status::bad_snapshot;
    if (to != nullptr) {
        INGOT_CLEAR_BYTES(static_cast<void*>(to), sizeof *to);
        to->world_tag = whole.world_tag;
        to->steps = whole.steps;
        to->slots_used = static_cast<int32_t>(whole.slots_used);
        to->free_hint = static_cast<int32_t>(whole.free_hint);
        // bound: max_bodies, rounded up to whole tiles
        for (int slot = 0; slot < to->bodies().tile_count * lanes; ++slot) set_identity_body(to->bodies(), slot);
        features::All::over_named<S>([to](auto feature) { decltype(feature)::begin_load(*to); });
    }
    const Status status = read_numbers<OfWorld, S>(reader, to, whole);
    if constexpr (has_field<S>) {
        if (to == nullptr)
            reader.skip(saved_field_size<S>());
        else
            to->field.numbers(reader);
    }
    return status;
}

/// Reads one living body. Without storage it only checks.
template <class S>
Status read_body(ByteReader& reader, int slot, Storage<S>* to) {
    SavedBody body{};
    body.numbers(reader, snapshot_parts<S>());
    if (!is_valid(body, S::translates)) return Status::bad_snapshot;
    if (to != nullptr) write_saved_body(to->bodies(), slot, body);
    uint8_t count = 1;
    if (has_compounds<S>) reader(count);
    if (count > S::max_shapes_of_body) return Status::bad_snapshot;
    for (int shape_i = 0; shape_i < count; ++shape_i)
        if (read_numbers<OfShape, S>(reader, to, body, slot * S::max_shapes_of_body + shape_i) != Status::ok) return Status::bad_snapshot;
    return read_numbers<OfBody, S>(reader, to, body, slot);
}

/// Without storage it only checks.
template <class S>
Status read_manifolds([[maybe_unused]] ByteReader& reader, [[maybe_unused]] uint32_t slots_used, [[maybe_unused]] Storage<S>* to) {
    if constexpr (stacks<S>) {
        Index count = 0;
        reader(count);
        if (count > S::max_manifolds) return Status::bad_snapshot;
        ManifoldContext context{slots_used, 0, 0};
        for (Index record = 0; record < count; ++record) {  // bound: max_manifolds: more are refused before
            if (read_numbers<OfManifold, S>(reader, to, context, record) != Status::ok) return Status::bad_snapshot;
            context.key_before = context.key;
        }
    }
    return Status::ok;
}

/// Without storage it only checks.
template <class S>
Status read_lists(ByteReader& reader, uint32_t slots_used, Storage<S>* to) {
    bool sound = true;
    features::All::over_named<S>([&](auto feature) {
        using F = decltype(feature);
        if constexpr (F::has_entries) {
            Index count = 0;
            reader(count);
            sound = sound && count <= F::template entry_capacity<S>;
            if (to != nullptr) F::set_entry_count(*to, count);
            EntryContext context{slots_used * S::max_shapes_of_body, 0};
            for (int entry_i = 0; entry_i < count && sound; ++entry_i) {
                typename F::OfEntry saved{};
                saved.numbers(reader, snapshot_parts<S>());
                sound = saved.template is_valid<S>(context);
                if (to != nullptr) saved.put(*to, entry_i);
            }
        }
    });
    return sound ? Status::ok : Status::bad_snapshot;
}

/// Reads what comes after the header. Without storage it only checks.
template <class S>
Status read_snapshot_contents(ByteReader reader, Storage<S>* to) {
    SavedWorld whole{};
    Status status = read_whole<S>(reader, whole, to);
    // bound: max_bodies: more is refused before
    for (uint32_t slot = 0; slot < whole.slots_used && status == Status::ok; ++slot) {
        uint32_t generation = 0;
        reader(generation);
        const bool lives = (generation & 1u) != 0, used_up = generation == UINT32_MAX - 1;
        if (generation == 0 || (slot < whole.free_hint && !lives && !used_up)) return Status::bad_snapshot;
        if (to != nullptr) to->generation[slot] = generation;
        if (lives) status = read_body<S>(reader, static_cast<int>(slot), to);
    }
    if (status == Status::ok) status = read_manifolds<S>(reader, whole.slots_used, to);
    if (status == Status::ok) status = read_lists<S>(reader, whole.slots_used, to);
    if (status != Status::ok) return status;
    if (to != nullptr) features::All::over_named<S>([to](auto feature) { decltype(feature)::finish_load(*to); });
    return reader.at_end() ? Status::ok : Status::bad_snapshot;
}

/// Makes the world what it was when the snapshot was saved. All is checked before anything is written, so a refused snapshot
/// leaves the world bitwise unchanged.
///
/// Numbers of a force field are taken as they are, as World::force_field takes them. contact_count() is 0 until the next step.
/// Errors:  bad_snapshot (not a snapshot, not whole, damaged, or of a state that no world has); other_version; other_scene (of
///          another scalar, or of a scene with other capacities, shapes or methods).
/// Cost:    two readings of the bytes and one checksum.
template <class S>
Status load_snapshot(World<S>& world, const uint8_t* bytes, size_t size) {
    Status status = check_snapshot_envelope(bytes, size, expected_header<S>());
    if (status != Status::ok) return status;
    const ByteReader contents(bytes + snapshot_header_size(), size - snapshot_header_size() - snapshot_checksum_size);
    status = read_snapshot_contents<S>(contents, nullptr);
    return status == Status::ok ? read_snapshot_contents<S>(contents, &world.storage_) : status;
}

} }  // namespace ingot
