// SPDX-License-Identifier: MIT
// The state of an island, to the bit, is a function of its own bodies and of what is fixed around them: the same alone and beside anything else.
//
// A test is an engine and a law: `company_test --gtest_filter='HybridIslands.*'`. INGOT_COMPANY in the environment says how much: `brief`, for
// builds beside another that does more; `long`, for the night.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <functional>

#include "gathering.h"
#include "not_yet.h"

namespace {

using namespace company;

/// One of three numbers: for a brief run, also of a brief build (INGOT_TEST_BRIEF), for every day, for a night.
template <class T>
T by_effort(T brief, T daily, T nightly) {
    const char* const effort = std::getenv("INGOT_COMPANY");
    if (effort == nullptr) return INGOT_TEST_BRIEF ? brief : daily;
    return std::strcmp(effort, "brief") == 0 ? brief : nightly;
}

/// The corners of a net of 30 m, some of them far from the origin: what stands there has other roundings.
Vector place(int i) {
    const Vector places[] = {{0, 0, 0}, {30, 0, 0}, {0, -30, 0}, {-30, 30, 0}, {90, 60, 0}, {-60, 0, 0}};
    return i < 6 ? places[i] : Vector{scalar(30 * (i % 5)), scalar(90 + 30 * (i / 5)), 0};
}
scalar h_of(uint64_t i) {
    const scalar rates[] = {60, 30, 120, 240, 1000};
    return 1 / rates[i % 5];
}

std::vector<Party> taken_by(const Engine& engine, const std::vector<Party>& parties) {
    std::vector<Party> taken;
    for (const Party& party : parties)
        if (engine.takes(party)) taken.push_back(party);
    return taken;
}

/// Every number below n once, in an order of its own.
std::vector<int> shuffled(int n, uint64_t seed) {
    std::vector<int> order;
    for (int i = 0; i < n; ++i) order.push_back(i);
    for (int i = n - 1; i > 0; --i) {
        seed = seed * 6364136223846793005u + 1442695040888963407u;
        std::swap(order[static_cast<std::size_t>(i)], order[static_cast<std::size_t>((seed >> 33) % static_cast<uint64_t>(i + 1))]);
    }
    return order;
}

/// What rolls has left its place after eight seconds.
int no_longer_than_8_s(Rate rate, int steps) { return std::min(steps, static_cast<int>(8 / rate.h)); }

void expect_same(const Engine& engine, const Gathering& gathering, const std::vector<int>& watched, Rate rate, int steps) {
    const std::string what = difference_in_company(engine, gathering, watched, rate, steps);
    EXPECT_TRUE(what.empty()) << what;
}

/// All parties in pairs of chance, each of which is compared with itself alone.
void two_parties(const Engine& engine) {
    const std::vector<Party> parties = taken_by(engine, all_parties());
    const int count = static_cast<int>(parties.size());
    for (uint64_t seed = 0; seed < by_effort<uint64_t>(1, 2, 8); ++seed) {
        const std::vector<int> order = shuffled(count, seed);
        for (int pair_i = 0; pair_i < count; pair_i += by_effort(2, 1, 1)) {
            const uint64_t number = seed * 100 + static_cast<uint64_t>(pair_i);
            Gathering two;
            two.guests = {{parties[static_cast<std::size_t>(order[static_cast<std::size_t>(pair_i)])], place(pair_i % 6)},
                          {parties[static_cast<std::size_t>(order[static_cast<std::size_t>((pair_i + 1) % count)])], place((pair_i + 1) % 6)}};
            two.slots = static_cast<Slots>(number % 4);
            two.seed = number;
            two.ground_first = number % 3 != 0;
            const Rate rate = {h_of(number / 2), number % 7 == 6};
            expect_same(engine, two, {0, 1}, rate, no_longer_than_8_s(rate, by_effort(60, 100, 400)));
        }
    }
}

/// Each party beside one that differs from it in solver's eyes as much as can be: it is busy while that is at rest. For longer.
void rest_beside_motion(const Engine& engine) {
    for (const char* name : {"tower_10", "heavy_on_light", "pyramid", "slope", "plate_on_balls", "sugar_cubes"}) {
        const Party still = party(name);
        if (!engine.takes(still)) continue;
        Gathering two;
        two.guests = {{still, {}}, {party("rolling_balls"), {30, 0, 0}}};
        two.slots = Slots::one_by_one;
        expect_same(engine, two, {0}, {scalar(1) / 60}, by_effort(120, 600, 3600));
    }
}

void all_parties_at_once(const Engine& engine) {
    const std::vector<Party> parties = taken_by(engine, all_parties());
    for (int run = 0; run < by_effort(1, 2, 10); ++run) {
        Gathering all;
        std::vector<int> watched;
        for (const int party_i : shuffled(static_cast<int>(parties.size()), static_cast<uint64_t>(run) + 7)) {
            watched.push_back(static_cast<int>(all.guests.size()));
            all.guests.push_back({parties[static_cast<std::size_t>(party_i)], place(static_cast<int>(all.guests.size()))});
        }
        all.seed = static_cast<uint64_t>(run);
        const Rate rate = {h_of(static_cast<uint64_t>(run))};
        expect_same(engine, all, watched, rate, no_longer_than_8_s(rate, by_effort(30, 60, 400)));
    }
}

/// Other slots, other lanes, other tiles: bodies without a shape between those of the party.
void other_slots(const Engine& engine) {
    const std::vector<Party> parties = taken_by(engine, all_parties());
    for (std::size_t i = 0; i < parties.size(); i += by_effort<std::size_t>(3, 1, 1)) {
        Gathering one;
        one.guests = {{parties[i], {}}};
        one.fillers = 5 + static_cast<int>(i % 7);
        one.seed = i;
        expect_same(engine, one, {0}, {h_of(i)}, no_longer_than_8_s({h_of(i)}, by_effort(60, 100, 400)));
    }
}

/// A tower beside balls that fall.
void crowd(const Engine& engine) {
    for (const char* name : {"tower_20", "heavy_on_light"}) {
        const Party watched = party(name);
        Gathering two;
        two.guests = {{watched, {}}, {crowd_of_balls(by_effort(4, 5, 8)), {30, 0, 0}}};
        two.slots = std::strcmp(name, "tower_20") == 0 ? Slots::last_party_first : Slots::shuffled;
        expect_same(engine, two, {0}, {scalar(1) / 60}, by_effort(60, 90, 1200));
        if (by_effort(true, true, false)) continue;
        two.guests[1].party = wall_of_cubes(20);
        expect_same(engine, two, {0}, {scalar(1) / 60}, 1200);
    }
}

/// What stands still, a metre from one another: near enough for a search that is coarse, too far for a contact.
void close_neighbours(const Engine& engine) {
    Gathering row;
    std::vector<int> watched;
    for (const char* name : {"tower_10", "heavy_on_light", "sugar_cubes", "plate_on_balls", "heavy_on_three", "tower_20"}) {
        watched.push_back(static_cast<int>(row.guests.size()));
        row.guests.push_back({party(name), {0, scalar(4 * watched.back()), 0}});
    }
    for (const Slots slots : {Slots::one_by_one, Slots::shuffled}) {
        row.slots = slots;
        expect_same(engine, row, watched, {scalar(1) / 60}, by_effort(30, 90, 600));
    }
}

/// Bodies come, go, are pushed, put elsewhere and frozen, next door.
void restless_neighbours(const Engine& engine) {
    const std::vector<Party> restless = taken_by(engine, restless_parties());
    const std::vector<Party> parties = taken_by(engine, all_parties());
    for (std::size_t i = 0; i < restless.size() * by_effort<std::size_t>(1, 3, parties.size()); ++i) {
        Gathering two;
        two.guests = {{parties[i * 5 % parties.size()], {}}, {restless[i % restless.size()], {0, 30, 0}}};
        two.slots = static_cast<Slots>(i % 4);
        two.seed = i;
        expect_same(engine, two, {0}, {h_of(i % 3)}, 100);
    }
}

/// Who is edited is the same beside others, too: but for those who come late, whose slots depend on who left.
void restless_parties_in_company(const Engine& engine) {
    for (const Party& restless : taken_by(engine, restless_parties())) {
        Gathering two;
        two.guests = {{restless, {-30, 30, 0}}, {party("rolling_balls"), {}}};
        two.slots = Slots::one_by_one;
        if (restless.name == "runaway") continue;  // its place is up to it
        expect_same(engine, two, {0, 1}, {scalar(1) / 60}, 100);
    }
}

/// Asleep, falling asleep and waking, beside those who are awake, fall asleep or wake.
void sleep_and_company(const Engine& engine) {
    std::vector<Party> parties = taken_by(engine, sleepy_parties());
    for (const char* name : {"rolling_balls", "dominoes", "heap_of_boxes", "pyramid"}) parties.push_back(party(name));
    for (std::size_t i = 0; i < parties.size(); ++i)
        for (std::size_t j = 0; j < parties.size(); ++j) {
            if ((i + j) % by_effort<std::size_t>(5, 2, 1) != 0) continue;
            Gathering two;
            two.guests = {{parties[i], place(2)}, {parties[j], place(4)}};
            two.slots = static_cast<Slots>((i + j) % 4);
            two.seed = i;
            const Rate rate = {h_of((i + 2 * j) % 3)};
            expect_same(engine, two, {0, 1}, rate, no_longer_than_8_s(rate, by_effort(60, 120, 600)));
        }
}

struct Law {
    const char* name;
    void (*holds_for)(const Engine& engine);
    bool of_sleep = false;
};
constexpr Law laws[] = {{"two_parties", two_parties},
                        {"rest_beside_motion", rest_beside_motion},
                        {"all_parties_at_once", all_parties_at_once},
                        {"other_slots", other_slots},
                        {"crowd", crowd},
                        {"close_neighbours", close_neighbours},
                        {"restless_neighbours", restless_neighbours},
                        {"restless_parties_in_company", restless_parties_in_company},
                        {"sleep_and_company", sleep_and_company, true}};

class OfCompany : public ::testing::Test {
public:
    OfCompany(const Engine& engine, const Law& law) : engine_(engine), law_(law) {}
    void TestBody() override { law_.holds_for(engine_); }

private:
    const Engine& engine_;
    const Law& law_;
};

bool holds(const std::string& name) {
    for (const char* listed : not_yet)
        if (name == listed) return false;
    return true;
}

/// The program is GoogleTest's own: tests are there before it begins.
const bool registered = [] {
    for (const Engine& engine : engines())
        for (const Law& law : laws) {
            if (law.of_sleep && !engine.sleeps) continue;
            const std::string name = (holds(std::string(engine.name) + "." + law.name) ? "" : "DISABLED_") + std::string(law.name);
            ::testing::RegisterTest(engine.name, name.c_str(), nullptr, nullptr, __FILE__, __LINE__,
                                    [&engine, &law]() -> ::testing::Test* { return new OfCompany(engine, law); });
        }
    return true;
}();

}  // namespace
