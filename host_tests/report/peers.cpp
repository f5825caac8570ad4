// SPDX-License-Identifier: MIT
// Bullet and ODE, as the distribution packages them, on the same bodies and clock as the kernel.
//
// Each engine as it comes: its default gyroscopic term, no damping, no sleeping, one step call of 1/rate s. Energy and L are
// formed from its orientation and angular velocity.
#include <btBulletDynamicsCommon.h>
#include <ode/ode.h>

#include <memory>
#include <vector>

#include "cases.h"
#include "crowd.h"
#include "suites.h"

namespace report {

namespace {

using ingot_reference::FreeBodyCase;

/// What a peer is asked to move: orientation, moments, place and spin, world.
struct PeerBody {
    Orientation A;
    Vector3 I, omega, r;
};

class BulletWorld {
public:
    static constexpr const char* scalar = sizeof(btScalar) == 4 ? "float" : "double";

    explicit BulletWorld(bool shapes) : shapes_(shapes), world_(&dispatcher_, &broadphase_, &solver_, &configuration_) {
        world_.setGravity({0, 0, 0});
    }
    ~BulletWorld() {
        for (const auto& body : bodies_) world_.removeRigidBody(body.get());
    }
    BulletWorld(const BulletWorld&) = delete;
    BulletWorld& operator=(const BulletWorld&) = delete;

    void set_gravity(double g) { world_.setGravity({0, 0, static_cast<btScalar>(-g)}); }

    void add(const PeerBody& body) {
        const Vector3 half = (Vector3::Constant(body.I.sum() / 2) - body.I).cwiseMax(0.01L).cwiseSqrt();
        btCollisionShape* shape = &empty_;
        if (shapes_) {
            boxes_.push_back(std::make_unique<btBoxShape>(vector(half)));
            shape = boxes_.back().get();
        }
        bodies_.push_back(
            std::make_unique<btRigidBody>(btRigidBody::btRigidBodyConstructionInfo(1, nullptr, shape, vector(body.I))));
        btRigidBody& added = *bodies_.back();
        btTransform pose;
        pose.setOrigin(vector(body.r));
        btMatrix3x3 basis;
        for (int row = 0; row < 3; ++row) basis[row] = vector(body.A.row(row).transpose());
        pose.setBasis(basis);
        added.setWorldTransform(pose);
        added.setAngularVelocity(vector(body.omega));
        added.setDamping(0, 0);
        added.setActivationState(DISABLE_DEACTIVATION);
        world_.addRigidBody(&added);
    }

    void step(double h) { world_.stepSimulation(static_cast<btScalar>(h), 0); }

    Orientation A() const {
        Orientation a;
        const btMatrix3x3& basis = bodies_[0]->getWorldTransform().getBasis();
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 3; ++column) a(row, column) = basis[row][column];
        return a;
    }
    Vector3 omega() const {
        const btVector3& w = bodies_[0]->getAngularVelocity();
        return {w.x(), w.y(), w.z()};
    }

private:
    static btVector3 vector(const Vector3& v) {
        return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
    }

    bool shapes_;
    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadphase_;
    btSequentialImpulseConstraintSolver solver_;
    btDiscreteDynamicsWorld world_;
    btEmptyShape empty_;
    std::vector<std::unique_ptr<btBoxShape>> boxes_;
    std::vector<std::unique_ptr<btRigidBody>> bodies_;
};

class OdeWorld {
public:
    static constexpr const char* scalar = sizeof(dReal) == 4 ? "float" : "double";

    explicit OdeWorld(bool) { world_ = dWorldCreate(); }
    ~OdeWorld() { dWorldDestroy(world_); }
    OdeWorld(const OdeWorld&) = delete;
    OdeWorld& operator=(const OdeWorld&) = delete;

    void set_gravity(double g) { dWorldSetGravity(world_, 0, 0, static_cast<dReal>(-g)); }

    void add(const PeerBody& body) {
        const auto real = [](long double x) { return static_cast<dReal>(x); };
        const dBodyID added = dBodyCreate(world_);
        dMass mass;
        dMassSetParameters(&mass, 1, 0, 0, 0, real(body.I.x()), real(body.I.y()), real(body.I.z()), 0, 0, 0);
        dBodySetMass(added, &mass);
        dMatrix3 R = {};
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 3; ++column) R[4 * row + column] = real(body.A(row, column));
        dBodySetRotation(added, R);
        dBodySetPosition(added, real(body.r.x()), real(body.r.y()), real(body.r.z()));
        dBodySetAngularVel(added, real(body.omega.x()), real(body.omega.y()), real(body.omega.z()));
        if (first_ == nullptr) first_ = added;
    }

    void step(double h) { dWorldQuickStep(world_, static_cast<dReal>(h)); }

    Orientation A() const {
        Orientation a;
        const dReal* const R = dBodyGetRotation(first_);
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 3; ++column) a(row, column) = R[4 * row + column];
        return a;
    }
    Vector3 omega() const {
        const dReal* const w = dBodyGetAngularVel(first_);
        return {w[0], w[1], w[2]};
    }

private:
    dWorldID world_;
    dBodyID first_ = nullptr;
};

template <class World>
FlightErrors flown(const FreeBodyCase& body, int rate) {
    World world(false);
    world.add({body.A_0, body.I, body.A_0 * body.w_body_0, Vector3::Zero()});
    const auto L = [&] { return Vector3(world.A() * body.I.cwiseProduct(world.A().transpose() * world.omega())); };
    ErrorTally tally(body, world.A(), L());
    long steps = 0;
    for (const FreeBodyCase::Sample& sample : body.samples) {
        const long double due = sample.t * rate;
        if (due != std::floor(due)) continue;
        for (; steps < static_cast<long>(due); ++steps) world.step(1.0 / rate);
        tally.see(sample, world.A(), L());
    }
    return tally.errors;
}

template <class World>
double ns_of_crowd(int bodies, bool shapes, bool quick) {
    World world(shapes);
    world.set_gravity(9.81);
    Crowd crowd;
    for (int body_i = 0; body_i < bodies; ++body_i) {
        const CrowdBody body = crowd.next();
        world.add({Orientation::Identity(), body.I.cast<long double>(), body.omega_body.cast<long double>(),
                   body.r.cast<long double>()});
    }
    world.step(1.0 / 60);  // memory is taken in the first step
    const int steps = quick ? 10 : 60;
    return least_ns(5,
                    [&] {
                        for (int step_i = 0; step_i < steps; ++step_i) world.step(1.0 / 60);
                    }) /
           steps / bodies;
}

template <class World>
void add_flights(const Settings& settings, const std::string& engine, Progress& progress, Rows& rows) {
    for (const char* name : {"book", "dzhanibekov"}) {
        progress.begin("peers " + engine + " " + name);
        const FreeBodyCase body("free_asymmetric", name);
        for (const int rate : {15, 30, 60, 120, 240, 960})
            if (!settings.quick || rate <= 240)
                add_errors(flown<World>(body, rate), {"peers", name, engine, World::scalar, 1, "host", 1.0 / rate, "", 0, ""},
                           rows);
    }
}

template <class World>
void add_cost(const Settings& settings, const std::string& engine, bool shapes, Progress& progress, Rows& rows) {
    progress.begin("peers " + engine + " bodies_4096");
    rows.add({"peers", "bodies_4096", engine, World::scalar, 1, "host", 1.0 / 60, "ns_per_body_step",
              ns_of_crowd<World>(4096, shapes, settings.quick), "ns"});
}

}  // namespace

void fly_peers(const Settings& settings, const std::vector<Variant>& variants, Progress& progress, Rows& rows) {
    dInitODE2(0);
    add_flights<BulletWorld>(settings, "bullet", progress, rows);
    add_flights<OdeWorld>(settings, "ode", progress, rows);
    add_cost<BulletWorld>(settings, "bullet", true, progress, rows);
    add_cost<BulletWorld>(settings, "bullet_no_shapes", false, progress, rows);
    add_cost<OdeWorld>(settings, "ode", false, progress, rows);
    // The kernel once more, so that both sides of each ratio were measured within seconds.
    for (const Variant& variant : variants) {
        progress.begin("peers default " + variant.scalar + " x " + std::to_string(variant.lanes));
        rows.add({"peers", "bodies_4096", "default", variant.scalar, variant.lanes, "host", 1.0 / 60, "ns_per_body_step",
                  variant.throughput(4096, settings.quick), "ns"});
    }
    dCloseODE();
}

}  // namespace report
