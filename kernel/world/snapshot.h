// SPDX-License-Identifier: MIT
// Two ways to keep a world, and to go on from there as if it had never been left, to the bit.
//
// memcpy of the whole object, for the same program on the same machine: a world holds no pointer. The fastest, and what
// rollback within one process wants. It checks nothing.
//
// save_snapshot and load_snapshot, for files and for other machines: the same bytes for every lane count, compiler and order of
// bytes in memory, checked by a checksum and then number by number. For worlds of one scalar and one scene.
#pragma once

#include "../base/version.h"
#include "../body/freeze_bad_bodies.h"
#include "snapshot_bytes.h"
#include "world.h"

namespace ingot { inline namespace INGOT_ABI {

/// True for fields that name their numbers: see motion/force_field.h.
template <class Field, class = void>
inline constexpr bool names_its_numbers = false;
template <class Field>
inline constexpr bool names_its_numbers<Field, decltype(any_of<Field>().numbers(any_of<ByteCounter>()))> = true;

/// The numbers of a world beside those of its bodies and its field.
template <class S>
struct SavedWorld {
    uint16_t world_tag;
    uint32_t steps, slots_used, free_hint;
    Vector gravity;
    scalar h_before, t, t_low;
    uint8_t field_changed;  ///< since the last step: what sleeps is to wake

    template <class Stream>
    constexpr void numbers(Stream& each) {
        each(world_tag);
        each(steps);
        each(slots_used);
        each(free_hint);
        if constexpr (S::translates) each(gravity);
        if constexpr (S::rotation::returns_energy) each(h_before);
        if constexpr (has_field<S>) {
            each(t);
            each(t_low);
            if constexpr (S::sleeps) each(field_changed);
        }
    }
};

template <class Stream>
constexpr void saved_filter_numbers(Stream& each, BodyFilter& filter) {
    each(filter.category);
    each(filter.mask);
}

/// What a shape has beside its surface, in scenes that name it.
template <class S>
struct SavedMaterial {
    scalar rolling_lever;
    Vector surface_velocity;

    template <class Stream>
    constexpr void numbers(Stream& each) {
        if constexpr (S::rolling_resistance) each(rolling_lever);
        if constexpr (S::surface_velocities) each(surface_velocity);
    }
};
template <class S>
SavedMaterial<S> saved_material([[maybe_unused]] const Storage<S>& storage, [[maybe_unused]] int shape_slot) {
    SavedMaterial<S> material{};
    if constexpr (S::rolling_resistance) material.rolling_lever = storage.rolling_levers[shape_slot];
    if constexpr (S::surface_velocities) material.surface_velocity = storage.surface_velocities[shape_slot];
    return material;
}
/// Without storage it only checks.
template <class S>
Status read_material(ByteReader& reader, [[maybe_unused]] int shape_slot, [[maybe_unused]] Storage<S>* to) {
    SavedMaterial<S> material{};
    material.numbers(reader);
    if (!(material.rolling_lever >= 0 && material.rolling_lever <= limits::size_max)) return Status::bad_snapshot;
    if (check_vector(material.surface_velocity, limits::speed_max) != Status::ok) return Status::bad_snapshot;
    if constexpr (S::rolling_resistance)
        if (to != nullptr) to->rolling_levers[shape_slot] = material.rolling_lever;
    if constexpr (S::surface_velocities)
        if (to != nullptr) to->surface_velocities[shape_slot] = material.surface_velocity;
    return Status::ok;
}

/// Sizes in bytes, counted by the functions that write.
template <class S>
constexpr size_t saved_field_size() {
    ByteCounter counter;
    if constexpr (has_field<S>) {
        static_assert(names_its_numbers<typename S::force_field>,
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
    body.numbers(counter, S::translates, S::rotation::compensates, S::rotation::returns_energy);
    SavedSurface surface{};
    BodyFilter filter{};
    uint8_t sensor = 0;
    if (has_compounds<S>) counter(sensor);  // as wide as the count of shapes
    SavedMaterial<S> material{};
    if (has_shapes<S> && !has_compounds<S>) surface.numbers(counter);
    if (!has_compounds<S>) material.numbers(counter);
    if (S::filters) saved_filter_numbers(counter, filter);
    if (has_sensors<S> && !has_compounds<S>) counter(sensor);
    SavedRest rest{};
    if (S::sleeps) rest.numbers(counter);
    return counter.count();
}
/// One shape of a body of several.
struct SavedShape {
    SavedSurface surface;
    ShapePlace place;
    uint8_t sensor;

    template <class Stream>
    constexpr void numbers(Stream& each, bool has_sensors) {
        surface.numbers(each);
        each(place.r);
        each(place.A);
        if (has_sensors) each(sensor);
    }
};
template <class S>
constexpr size_t saved_shape_size() {
    ByteCounter counter;
    SavedShape shape{};
    SavedMaterial<S> material{};
    if (has_compounds<S>) shape.numbers(counter, has_sensors<S>);
    if (has_compounds<S>) material.numbers(counter);
    return counter.count();
}
template <class S>
constexpr size_t saved_manifold_size() {
    ByteCounter counter;
    SavedManifold manifold{};
    manifold.numbers(counter, S::recycles_manifolds);
    uint8_t unsettled = 0;
    if (solves_directly<S>) counter(unsettled);
    Vector j_rolling{};
    if (S::rolling_resistance) counter(j_rolling);
    return counter.count();
}
template <class S>
constexpr size_t snapshot_size_of(size_t slots_used, size_t living, size_t shapes, size_t manifolds) {
    ByteCounter counter;
    SavedWorld<S> world{};
    world.numbers(counter);
    return snapshot_header_size() + counter.count() + saved_field_size<S>() + slots_used * sizeof(uint32_t) + living * saved_body_size<S>() +
           shapes * saved_shape_size<S>() + (stacks<S> ? sizeof(uint16_t) + manifolds * saved_manifold_size<S>() : 0) + snapshot_checksum_size;
}

/// Bytes that a snapshot of any world of the scene fits in: that of a full one.
template <class S>
constexpr size_t snapshot_size() {
    return snapshot_size_of<S>(static_cast<size_t>(S::max_bodies), static_cast<size_t>(S::max_bodies), static_cast<size_t>(shape_capacity<S>),
                               static_cast<size_t>(S::max_manifolds));
}

template <class S>
constexpr uint16_t snapshot_parts() {
    int parts = 0;
    if (sizeof(scalar) == sizeof(double)) parts |= SnapshotPart::doubles;
    if (S::translates) parts |= SnapshotPart::translation;
    if (S::rotation::compensates) parts |= SnapshotPart::compensation;
    if (S::rotation::returns_energy) parts |= SnapshotPart::energy;
    if (has_field<S>) parts |= SnapshotPart::field;
    if (has_shapes<S>) parts |= SnapshotPart::surfaces;
    if (S::filters) parts |= SnapshotPart::filters;
    if (has_sensors<S>) parts |= SnapshotPart::sensors;
    if (stacks<S>) parts |= SnapshotPart::manifolds;
    if (stacks<S> && S::recycles_manifolds) parts |= SnapshotPart::anchors;
    if (has_compounds<S>) parts |= SnapshotPart::compounds;
    if (stacks<S> && solves_directly<S>) parts |= SnapshotPart::unsettled;
    if (S::sleeps) parts |= SnapshotPart::sleep;
    if (S::rolling_resistance) parts |= SnapshotPart::rolling;
    if (S::surface_velocities) parts |= SnapshotPart::belts;
    return static_cast<uint16_t>(parts);
}

/// The order that a method tells of itself; 0 if it tells none.
template <class Method, class = void>
inline constexpr int order_of = 0;
template <class Method>
inline constexpr int order_of<Method, decltype(static_cast<void>(Method::order))> = Method::order;

/// A number for all that makes snapshots of two scenes differ in their bytes or in the steps that follow: the scalar,
/// capacities, shapes, hulls to a nanometre, names and orders of the methods. (Two limits of substeps are one number.)
template <class S>
constexpr uint64_t scene_signature() {
    uint64_t hash = state_hash_seed;
    const auto add = [&hash](uint64_t number) {
        for (int byte_i = 0; byte_i < 8; ++byte_i) hash = (hash ^ (number >> (8 * byte_i) & 0xffu)) * 0x100000001b3u;
    };
    const auto add_name = [&hash](const char* name) {
        for (; *name != 0; ++name) hash = (hash ^ static_cast<uint8_t>(*name)) * 0x100000001b3u;
        hash *= 0x100000001b3u;
    };
    add(snapshot_parts<S>());
    add(static_cast<uint64_t>(S::max_bodies));
    add(static_cast<uint64_t>(S::max_contacts));
    add(static_cast<uint64_t>(S::max_manifolds));
    add(static_cast<uint64_t>(S::max_pairs));
    for (int kind = 0; kind <= static_cast<int>(ShapeKind::half_space); ++kind)
        add(S::shapes::has(static_cast<ShapeKind>(kind)) ? 1 : 0);
    if (has_compounds<S>) add(static_cast<uint64_t>(S::max_shapes_of_body));
    for (int form = 0; form < hulls_of<S>.count; ++form) {
        const ConvexHull& hull = hulls_of<S>.hulls[form];
        const auto add_length = [&add](scalar metres) { add(static_cast<uint64_t>(static_cast<int64_t>(metres * scalar(1 << 30)))); };
        for (int vertex_i = 0; vertex_i < hull.vertex_count; ++vertex_i) {
            add_length(hull.vertices[vertex_i].x);
            add_length(hull.vertices[vertex_i].y);
            add_length(hull.vertices[vertex_i].z);
        }
    }
    add_name(S::rotation::name);
    add_name(S::flight::name);
    add(static_cast<uint64_t>(order_of<typename S::rotation>));
    add(saved_field_size<S>());
    if constexpr (stacks<S> && solves_directly<S>) {
        add(static_cast<uint64_t>(S::solver::island_capacity));
        add(static_cast<uint64_t>(S::solver::entries_per_row));
    }
    if constexpr (stacks<S> && solves_pointwise<S>) add_name("point_sweeps");
    if (S::sleeps) {  // in micrometres and microseconds
        add(static_cast<uint64_t>(S::sleep_speed * scalar(1e6)));
        add(static_cast<uint64_t>(S::sleep_time * scalar(1e6)));
    }
    return hash;
}

/// The header of the scene's snapshots, but for the length.
template <class S>
constexpr SnapshotHeader expected_header() {
    constexpr uint64_t signature = scene_signature<S>();
    return {snapshot_magic, snapshot_format,     INGOT_DETERMINISM_VERSION, signature,
            0,              snapshot_parts<S>(), static_cast<uint32_t>(saved_field_size<S>())};
}

/// A pair in bytes, to be sorted where the snapshot is written.
struct PairBytes {
    uint8_t bytes[6];

    uint32_t key() const { return static_cast<uint32_t>(bytes[0]) << 24 | static_cast<uint32_t>(bytes[1]) << 16 | bytes[2] * 256u | bytes[3]; }
    BodyPair pair() const {
        return {static_cast<uint16_t>(key() >> 16), static_cast<uint16_t>(key() & 0xffffu), static_cast<uint16_t>(bytes[4] * 256 + bytes[5])};
    }
};
constexpr PairBytes bytes_of(const BodyPair& pair) {
    const auto high = [](uint16_t number) { return static_cast<uint8_t>(number >> 8); };
    const auto low = [](uint16_t number) { return static_cast<uint8_t>(number & 0xffu); };
    return {{high(pair.body_A), low(pair.body_A), high(pair.body_B), low(pair.body_B), high(pair.record), low(pair.record)}};
}

template <class S>
int saved_manifold_count([[maybe_unused]] const Storage<S>& storage) {
    int count = 0;
    if constexpr (stacks<S>) count = storage.manifold_count;
    if constexpr (S::sleeps) count += storage.aside_count;
    return count;
}

/// Calls each(pair) for all contacts in the order of slots: those of the step, and those that are put aside. These lie in no order: all are sorted at
/// the end of the room that their contacts are going to be written to, which never reaches one that is still to be read.
template <class S, class Each>
void for_manifolds(const Storage<S>& storage, [[maybe_unused]] uint8_t* room, const Each& each) {
    if constexpr (S::sleeps) {
        const int count = saved_manifold_count(storage);
        PairBytes* const sorted = reinterpret_cast<PairBytes*>(room + static_cast<size_t>(count) * (saved_manifold_size<S>() - sizeof(PairBytes)));
        int listed = 0;
        for (int pair_i = 0; pair_i < storage.manifold_count; ++pair_i) sorted[listed++] = bytes_of(storage.pairs[pair_i]);
        for (int record_i = 0; record_i < storage.records_used; ++record_i) {
            const BodyPair& aside = storage.pairs_aside[record_i];
            if (aside.record != 0) sorted[listed++] = bytes_of({aside.body_A, aside.body_B, static_cast<uint16_t>(record_i)});
        }
        sort_by_key(sorted, count);
        for (int pair_i = 0; pair_i < count; ++pair_i) each(sorted[pair_i].pair());
    } else {
        for (int pair_i = 0; pair_i < storage.manifold_count; ++pair_i) each(storage.pairs[pair_i]);
    }
}

/// Contacts of the last step, in their order: their impulses are what the next step begins with.
template <class S>
void write_manifolds(ByteWriter& writer, const Storage<S>& storage) {
    uint16_t count = static_cast<uint16_t>(saved_manifold_count(storage));
    writer(count);
    for_manifolds(storage, writer.next(), [&writer, &storage](const BodyPair& pair) {
        SavedManifold saved{pair.body_A, pair.body_B, storage.records[pair.record], {}};
        if constexpr (S::recycles_manifolds)  // what is not known is what the record had before
            if (storage.anchors[pair.record].margin > 0) saved.anchors = storage.anchors[pair.record];
        saved.numbers(writer, S::recycles_manifolds);
        if constexpr (solves_directly<S>) {
            uint8_t unsettled = storage.unsettled[pair.record];
            writer(unsettled);
        }
        if constexpr (S::rolling_resistance) {
            Vector j_rolling = storage.rolling_records[pair.record].j;
            writer(j_rolling);
        }
    });
}

/// Without storage it only checks. The search for pairs begins anew: what is zero in storage is outside of every bound.
template <class S>
Status read_manifolds(ByteReader& reader, uint32_t slots_used, Storage<S>* to) {
    uint16_t count = 0;
    reader(count);
    if (count > S::max_manifolds) return Status::bad_snapshot;
    uint32_t key_before = 0;
    for (uint16_t record = 0; record < count; ++record) {
        SavedManifold saved{};
        saved.numbers(reader, S::recycles_manifolds);
        uint8_t unsettled = 0;
        if constexpr (solves_directly<S>) reader(unsettled);
        Vector j_rolling{};
        if constexpr (S::rolling_resistance) reader(j_rolling);
        if (!is_finite(j_rolling)) return Status::bad_snapshot;
        if (unsettled > limits::unsettled_steps) return Status::bad_snapshot;
        const BodyPair pair{saved.body_A, saved.body_B, record};
        if (!is_valid(saved) || pair.body_A >= pair.body_B || pair.body_B >= slots_used * S::max_shapes_of_body || pair.key() <= key_before)
            return Status::bad_snapshot;
        if (has_compounds<S> && pair.body_A / S::max_shapes_of_body == pair.body_B / S::max_shapes_of_body) return Status::bad_snapshot;
        key_before = pair.key();
        if (to == nullptr) continue;
        to->pairs[record] = pair;
        to->records[record] = saved.record;
        if constexpr (S::recycles_manifolds) to->anchors[record] = saved.anchors;
        if constexpr (solves_directly<S>) to->unsettled[record] = unsettled;
        if constexpr (S::rolling_resistance) to->rolling_records[record].j = j_rolling;
        to->records_used = to->manifold_count = static_cast<uint16_t>(record + 1);
    }
    return Status::ok;
}

/// Shapes of the body of a slot.
template <class S>
int shape_count_of(const Storage<S>& storage, int slot) {
    int count = 0;
    for (int shape_i = 0; shape_i < S::max_shapes_of_body; ++shape_i)
        if (storage.surfaces[slot * S::max_shapes_of_body + shape_i].shape.kind != ShapeKind::none) ++count;
    return count;
}

constexpr SavedSurface saved_surface(const Surface& surface) {
    return {static_cast<uint8_t>(surface.shape.kind), surface.shape.size, surface.shape.offset, surface.e, surface.mu};
}

/// The shapes of a living body: they are its first slots.
template <class S>
void write_shapes(ByteWriter& writer, const Storage<S>& storage, int slot) {
    uint8_t count = static_cast<uint8_t>(shape_count_of(storage, slot));
    writer(count);
    for (int shape_slot = slot * S::max_shapes_of_body; count > 0; ++shape_slot, --count) {
        SavedShape shape{saved_surface(storage.surfaces[shape_slot]), storage.shape_places[shape_slot], 0};
        if constexpr (has_sensors<S>) shape.sensor = storage.is_sensor[shape_slot];
        shape.numbers(writer, has_sensors<S>);
        SavedMaterial<S> material = saved_material(storage, shape_slot);
        material.numbers(writer);
    }
}

template <class S>
bool is_surface_of(const SavedSurface& surface, const Shape& shape, bool can_move) {
    return ShapesOf<S>::names_its_hull(shape) && is_valid(surface, can_move) && (S::bounces || surface.e == 0);
}

/// Without storage it only checks.
template <class S>
Status read_shapes(ByteReader& reader, int slot, bool can_move, Storage<S>* to) {
    uint8_t count = 0;
    reader(count);
    if (count > S::max_shapes_of_body) return Status::bad_snapshot;
    for (int shape_slot = slot * S::max_shapes_of_body; count > 0; ++shape_slot, --count) {
        SavedShape saved{};
        saved.numbers(reader, has_sensors<S>);
        const Shape shape{static_cast<ShapeKind>(saved.surface.kind), saved.surface.size, saved.surface.offset};
        if (!S::shapes::has(shape.kind) || !is_surface_of<S>(saved.surface, shape, can_move)) return Status::bad_snapshot;
        if (check_vector(saved.place.r, limits::position_max) != Status::ok || check_rotation(saved.place.A) != Status::ok || saved.sensor > 1)
            return Status::bad_snapshot;
        if (read_material<S>(reader, shape_slot, to) != Status::ok) return Status::bad_snapshot;
        if (to == nullptr) continue;
        to->surfaces[shape_slot] = {shape, radius_about_body(shape, saved.place), saved.surface.e, saved.surface.mu};
        to->shape_places[shape_slot] = saved.place;
        if constexpr (has_sensors<S>) to->is_sensor[shape_slot] = saved.sensor;
    }
    return Status::ok;
}

/// Writes the world, ready to be kept in a file or sent to another machine.
///
/// Holds:   all that decides the steps to come, and ids. Not in it, because derived: omega, bounds, pairs that do not touch; and contacts of scenes
///          with max_contacts, which are found anew in every step.
/// Returns: the bytes written, at most snapshot_size<S>(); fewer while the world has fewer bodies.
/// Errors:  no_room (fewer than that many bytes; nothing is written).
/// Cost:    O(slots used), about 150 bytes a body in float.
template <class S>
Result<size_t> save_snapshot(const World<S>& world, uint8_t* bytes, size_t room) {
    static_assert(!has_events<S>, "a snapshot holds no events: copy the world with memcpy, or set max_events = 0");
    const Storage<S>& storage = world.storage_;
    const size_t manifold_count = static_cast<size_t>(saved_manifold_count(storage));
    size_t shape_count = 0;
    if constexpr (has_compounds<S>)
        for (int slot = 0; slot < storage.slots_used; ++slot) shape_count += static_cast<size_t>(shape_count_of(storage, slot));
    const size_t size =
        snapshot_size_of<S>(static_cast<size_t>(storage.slots_used), static_cast<size_t>(world.body_count()), shape_count, manifold_count);
    if (bytes == nullptr || room < size) return {Status::no_room, 0};

    ByteWriter writer(bytes);
    SnapshotHeader header = expected_header<S>();
    header.length = static_cast<uint32_t>(size);
    header.numbers(writer);

    SavedWorld<S> whole{};
    whole.world_tag = storage.world_tag;
    whole.steps = storage.steps;
    whole.slots_used = static_cast<uint32_t>(storage.slots_used);
    whole.free_hint = static_cast<uint32_t>(storage.free_hint);
    if constexpr (S::translates) whole.gravity = storage.gravity;
    if constexpr (S::rotation::returns_energy) whole.h_before = storage.h_before;
    if constexpr (has_field<S>) {
        whole.t = storage.t;
        whole.t_low = storage.t_low;
        if constexpr (S::sleeps) whole.field_changed = storage.has_new_field() ? 1 : 0;
    }
    whole.numbers(writer);
    if constexpr (has_field<S>) const_cast<typename S::force_field&>(storage.field).numbers(writer);  // a writer only reads

    for (int slot = 0; slot < storage.slots_used; ++slot) {
        uint32_t generation = storage.generation[slot];
        writer(generation);
        if (!world.lives(slot)) continue;
        SavedBody body = saved_body(storage.bodies(), slot);
        body.numbers(writer, S::translates, S::rotation::compensates, S::rotation::returns_energy);
        if constexpr (has_compounds<S>) {
            write_shapes(writer, storage, slot);
        } else if constexpr (has_shapes<S>) {
            SavedSurface surface = saved_surface(storage.surfaces[slot]);
            surface.numbers(writer);
            SavedMaterial<S> material = saved_material(storage, slot);
            material.numbers(writer);
        }
        if constexpr (S::filters) {
            BodyFilter filter = storage.filters[slot];
            saved_filter_numbers(writer, filter);
        }
        if constexpr (has_sensors<S> && !has_compounds<S>) {
            uint8_t sensor = storage.is_sensor[slot];
            writer(sensor);
        }
        if constexpr (S::sleeps) {
            const uint8_t awake = storage.is_awake(slot) ? 1 : RestView::has(storage.settling, slot) ? 2 : 0;
            SavedRest rest{awake, storage.rest_time[slot]};
            rest.numbers(writer);
        }
    }
    if constexpr (stacks<S>) write_manifolds<S>(writer, storage);
    uint64_t checksum = snapshot_checksum(bytes, size - sizeof checksum);
    writer(checksum);
    return {Status::ok, size};
}

/// True for what a world of the scene can have become.
template <class S>
bool is_valid(const SavedWorld<S>& world) {
    if (world.slots_used > static_cast<uint32_t>(S::max_bodies) || world.free_hint > world.slots_used) return false;
    if (S::translates && check_vector(world.gravity, limits::gravity_max) != Status::ok) return false;
    if (world.h_before != 0 && check_step(world.h_before) != Status::ok) return false;
    return world.field_changed <= 1 && world.t >= 0 && is_finite(world.t) && is_finite(world.t_low);
}

/// Reads the numbers of the whole. Without storage it only checks.
template <class S>
Status read_whole(ByteReader& reader, SavedWorld<S>& whole, Storage<S>* to) {
    whole.numbers(reader);
    if (!is_valid(whole)) return Status::bad_snapshot;
    if (to == nullptr) {
        reader.skip(saved_field_size<S>());
        return Status::ok;
    }
    __builtin_memset(static_cast<void*>(to), 0, sizeof *to);
    to->world_tag = whole.world_tag;
    to->steps = whole.steps;
    to->slots_used = static_cast<int32_t>(whole.slots_used);
    to->free_hint = static_cast<int32_t>(whole.free_hint);
    if constexpr (S::translates) to->gravity = whole.gravity;
    if constexpr (S::rotation::returns_energy) to->h_before = whole.h_before;
    if constexpr (has_field<S>) {
        to->t = whole.t;
        to->t_low = whole.t_low;
        if constexpr (S::sleeps) to->field_changed = whole.field_changed;
        to->field.numbers(reader);
    }
    for (int slot = 0; slot < to->bodies().tile_count * lanes; ++slot) set_identity_body(to->bodies(), slot);
    if constexpr (has_compounds<S>)
        for (int shape_slot = 0; shape_slot < to->shapes().tile_count * lanes; ++shape_slot) set_identity_body(to->shapes(), shape_slot);
    return Status::ok;
}

/// Reads one living body. Without storage it only checks.
template <class S>
Status read_body(ByteReader& reader, int slot, Storage<S>* to) {
    SavedBody body{};
    body.numbers(reader, S::translates, S::rotation::compensates, S::rotation::returns_energy);
    if (!is_valid(body, S::translates)) return Status::bad_snapshot;
    if (to != nullptr) write_saved_body(to->bodies(), slot, body);
    if constexpr (has_compounds<S>) {
        const Status status = read_shapes<S>(reader, slot, body.inv_I_scale > 0, to);
        if (status != Status::ok) return status;
    } else if constexpr (has_shapes<S>) {
        SavedSurface surface{};
        surface.numbers(reader);
        const Shape shape{static_cast<ShapeKind>(surface.kind), surface.size, surface.offset};
        const bool in_scene = shape.kind == ShapeKind::none || S::shapes::has(shape.kind);
        if (!in_scene || !is_surface_of<S>(surface, shape, body.inv_I_scale > 0)) return Status::bad_snapshot;
        if (read_material<S>(reader, slot, to) != Status::ok) return Status::bad_snapshot;
        if (to != nullptr) to->surfaces[slot] = {shape, bounding_radius(shape), surface.e, surface.mu};
    }
    if constexpr (S::filters) {
        BodyFilter filter{};
        saved_filter_numbers(reader, filter);
        if (to != nullptr) to->filters[slot] = filter;
    }
    if constexpr (has_sensors<S> && !has_compounds<S>) {
        uint8_t sensor = 0;
        reader(sensor);
        if (sensor > 1) return Status::bad_snapshot;
        if (to != nullptr) to->is_sensor[slot] = sensor;
    }
    if constexpr (S::sleeps) {
        SavedRest rest{};
        rest.numbers(reader);
        if (!is_valid(rest, body, S::sleep_time)) return Status::bad_snapshot;
        if (to != nullptr && rest.awake == 1) to->rest_view().wake(slot);
        if (to != nullptr && rest.awake == 2) to->rest_view().settle(slot);
        if (to != nullptr) to->rest_time[slot] = rest.rest_time;
    }
    return Status::ok;
}

/// Reads what comes after the header. Without storage it only checks.
template <class S>
Status read_snapshot_contents(ByteReader reader, Storage<S>* to) {
    SavedWorld<S> whole{};
    Status status = read_whole<S>(reader, whole, to);
    for (uint32_t slot = 0; slot < whole.slots_used && status == Status::ok; ++slot) {
        uint32_t generation = 0;
        reader(generation);
        const bool lives = (generation & 1u) != 0, used_up = generation == UINT32_MAX - 1;
        if (generation == 0 || (slot < whole.free_hint && !lives && !used_up)) return Status::bad_snapshot;
        if (to != nullptr) to->generation[slot] = generation;
        if (lives) status = read_body<S>(reader, static_cast<int>(slot), to);
        if constexpr (has_compounds<S>)
            if (to != nullptr) to->set_generation_of_shapes(static_cast<int>(slot), generation);
    }
    if constexpr (has_compounds<S>)
        if (to != nullptr) to->place_all_shapes();
    if constexpr (stacks<S>)
        if (status == Status::ok) status = read_manifolds<S>(reader, whole.slots_used, to);
    if constexpr (S::sleeps)
        if (status == Status::ok && to != nullptr) {
            join_all_islands(to->bodies(), to->rest_view(), to->manifold_view());
            to->put_aside();
        }
    if (status != Status::ok) return status;
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
