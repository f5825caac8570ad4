// SPDX-License-Identifier: MIT
// Bullet and ODE as the distribution packages them.

#include <btBulletDynamicsCommon.h>
#include <ode/ode.h>

#include <algorithm>
#include <cmath>

#include "contact_peers.h"

namespace report {

PeerEngine peer_bullet();
PeerEngine peer_ode();

namespace {

/// Sequential impulses with 10 iterations, split impulse, implicit gyroscopic term, one bounding-box tree.
class BulletRun final : public ContactRun {
public:
    explicit BulletRun(const ContactCase& scene) : world_(&dispatcher_, &broadphase_, &solver_, &configuration_) {
        world_.setGravity(vector(scene.gravity));
        for (const SceneBody& body : scene.bodies) add(body);
    }
    ~BulletRun() override {
        for (const auto& body : bodies_) world_.removeRigidBody(body.get());
    }
    BulletRun(const BulletRun&) = delete;
    BulletRun& operator=(const BulletRun&) = delete;

    void step(int rate) override { world_.stepSimulation(btScalar(1) / static_cast<btScalar>(rate), 0); }

    void read(std::vector<BodyPose>& poses) const override {
        poses.resize(bodies_.size());
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            const btTransform& pose = bodies_[i]->getWorldTransform();
            const btVector3 &v = bodies_[i]->getLinearVelocity(), &omega = bodies_[i]->getAngularVelocity();
            for (int row = 0; row < 3; ++row) {
                for (int column = 0; column < 3; ++column)
                    poses[i].A[3 * column + row] = static_cast<double>(pose.getBasis()[row][column]);
                poses[i].r[row] = static_cast<double>(pose.getOrigin()[row]);
                poses[i].v[row] = static_cast<double>(v[row]);
                poses[i].omega[row] = static_cast<double>(omega[row]);
            }
        }
    }

private:
    static btVector3 vector(const double (&v)[3]) {
        return {static_cast<btScalar>(v[0]), static_cast<btScalar>(v[1]), static_cast<btScalar>(v[2])};
    }

    void add(const SceneBody& body) {
        btTransform pose;
        pose.setOrigin(vector(body.r));
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 3; ++column)
                pose.getBasis()[row][column] = static_cast<btScalar>(body.A[3 * column + row]);
        if (body.solid == Solid::ball) {
            shapes_.push_back(std::make_unique<btSphereShape>(static_cast<btScalar>(body.size[0])));
        } else if (body.solid == Solid::capsule) {
            shapes_.push_back(std::make_unique<btCapsuleShapeZ>(static_cast<btScalar>(body.size[0]), static_cast<btScalar>(2 * body.size[1])));
        } else if (body.solid == Solid::box) {
            shapes_.push_back(std::make_unique<btBoxShape>(vector(body.size)));
        } else {
            place_slab(vector(body.size), static_cast<btScalar>(body.offset), pose);
        }
        const btScalar M = body.immovable ? 0 : static_cast<btScalar>(body.M);
        btRigidBody::btRigidBodyConstructionInfo info(M, nullptr, shapes_.back().get(),
                                                      body.immovable ? btVector3(0, 0, 0) : vector(body.I));
        info.m_startWorldTransform = pose;
        info.m_friction = static_cast<btScalar>(std::sqrt(body.mu));  // of a pair the product counts
        info.m_restitution = static_cast<btScalar>(std::sqrt(body.e));
        bodies_.push_back(std::make_unique<btRigidBody>(info));
        bodies_.back()->setDamping(0, 0);
        bodies_.back()->setActivationState(DISABLE_DEACTIVATION);
        world_.addRigidBody(bodies_.back().get());
    }

    /// Ground and walls are slabs 2 m thick, as games build them: boxes rest on them with four points at once.
    void place_slab(const btVector3& n, btScalar offset, btTransform& pose) {
        const btScalar half = 40;
        shapes_.push_back(std::make_unique<btBoxShape>(btVector3(half, half, 1)));
        pose.setOrigin(n * (offset - 1));
        pose.setRotation(shortestArcQuat(btVector3(0, 0, 1), n));
    }

    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadphase_;
    btSequentialImpulseConstraintSolver solver_;
    btDiscreteDynamicsWorld world_;
    std::vector<std::unique_ptr<btCollisionShape>> shapes_;
    std::vector<std::unique_ptr<btRigidBody>> bodies_;
};

/// Quick step with 20 iterations, contacts of mode Approx1 (Coulomb), at most 8 a pair, hash space.
class OdeRun final : public ContactRun {
public:
    explicit OdeRun(const ContactCase& scene)
        : mu_(scene.bodies.back().mu),
          e_(scene.bodies.back().e),
          world_(dWorldCreate()),
          space_(dHashSpaceCreate(nullptr)),
          contacts_(dJointGroupCreate(0)) {
        dWorldSetGravity(world_, real(scene.gravity[0]), real(scene.gravity[1]), real(scene.gravity[2]));
        for (const SceneBody& body : scene.bodies) add(body);
    }
    ~OdeRun() override {
        dJointGroupDestroy(contacts_);
        dSpaceDestroy(space_);
        dWorldDestroy(world_);
    }
    OdeRun(const OdeRun&) = delete;
    OdeRun& operator=(const OdeRun&) = delete;

    void step(int rate) override {
        dSpaceCollide(space_, this, &collide);
        dWorldQuickStep(world_, dReal(1) / static_cast<dReal>(rate));
        dJointGroupEmpty(contacts_);
    }

    void read(std::vector<BodyPose>& poses) const override {
        poses.assign(bodies_.size(), {});
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            if (bodies_[i] == nullptr) continue;
            const dReal *const R = dBodyGetRotation(bodies_[i]), *const r = dBodyGetPosition(bodies_[i]),
                               *const v = dBodyGetLinearVel(bodies_[i]), *const omega = dBodyGetAngularVel(bodies_[i]);
            for (int row = 0; row < 3; ++row) {
                for (int column = 0; column < 3; ++column)
                    poses[i].A[3 * column + row] = static_cast<double>(R[4 * row + column]);
                poses[i].r[row] = static_cast<double>(r[row]);
                poses[i].v[row] = static_cast<double>(v[row]);
                poses[i].omega[row] = static_cast<double>(omega[row]);
            }
        }
    }

private:
    static dReal real(double x) { return static_cast<dReal>(x); }

    void add(const SceneBody& body) {
        const double* const size = body.size;
        if (body.solid == Solid::half_space) {
            dCreatePlane(space_, real(size[0]), real(size[1]), real(size[2]), real(body.offset));
            bodies_.push_back(nullptr);
            return;
        }
        const dGeomID geom = body.solid == Solid::ball      ? dCreateSphere(space_, real(size[0]))
                             : body.solid == Solid::capsule ? dCreateCapsule(space_, real(size[0]), real(2 * size[1]))
                                                            : dCreateBox(space_, real(2 * size[0]), real(2 * size[1]), real(2 * size[2]));
        const dBodyID added = dBodyCreate(world_);
        dMass mass;
        dMassSetParameters(&mass, real(body.M), 0, 0, 0, real(body.I[0]), real(body.I[1]), real(body.I[2]), 0, 0, 0);
        dBodySetMass(added, &mass);
        dMatrix3 R = {};
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 3; ++column) R[4 * row + column] = real(body.A[3 * column + row]);
        dGeomSetBody(geom, added);
        dBodySetRotation(added, R);
        dBodySetPosition(added, real(body.r[0]), real(body.r[1]), real(body.r[2]));
        bodies_.push_back(added);
    }

    static void collide(void* data, dGeomID a, dGeomID b) {
        OdeRun& run = *static_cast<OdeRun*>(data);
        if (dGeomGetBody(a) == nullptr && dGeomGetBody(b) == nullptr) return;
        dContact contacts[8];
        const int count = dCollide(a, b, 8, &contacts[0].geom, sizeof(dContact));
        for (int i = 0; i < count; ++i) {
            contacts[i].surface = {};
            contacts[i].surface.mode = dContactApprox1 | dContactBounce;
            contacts[i].surface.mu = real(run.mu_);
            contacts[i].surface.bounce = real(run.e_);
            dJointAttach(dJointCreateContact(run.world_, run.contacts_, &contacts[i]), dGeomGetBody(a), dGeomGetBody(b));
        }
    }

    double mu_, e_;
    dWorldID world_;
    dSpaceID space_;
    dJointGroupID contacts_;
    std::vector<dBodyID> bodies_;  ///< null: immovable
};

}  // namespace

PeerEngine peer_bullet() {
    return {"bullet", sizeof(btScalar) == 4 ? "float" : "double",
            [](const ContactCase& scene) { return std::make_unique<BulletRun>(scene); }};
}

PeerEngine peer_ode() {
    struct Library {
        Library() { dInitODE2(0); }
        ~Library() { dCloseODE(); }
    };
    static const Library library;
    return {"ode", sizeof(dReal) == 4 ? "float" : "double",
            [](const ContactCase& scene) { return std::make_unique<OdeRun>(scene); }};
}

}  // namespace report
