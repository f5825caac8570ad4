// SPDX-License-Identifier: MIT
// The distribution's Bullet and ODE on the cases of the report: the same bodies, the same rates, the same run.
#include <btBulletDynamicsCommon.h>
#include <ode/ode.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <memory>

#include "reference/measure.h"
#include "suites.h"

namespace report {

namespace {

using ingot_reference::FreeBodyCase;
using Matrix3 = FreeBodyCase::Matrix3;
using Vector3 = FreeBodyCase::Vector3;

/// One engine with some bodies that float free. Defaults of the engine, but for sleeping and damping, which are off.
class Bullet {
public:
    static constexpr const char* name = "Bullet 3.24";
    static constexpr const char* scalar = "float";

    Bullet() : world_(&dispatcher_, &broad_phase_, &solver_, &configuration_) { world_.setGravity(btVector3(0, 0, 0)); }
    ~Bullet() {
        for (const auto& body : bodies_) world_.removeRigidBody(body.get());
    }
    void add(const Vector3& I, const Matrix3& A, const Vector3& w, const Vector3& r) {
        const auto f = [](long double x) { return static_cast<btScalar>(x); };
        btRigidBody::btRigidBodyConstructionInfo info(1, nullptr, &shape_, btVector3(f(I.x()), f(I.y()), f(I.z())));
        info.m_startWorldTransform.setBasis(btMatrix3x3(f(A(0, 0)), f(A(0, 1)), f(A(0, 2)), f(A(1, 0)), f(A(1, 1)), f(A(1, 2)), f(A(2, 0)), f(A(2, 1)), f(A(2, 2))));
        info.m_startWorldTransform.setOrigin(btVector3(f(r.x()), f(r.y()), f(r.z())));
        bodies_.push_back(std::make_unique<btRigidBody>(info));
        const Vector3 w_world = A * w;
        bodies_.back()->setAngularVelocity(btVector3(f(w_world.x()), f(w_world.y()), f(w_world.z())));
        bodies_.back()->setActivationState(DISABLE_DEACTIVATION);
        world_.addRigidBody(bodies_.back().get());
    }
    void step(double h) { world_.stepSimulation(static_cast<btScalar>(h), 0); }
    Matrix3 A(std::size_t i) const {
        const btMatrix3x3& b = bodies_[i]->getWorldTransform().getBasis();
        Matrix3 A;
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 3; ++column) A(row, column) = static_cast<long double>(b[row][column]);
        return A;
    }
    Vector3 w(std::size_t i) const {
        const btVector3& w = bodies_[i]->getAngularVelocity();
        return {static_cast<long double>(w.x()), static_cast<long double>(w.y()), static_cast<long double>(w.z())};
    }

private:
    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broad_phase_;
    btSequentialImpulseConstraintSolver solver_;
    btDiscreteDynamicsWorld world_;
    btBoxShape shape_{btVector3(btScalar(0.5), btScalar(0.5), btScalar(0.5))};
    std::vector<std::unique_ptr<btRigidBody>> bodies_;
};

class Ode {
public:
    static constexpr const char* name = "ODE 0.16, QuickStep";
    static constexpr const char* scalar = "double";

    Ode() : world_((dInitODE2(0), dWorldCreate())) { dWorldSetAutoDisableFlag(world_, 0); }
    ~Ode() {
        dWorldDestroy(world_);
        dCloseODE();
    }
    void add(const Vector3& I, const Matrix3& A, const Vector3& w, const Vector3& r) {
        const auto f = [](long double x) { return static_cast<dReal>(x); };
        const dBodyID body = dBodyCreate(world_);
        dMass mass;
        dMassSetParameters(&mass, 1, 0, 0, 0, f(I.x()), f(I.y()), f(I.z()), 0, 0, 0);
        dBodySetMass(body, &mass);
        const dMatrix3 R = {f(A(0, 0)), f(A(0, 1)), f(A(0, 2)), 0, f(A(1, 0)), f(A(1, 1)), f(A(1, 2)), 0, f(A(2, 0)), f(A(2, 1)), f(A(2, 2)), 0};
        dBodySetRotation(body, R);
        dBodySetPosition(body, f(r.x()), f(r.y()), f(r.z()));
        const Vector3 w_world = A * w;
        dBodySetAngularVel(body, f(w_world.x()), f(w_world.y()), f(w_world.z()));
        bodies_.push_back(body);
    }
    void step(double h) { dWorldQuickStep(world_, static_cast<dReal>(h)); }
    Matrix3 A(std::size_t i) const {
        const dReal* R = dBodyGetRotation(bodies_[i]);
        Matrix3 A;
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 3; ++column) A(row, column) = static_cast<long double>(R[4 * row + column]);
        return A;
    }
    Vector3 w(std::size_t i) const {
        const dReal* w = dBodyGetAngularVel(bodies_[i]);
        return {static_cast<long double>(w[0]), static_cast<long double>(w[1]), static_cast<long double>(w[2])};
    }

private:
    dWorldID world_;
    std::vector<dBodyID> bodies_;
};

template <class Engine>
void fly(const char* name, Rows& rows) {
    const FreeBodyCase body("free_asymmetric", name);
    for (const int rate : {15, 60, 240, 960}) {
        Engine engine;
        engine.add(body.I, body.A_0, body.w_body_0, Vector3::Zero());
        const auto energy = [&] {
            const Vector3 w = engine.A(0).transpose() * engine.w(0);
            return w.dot(body.I.cwiseProduct(w)) / 2;
        };
        const long double begin = body.w_body_0.dot(body.I.cwiseProduct(body.w_body_0)) / 2;
        double attitude = 0, lost = 0;
        long steps = 0;
        for (const FreeBodyCase::Sample& sample : body.samples) {
            const long double due = sample.t * rate;
            if (due != std::floor(due)) continue;
            for (; steps < static_cast<long>(due); ++steps) engine.step(1.0 / rate);
            attitude = std::max(attitude, ingot_reference::attitude_error(engine.A(0), sample.A));
            lost = std::max(lost, static_cast<double>(std::abs(energy() / begin - 1)));
        }
        rows.add({"peers", name, Engine::name, Engine::scalar, 1, "host", 1.0 / rate, "attitude_error", attitude, "rad"});
        rows.add({"peers", name, Engine::name, Engine::scalar, 1, "host", 1.0 / rate, "energy_error", lost, "1"});
    }
}

template <class Engine>
void time_bodies(const Settings& settings, Rows& rows) {
    constexpr int bodies = 4096;
    Engine engine;
    unsigned seed = 1997;
    const auto random = [&] {
        seed = seed * 1664525u + 1013904223u;
        return static_cast<long double>(seed >> 8) / (1 << 24) * 2 - 1;
    };
    for (int body_i = 0; body_i < bodies; ++body_i)
        engine.add(Vector3(1, 2, 2.5L), Matrix3::Identity(), Vector3(3 * random(), 3 * random(), 3 * random()),
                   Vector3(3 * (body_i % 16), 3 * (body_i / 16 % 16), 3 * (body_i / 256)));
    double least = std::numeric_limits<double>::infinity();
    for (int repetition_i = 0; repetition_i < 7; ++repetition_i) {
        const int steps = settings.quick ? 5 : 30;
        const auto begin = std::chrono::steady_clock::now();
        for (int step_i = 0; step_i < steps; ++step_i) engine.step(1.0 / 60);
        const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - begin;
        least = std::min(least, time.count() / steps / bodies);
    }
    rows.add({"peers", "bodies_4096", Engine::name, Engine::scalar, 1, "host", 1.0 / 60, "ns_per_body_step", least, "ns"});
}

}  // namespace

void run_peers(const Settings& settings, Rows& rows) {
    Progress progress(4);
    progress.begin("peers Bullet");
    fly<Bullet>("book", rows);
    fly<Bullet>("dzhanibekov", rows);
    time_bodies<Bullet>(settings, rows);
    progress.begin("peers ODE");
    fly<Ode>("book", rows);
    fly<Ode>("dzhanibekov", rows);
    time_bodies<Ode>(settings, rows);
}

}  // namespace report
