// SPDX-License-Identifier: MIT
// Box3D in float: 4 substeps, the suggested value; contact softness, recycling of contacts and continuous collision as its defaults have
// them. A box is a hull.
#include <box3d/box3d.h>

#include <cmath>

#include "contact_peers.h"

namespace report {

PeerEngine peer_box3d();

namespace {

float real(double x) { return static_cast<float>(x); }
b3Vec3 vector(const double (&v)[3]) { return {real(v[0]), real(v[1]), real(v[2])}; }

class Box3dRun final : public ContactRun {
public:
    explicit Box3dRun(const ContactCase& scene) {
        b3WorldDef def = b3DefaultWorldDef();
        def.gravity = vector(scene.gravity);
        def.enableSleep = false;
        world_ = b3CreateWorld(&def);
        for (const SceneBody& body : scene.bodies) add(body);
    }
    ~Box3dRun() override { b3DestroyWorld(world_); }
    Box3dRun(const Box3dRun&) = delete;
    Box3dRun& operator=(const Box3dRun&) = delete;

    void step(int rate) override { b3World_Step(world_, 1.0f / static_cast<float>(rate), 4); }

    void read(std::vector<BodyPose>& poses) const override {
        poses.resize(bodies_.size());
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            const b3Matrix3 A = b3MakeMatrixFromQuat(b3Body_GetRotation(bodies_[i]));
            const b3Pos r = b3Body_GetPosition(bodies_[i]);
            copy(A.cx, poses[i].A);
            copy(A.cy, poses[i].A + 3);
            copy(A.cz, poses[i].A + 6);
            copy({static_cast<float>(r.x), static_cast<float>(r.y), static_cast<float>(r.z)}, poses[i].r);
            copy(b3Body_GetLinearVelocity(bodies_[i]), poses[i].v);
            copy(b3Body_GetAngularVelocity(bodies_[i]), poses[i].omega);
        }
    }

private:
    static void copy(const b3Vec3& v, double* to) {
        to[0] = static_cast<double>(v.x);
        to[1] = static_cast<double>(v.y);
        to[2] = static_cast<double>(v.z);
    }

    void add(const SceneBody& body) {
        b3BodyDef def = b3DefaultBodyDef();
        def.type = body.immovable ? b3_staticBody : b3_dynamicBody;
        def.enableSleep = false;
        place(body, def);
        const b3BodyId added = b3CreateBody(world_, &def);
        b3ShapeDef surface = b3DefaultShapeDef();
        surface.baseMaterial.friction = real(body.mu);  // of a pair: the geometric mean; of restitution the larger
        surface.baseMaterial.restitution = real(body.e);
        surface.updateBodyMass = false;
        add_shape(body, added, surface);
        if (!body.immovable) {
            b3MassData mass = {};
            mass.mass = real(body.M);
            mass.inertia = {{real(body.I[0]), 0, 0}, {0, real(body.I[1]), 0}, {0, 0, real(body.I[2])}};
            b3Body_SetMassData(added, mass);
        }
        bodies_.push_back(added);
    }

    static void place(const SceneBody& body, b3BodyDef& def) {
        b3Vec3 r = vector(body.r);
        if (body.solid == Solid::half_space) {
            const b3Vec3 n = vector(body.size);
            const float depth = real(body.offset) - 1;
            r = {n.x * depth, n.y * depth, n.z * depth};
            def.rotation = b3ComputeQuatBetweenUnitVectors({0, 0, 1}, n);
        } else {
            const double* const A = body.A;
            const b3Matrix3 columns = {
                {real(A[0]), real(A[1]), real(A[2])}, {real(A[3]), real(A[4]), real(A[5])}, {real(A[6]), real(A[7]), real(A[8])}};
            def.rotation = b3MakeQuatFromMatrix(&columns);
        }
        def.position = {r.x, r.y, r.z};
    }

    static void add_shape(const SceneBody& body, b3BodyId added, const b3ShapeDef& surface) {
        if (body.solid == Solid::ball) {
            const b3Sphere ball = {{0, 0, 0}, real(body.size[0])};
            b3CreateSphereShape(added, &surface, &ball);
        } else if (body.solid == Solid::capsule) {
            const float half = real(body.size[1]);
            const b3Capsule capsule = {{0, 0, -half}, {0, 0, half}, real(body.size[0])};
            b3CreateCapsuleShape(added, &surface, &capsule);
        } else {
            const bool slab = body.solid == Solid::half_space;
            const b3BoxHull box = slab ? b3MakeBoxHull(40, 40, 1) : b3MakeBoxHull(real(body.size[0]), real(body.size[1]), real(body.size[2]));
            b3CreateHullShape(added, &surface, &box.base);
        }
    }

    b3WorldId world_;
    std::vector<b3BodyId> bodies_;
};

}  // namespace

PeerEngine peer_box3d() {
    return {"box3d", "float", [](const ContactCase& scene) { return std::make_unique<Box3dRun>(scene); }};
}

}  // namespace report
