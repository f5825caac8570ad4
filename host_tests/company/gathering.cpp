// SPDX-License-Identifier: MIT
#include "gathering.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <iomanip>
#include <sstream>

#include "engine_world.h"

namespace company {

void refuse(ingot::Status status) {
    std::fprintf(stderr, "company: a call was refused with status %d\n", static_cast<int>(status));
    std::abort();
}

const std::vector<Engine>& engines() {
    static const std::vector<Engine> all = [] {
        std::vector<Engine> list;
        for (const auto& some : {engines_of_sweeps(), engines_of_islands(), engines_of_points()}) list.insert(list.end(), some.begin(), some.end());
        return list;
    }();
    return all;
}

namespace {

/// Knuth's generator, as in scenes/random.h, for choices.
class Dice {
public:
    explicit Dice(uint64_t seed) : state_(seed * 2 + 1) {}
    int below(int n) {
        state_ = state_ * 6364136223846793005u + 1442695040888963407u;
        return static_cast<int>((state_ >> 33) % static_cast<uint64_t>(n));
    }

private:
    uint64_t state_;
};

constexpr int filler = -1;

/// Whose turn it is, slot by slot.
std::vector<int> order_of_slots(const Gathering& gathering) {
    std::vector<int> order;
    std::vector<std::size_t> left;
    const auto waits = [](std::size_t members) { return members > 0; };
    for (const Guest& guest : gathering.guests) left.push_back(guest.party.members.size());
    const int count = static_cast<int>(left.size());
    Dice dice(gathering.seed);
    for (int turn = 0; std::any_of(left.begin(), left.end(), waits); ++turn) {
        int guest_i = turn % count;
        if (gathering.slots == Slots::shuffled) guest_i = dice.below(count);
        if (gathering.slots == Slots::party_by_party) guest_i = static_cast<int>(std::find_if(left.begin(), left.end(), waits) - left.begin());
        if (gathering.slots == Slots::last_party_first)
            guest_i = count - 1 - static_cast<int>(std::find_if(left.rbegin(), left.rend(), waits) - left.rbegin());
        if (left[static_cast<std::size_t>(guest_i)] == 0) continue;
        --left[static_cast<std::size_t>(guest_i)];
        order.push_back(guest_i);
    }
    for (int i = 0; i < gathering.fillers; ++i) order.insert(order.begin() + dice.below(static_cast<int>(order.size()) + 1), filler);
    return order;
}

/// A world with guests in it, step by step.
class Played {
public:
    Played(const Engine& engine, const Gathering& gathering) : world_(engine.make()), gathering_(gathering) {
        expect(world_->set_gravity({0, 0, -scenes::standard_gravity}));
        for (const Guest& guest : gathering.guests) ids_.emplace_back(guest.party.members.size());
        const Member ground = {scenes::flat_ground(scalar(0.6))};
        if (gathering.ground_first) ground_ = add(ground, {});
        std::vector<std::size_t> next(gathering.guests.size());
        int fillers = 0;
        for (const int guest_i : order_of_slots(gathering)) {
            if (guest_i == filler) {
                add_filler(fillers++);
                continue;
            }
            const std::size_t g = static_cast<std::size_t>(guest_i), member_i = next[g]++;
            if (gathering.guests[g].party.members[member_i].born == 0) join(g, member_i);
        }
        if (!gathering.ground_first) ground_ = add(ground, {});
    }

    ingot::StepReport step(scalar h) {
        for (std::size_t g = 0; g < gathering_.guests.size(); ++g) {
            const Party& party = gathering_.guests[g].party;
            for (std::size_t member_i = 0; member_i < party.members.size(); ++member_i)
                if (step_i_ > 0 && party.members[member_i].born == step_i_) join(g, member_i);
            for (const Edit& edit : party.edits) {
                const ingot::BodyId id = ids_[g][static_cast<std::size_t>(edit.member)];
                const bool now = step_i_ >= edit.step && step_i_ < edit.step + edit.count;
                if (now && world_->state(id).ok()) world_->edit(id, edit, gathering_.guests[g].place);
            }
        }
        ++step_i_;
        return world_->step(h);
    }

    ingot::Result<ingot::BodyState> state(int guest_i, std::size_t member_i) const {
        return world_->state(ids_[static_cast<std::size_t>(guest_i)][member_i]);
    }
    bool is_asleep(int guest_i, std::size_t member_i) const { return world_->is_asleep(ids_[static_cast<std::size_t>(guest_i)][member_i]); }

    /// The events of the last step in which a member of the guest takes part, with members for bodies. The ground is member -1.
    std::string events_of(int guest_i) const {
        const std::vector<ingot::BodyId>& ids = ids_[static_cast<std::size_t>(guest_i)];
        const auto member = [&](ingot::BodyId id) {
            return id == ground_ ? -1 : static_cast<int>(std::find(ids.begin(), ids.end(), id) - ids.begin());
        };
        std::string told;
        for (const ingot::Event& event : world_->events()) {
            const int A = member(event.A), B = member(event.B), nobody = static_cast<int>(ids.size());
            if (A == nobody || B == nobody) continue;
            std::ostringstream line;
            line << static_cast<int>(event.kind) << ' ' << A << '/' << int(event.shape_A) << ' ' << B << '/' << int(event.shape_B);
            if (event.kind == ingot::EventKind::begin || event.kind == ingot::EventKind::hit)
                line << std::hexfloat << ' ' << event.P.x << ' ' << event.P.y << ' ' << event.P.z << ' ' << event.n.x << ' ' << event.n.y << ' '
                     << event.n.z << ' ' << event.speed;
            told += line.str() + "; ";
        }
        return told;
    }

private:
    static void expect(ingot::Status status) {
        if (status != ingot::Status::ok) refuse(status);
    }
    ingot::BodyId add(const Member& member, const Vector& place) {
        const ingot::Result<ingot::BodyId> id = world_->add(member, place);
        expect(id.status);
        return id.value;
    }
    void join(std::size_t guest_i, std::size_t member_i) {
        const Guest& guest = gathering_.guests[guest_i];
        ids_[guest_i][member_i] = add(guest.party.members[member_i], guest.place);
    }
    void add_filler(int filler_i) {
        Member body = {scenes::solid_ball(1, scalar(0.5), {scalar(2 * filler_i), 500, 2000}, 0)};
        body.body.def.shape = {};
        body.body.move({1, 0, 0}, {scalar(filler_i), 1, 0});
        (void)add(body, {});
    }

    std::unique_ptr<AnyWorld> world_;
    Gathering gathering_;
    std::vector<std::vector<ingot::BodyId>> ids_;
    ingot::BodyId ground_ = {};
    int step_i_ = 0;
};

/// What differs between two states, with both numbers; empty if nothing does.
std::string difference(const ingot::BodyState& alone, const ingot::BodyState& here) {
    constexpr int count = sizeof(ingot::BodyState) / sizeof(scalar);
    static_assert(count * sizeof(scalar) == sizeof(ingot::BodyState) && count == 18, "three vectors and a matrix");
    const char* const names[count] = {"r_CM.x", "r_CM.y", "r_CM.z", "v_CM.x", "v_CM.y", "v_CM.z", "A.c0.x", "A.c0.y", "A.c0.z",
                                      "A.c1.x", "A.c1.y", "A.c1.z", "A.c2.x", "A.c2.y", "A.c2.z", "L.x",    "L.y",    "L.z"};
    scalar a[count], b[count];
    std::memcpy(a, &alone, sizeof alone);
    std::memcpy(b, &here, sizeof here);
    for (int i = 0; i < count; ++i) {
        if (std::memcmp(a + i, b + i, sizeof(scalar)) == 0) continue;
        std::ostringstream text;
        text << names[i] << std::setprecision(9) << " is " << b[i] << " and alone " << a[i] << ", " << std::setprecision(2) << b[i] - a[i];
        return text.str();
    }
    return "";
}

bool is_finite_state(const ingot::BodyState& state) { return state.r_CM.x - state.r_CM.x == 0 && state.r_CM.y - state.r_CM.y == 0; }

bool keeps_its_place(const Guest& guest, const ingot::BodyState& state) {
    const scalar x = state.r_CM.x - guest.place.x, y = state.r_CM.y - guest.place.y;
    return is_finite_state(state) && x * x + y * y < Party::reach * Party::reach;
}

bool all_keep_their_place(const Guest& guest, const Played& alone) {
    for (std::size_t member_i = 0; member_i < guest.party.members.size(); ++member_i) {
        const ingot::Result<ingot::BodyState> state = alone.state(0, member_i);
        if (state.ok() && !keeps_its_place(guest, state.value)) return false;
    }
    return true;
}

std::string difference_of(const Guest& guest, const Played& alone, const Played& all, int guest_i) {
    for (std::size_t member_i = 0; member_i < guest.party.members.size(); ++member_i) {
        const ingot::Result<ingot::BodyState> one = alone.state(0, member_i), other = all.state(guest_i, member_i);
        if (one.ok() != other.ok()) return "body " + std::to_string(member_i) + " is gone in one of them";
        if (!one.ok()) continue;
        const std::string what = difference(one.value, other.value);
        if (!what.empty()) return "body " + std::to_string(member_i) + ": " + what;
        if (alone.is_asleep(0, member_i) != all.is_asleep(guest_i, member_i)) return "body " + std::to_string(member_i) + " sleeps in one of them";
    }
    const std::string told_alone = alone.events_of(0), told = all.events_of(guest_i);
    return told == told_alone ? "" : "events are " + told + "and alone " + told_alone;
}

std::string company_of(const Gathering& gathering, int guest_i) {
    std::string names;
    if (gathering.guests.size() > 4) return std::to_string(gathering.guests.size() - 1) + " others";
    for (std::size_t other = 0; other < gathering.guests.size(); ++other)
        if (static_cast<int>(other) != guest_i) names += (names.empty() ? "" : " and ") + gathering.guests[other].party.name;
    return names.empty() ? "bodies without a shape" : names;
}

}  // namespace

std::string difference_in_company(const Engine& engine, const Gathering& gathering, const std::vector<int>& watched, Rate rate, int steps) {
    Played all(engine, gathering);
    std::vector<Played> alone;
    for (const int guest_i : watched) {
        Gathering one = gathering;
        one.guests = {gathering.guests[static_cast<std::size_t>(guest_i)]};
        one.fillers = 0;
        alone.emplace_back(engine, one);
    }
    for (int step_i = 0; step_i < steps; ++step_i) {
        const ingot::StepReport report = all.step(rate.of_step(step_i));
        for (std::size_t i = 0; i < watched.size(); ++i) {
            const Guest& guest = gathering.guests[static_cast<std::size_t>(watched[i])];
            (void)alone[i].step(rate.of_step(step_i));
            std::string what = difference_of(guest, alone[i], all, watched[i]);
            if (!all_keep_their_place(guest, alone[i])) {
                if (!engine.has_friction) return "";
                what += " somebody left the place, alone: a fault of the test, or of the kernel";
            }
            if (what.empty()) continue;
            if (report.contacts_lost > 0) what += " (the world is full: a fault of the test)";
            std::ostringstream where;
            where << engine.name << ", " << 1 / rate.h << " Hz" << (rate.varies ? ", varying" : "") << ", seed " << gathering.seed << ", step "
                  << step_i << ": " << guest.party.name << " beside " << company_of(gathering, watched[i]) << ": " << what;
            return where.str();
        }
    }
    return "";
}

}  // namespace company
