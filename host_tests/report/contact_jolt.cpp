// SPDX-License-Identifier: MIT
// Jolt in float: 10 velocity and 2 position steps, one collision step, and all other PhysicsSettings as they come but sleep; bodies as
// BodyCreationSettings has them, without its damping. Its job system of one thread.
#include <Jolt/Jolt.h>

#include <Jolt/Core/Factory.h>
#include <Jolt/Core/JobSystemSingleThreaded.h>
#include <Jolt/Core/TempAllocator.h>
#include <Jolt/Physics/Body/Body.h>
#include <Jolt/Physics/Body/BodyCreationSettings.h>
#include <Jolt/Physics/Collision/BroadPhase/BroadPhaseLayerInterfaceTable.h>
#include <Jolt/Physics/Collision/BroadPhase/ObjectVsBroadPhaseLayerFilterTable.h>
#include <Jolt/Physics/Collision/ObjectLayerPairFilterTable.h>
#include <Jolt/Physics/Collision/Shape/BoxShape.h>
#include <Jolt/Physics/Collision/Shape/CapsuleShape.h>
#include <Jolt/Physics/Collision/Shape/SphereShape.h>
#include <Jolt/Physics/PhysicsSystem.h>
#include <Jolt/RegisterTypes.h>

#include <algorithm>

#include "contact_peers.h"

namespace report {

PeerEngine peer_jolt();

namespace {

using JPH::Vec3;

float real(double x) { return static_cast<float>(x); }
Vec3 vector(const double* v) { return {real(v[0]), real(v[1]), real(v[2])}; }

/// Bodies that move meet all; ground and walls meet those only. One tree of bounds for each, as Jolt's own first example has them.
enum Layer : JPH::ObjectLayer { fixed, moving, layer_count };

struct Layers {
    Layers() {
        pairs.EnableCollision(moving, moving);
        pairs.EnableCollision(moving, fixed);
        trees.MapObjectToBroadPhaseLayer(fixed, JPH::BroadPhaseLayer(fixed));
        trees.MapObjectToBroadPhaseLayer(moving, JPH::BroadPhaseLayer(moving));
    }
    JPH::ObjectLayerPairFilterTable pairs{layer_count};
    JPH::BroadPhaseLayerInterfaceTable trees{layer_count, layer_count};
};

class JoltRun final : public ContactRun {
public:
    explicit JoltRun(const ContactCase& scene) {
        const auto count = static_cast<JPH::uint>(scene.bodies.size());
        const JPH::uint room = std::max<JPH::uint>(1024, 16 * count);  // pairs and contacts; what has none is counted
        world_.Init(count, 0, room, room, layers_.trees, of_trees_, layers_.pairs);
        JPH::PhysicsSettings settings;
        settings.mAllowSleeping = false;
        world_.SetPhysicsSettings(settings);
        world_.SetGravity(vector(scene.gravity));
        for (const SceneBody& body : scene.bodies) add(body);
        world_.OptimizeBroadPhase();
    }
    ~JoltRun() override {
        for (const Added& body : bodies_) {
            world_.GetBodyInterface().RemoveBody(body.id);
            world_.GetBodyInterface().DestroyBody(body.id);
        }
    }
    JoltRun(const JoltRun&) = delete;
    JoltRun& operator=(const JoltRun&) = delete;

    void step(int rate) override {
        lost_ = world_.Update(1.0f / static_cast<float>(rate), 1, &memory_, &jobs_) == JPH::EPhysicsUpdateError::None ? 0 : 1;
    }

    void read(std::vector<BodyPose>& poses) const override {
        poses.resize(bodies_.size());
        const JPH::BodyInterface& bodies = world_.GetBodyInterfaceNoLock();
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            const JPH::Mat44 A = JPH::Mat44::sRotation(bodies.GetRotation(bodies_[i].id));
            const JPH::uint first = bodies_[i].is_capsule ? 2 : 0;  // see columns_of
            for (JPH::uint column = 0; column < 3; ++column) copy(A.GetColumn3((column + first) % 3), poses[i].A + 3 * column);
            copy(Vec3(bodies.GetPosition(bodies_[i].id)), poses[i].r);
            copy(bodies.GetLinearVelocity(bodies_[i].id), poses[i].v);
            copy(bodies.GetAngularVelocity(bodies_[i].id), poses[i].omega);
        }
    }

    StepFigures figures() const override {
        StepFigures figures;
        figures.lost = lost_;
        return figures;
    }

private:
    struct Added {
        JPH::BodyID id;
        bool is_capsule;
    };

    static void copy(Vec3 v, double* to) {
        for (int axis = 0; axis < 3; ++axis) to[axis] = static_cast<double>(v[static_cast<JPH::uint>(axis)]);
    }

    /// Jolt's capsules lie along y, those of the scenes along z: its axes x, y, z are then c1, c2, c0.
    static JPH::Mat44 columns_of(const SceneBody& body) {
        const int first = body.solid == Solid::capsule ? 1 : 0;
        const auto column = [&](int i) { return JPH::Vec4(vector(body.A + 3 * ((i + first) % 3)), 0); };
        return {column(0), column(1), column(2), JPH::Vec4(0, 0, 0, 1)};
    }

    static JPH::Ref<JPH::Shape> shape_of(const SceneBody& body) {
        if (body.solid == Solid::ball) return new JPH::SphereShape(real(body.size[0]));
        if (body.solid == Solid::capsule) return new JPH::CapsuleShape(real(body.size[1]), real(body.size[0]));
        return new JPH::BoxShape(body.solid == Solid::half_space ? Vec3(40, 40, 1) : vector(body.size));
    }

    void add(const SceneBody& body) {
        Vec3 r = vector(body.r);
        JPH::Quat turn = columns_of(body).GetQuaternion();
        if (body.solid == Solid::half_space) {
            r = vector(body.size) * (real(body.offset) - 1);
            turn = JPH::Quat::sFromTo(Vec3::sAxisZ(), vector(body.size));
        }
        JPH::BodyCreationSettings settings(shape_of(body), JPH::RVec3(r), turn.Normalized(),
                                           body.immovable ? JPH::EMotionType::Static : JPH::EMotionType::Dynamic,
                                           body.immovable ? fixed : moving);
        settings.mFriction = real(body.mu);  // of a pair: the geometric mean; of restitution the larger
        settings.mRestitution = real(body.e);
        settings.mLinearDamping = settings.mAngularDamping = 0;
        settings.mAllowSleeping = false;
        if (!body.immovable) {
            const int first = body.solid == Solid::capsule ? 1 : 0;
            settings.mOverrideMassProperties = JPH::EOverrideMassProperties::MassAndInertiaProvided;
            settings.mMassPropertiesOverride.mMass = real(body.M);
            settings.mMassPropertiesOverride.mInertia =
                JPH::Mat44::sScale(Vec3(real(body.I[first]), real(body.I[(1 + first) % 3]), real(body.I[(2 + first) % 3])));
        }
        const JPH::EActivation activation = body.immovable ? JPH::EActivation::DontActivate : JPH::EActivation::Activate;
        bodies_.push_back({world_.GetBodyInterface().CreateAndAddBody(settings, activation), body.solid == Solid::capsule});
    }

    Layers layers_;
    JPH::ObjectVsBroadPhaseLayerFilterTable of_trees_{layers_.trees, layer_count, layers_.pairs, layer_count};
    JPH::TempAllocatorImplWithMallocFallback memory_{64 << 20};
    JPH::JobSystemSingleThreaded jobs_{JPH::cMaxPhysicsJobs};
    JPH::PhysicsSystem world_;
    std::vector<Added> bodies_;
    int lost_ = 0;
};

}  // namespace

PeerEngine peer_jolt() {
    struct Library {
        Library() {
            JPH::RegisterDefaultAllocator();
            JPH::Factory::sInstance = new JPH::Factory();
            JPH::RegisterTypes();
        }
        ~Library() {
            JPH::UnregisterTypes();
            delete JPH::Factory::sInstance;
            JPH::Factory::sInstance = nullptr;
        }
    };
    static const Library library;
    return {"jolt", "float", [](const ContactCase& scene) { return std::make_unique<JoltRun>(scene); }};
}

}  // namespace report
