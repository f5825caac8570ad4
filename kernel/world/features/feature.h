// SPDX-License-Identifier: MIT
// A feature is a record: all that a trait of a scene brings along stands in one struct. They have plain names, in a namespace of their own.
//
// Storage, checks, World::add and remove, snapshot, state hash, signature and replay fold over the list in features.h; none of them names a
// feature. A new one is a struct here, a line in that list and a trait in scene.h. `gravity_shares.h` is a short example.
#pragma once

#include "../../base/if.h"
#include "../body_def.h"
#include "../scene.h"
#include "../snapshot_bytes.h"
#include "../state_hash.h"

namespace ingot { inline namespace INGOT_ABI {

template <class S>
struct Storage;

/// The numbers of a world beside those of its bodies and its features.
struct SavedWorld {
    uint16_t world_tag;
    uint32_t steps, slots_used, free_hint;

    template <class Each>
    constexpr void numbers(Each& each) {
        each("world_tag", world_tag);
        each("steps", steps);
        each("slots_used", slots_used);
        each("free_hint", free_hint);
    }
};

/// What a manifold is seen beside as it is read.
struct ManifoldContext {
    uint32_t slots_used;  ///< of bodies
    PairKey key_before;  ///< of the manifold before; 0: of none
    PairKey key;         ///< of this one, once its bodies are read
};

/// And an entry of a list.
struct EntryContext {
    uint32_t shape_slots;  ///< in use
    PairKey key_before;   ///< of the pair before; 0: of none
};

namespace features {

/// Numbers that a snapshot holds of the world, a body, a shape, a manifold, or an entry of a list: here none.
///
///     numbers(each, parts)    hands out each number under its name, in the order of the bytes; parts: those of SnapshotHeader
///     take(storage, where)    fetches them; where: nothing, a slot, a shape slot, a BodyPair, an index
///     put(storage, where)     gives them back; a manifold comes into the record whose number is its place in the snapshot
///     is_valid<S>(context)    false for what no world of the scene can have become; context: SavedWorld, SavedBody, ManifoldContext,
///                             EntryContext
struct NoNumbers {
    template <class Each>
    constexpr void numbers(Each&, uint32_t) {}
    template <class S, class... Where>
    void take(const Storage<S>&, const Where&...) {}
    template <class S, class... Where>
    void put(Storage<S>&, const Where&...) const {}
    template <class S, class... Context>
    constexpr bool is_valid(const Context&...) const {
        return true;
    }
};

/// What a feature says where it has nothing to say. Each also has
///     template <class S> static constexpr bool named;           whether the scene names it
///     template <class S, bool present> struct Memory;           a base of Storage; empty where it is not present
struct Feature {
    static constexpr uint32_t part = 0;  ///< its bit of SnapshotHeader::parts, for records with numbers
    using OfWorld = NoNumbers;
    using OfBody = NoNumbers;
    using OfShape = NoNumbers;
    using OfManifold = NoNumbers;
    /// Of a list: how many it has, and what one of them is.
    using OfEntry = NoNumbers;
    static constexpr bool has_entries = false;
    template <class S>
    static constexpr int entry_capacity = 0;
    template <class S>
    static Index entry_count(const Storage<S>&) {
        return 0;
    }
    template <class S>
    static void set_entry_count(Storage<S>&, Index) {}

    /// Hands each trait of the scene that is the feature's to `each`: they make up the signature.
    template <class S, class Each>
    static constexpr void traits(Each&) {}
    /// Sentences for a scene that contradicts itself.
    template <class S>
    static constexpr bool check() {
        return true;
    }
    /// Whether it has something to say of definitions of bodies, in scenes that name it or in those that do not:
    ///     template <class S> static Status check_def(const BodyDef&);
    static constexpr bool checks_definitions = false;
    template <class S>
    static void begin_body(Storage<S>&, int, const BodyDef&) {}
    template <class S>
    static void begin_shape(Storage<S>&, int, const BodyDef&, const ShapePlace&) {}
    /// A body is about to leave its slot: all is as it was.
    template <class S>
    static void before_removal(Storage<S>&, int) {}
    /// What a slot forgets as its body leaves.
    template <class S>
    static void forget_body(Storage<S>&, int) {}
    template <class S>
    static void forget_shape(Storage<S>&, int) {}
    /// Forces that a step of h seconds adds to those that the user has summed.
    template <class S>
    static void sum_forces(Storage<S>&, scalar) {}
    /// What takes motion away, after impacts without friction.
    template <class S>
    static void damp(Storage<S>&, scalar) {}
    template <class S>
    static uint64_t hash_body(const Storage<S>&, int, uint64_t hash) {
        return hash;
    }
    /// Before and after the numbers of a snapshot come into storage, which begins as zero.
    template <class S>
    static void begin_load(Storage<S>&) {}
    template <class S>
    static void finish_load(Storage<S>&) {}
};

/// Some features in their order: a type, and nothing else.
template <class... Some>
struct Picked {};
template <class... First, class... Then>
constexpr Picked<First..., Then...> operator+(Picked<First...>, Picked<Then...>) {
    return {};
}

/// Those of `All` that the scene names. A struct, so that a compiler picks them once for a scene, and not again in every fold.
template <class S, class... All>
struct NamedOf {
    using type = decltype((Picked<>{} + ... + If<All::template named<S>, Picked<All>, Picked<>>()));
};

/// The features there are.
template <class... All>
struct FeatureList {
    using CheckingDefinitions = decltype((Picked<>{} + ... + If<All::checks_definitions, Picked<All>, Picked<>>()));

    /// Calls visit(feature) for each.
    template <class Visit>
    static constexpr void over_all(const Visit& visit) {
        over(Picked<All...>{}, visit);
    }
    /// For those that the scene names.
    template <class S, class Visit>
    static constexpr void over_named(const Visit& visit) {
        over(typename NamedOf<S, All...>::type{}, visit);
    }
    /// For those that check definitions.
    template <class Visit>
    static constexpr void over_checking_definitions(const Visit& visit) {
        over(CheckingDefinitions{}, visit);
    }
    template <class... Some, class Visit>
    static constexpr void over(Picked<Some...>, const Visit& visit) {
        (visit(Some{}), ...);
    }
    /// The memory of all, in the order of the list.
    template <class S>
    struct Memory : All::template Memory<S, All::template named<S>>... {};

    /// True when no two use the same bit of a snapshot's parts.
    static constexpr bool bits_differ(uint32_t others) {
        bool differ = true;
        over_all([&](auto feature) {
            differ = differ && (others & decltype(feature)::part) == 0;
            others |= decltype(feature)::part;
        });
        return differ;
    }
};

}  // namespace features

} }  // namespace ingot
