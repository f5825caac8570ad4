#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""python_story.py <folder of ingot.py> <library> <program>...: the stories of c_story.c by ctypes; the programs print the same hashes."""
import ctypes
import subprocess
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, sys.argv[1])
import ingot  # noqa: E402


def tell(lib, which):
    world = ingot.World(lib, which, gravity=(0, 0, -9.75))
    world.add(kind=ingot.IMMOVABLE, shape=ingot.HALF_SPACE, size=(0, 0, 1))
    boxes = [world.add(shape=ingot.BOX, size=(0.25,) * 3, density=500, r=(0, 0, 0.25 + 0.5 * i)) for i in range(5)]
    bob = world.add(shape=ingot.SPHERE, size=(0.25, 0, 0), r=(2, 0, 4), omega=(0, 0.5, 0))
    world.add_joint(kind=ingot.HINGE, B=bob, P=(3, 0, 4), axis=(0, 1, 0))
    for _ in range(60):
        assert world.step(1 / 64).clean
    assert [contact.point_count for contact in world.contacts()] == [4] * 5
    hit = world.cast_ray((0, 0, 10), (0, 0, -20))
    assert hit.body == boxes[4]
    world.apply_impulse(boxes[4], (60, 20, 0), hit.P)
    snapshot = world.save()
    hashes = set()
    for _ in range(2):
        world.load(snapshot)
        for _ in range(60):
            world.step(1 / 64)
        hashes.add(world.hash())
    assert len(hashes) == 1
    try:
        world.state(bob + 1)
        raise AssertionError("a body that is none has no state")
    except ingot.Refused as why:
        assert str(why).startswith("stale_id"), why
    return hashes.pop()


def machines(lib, which):
    world = ingot.World(lib, which, gravity=(0, 0, -9.75))

    def put(shape, r, **fields):
        return world.add(shape=shape, size=(0.25,) * 3, r=r, **fields)

    def join(kind, body, P, axis=(0, 0, 1), **fields):
        return world.add_joint(kind=kind, B=body, P=P, axis=axis, P_B=tuple(world.state(body).r), **fields)

    world.add(kind=ingot.IMMOVABLE, shape=ingot.HALF_SPACE, size=(0, 0, 1))
    arm, bob, cart = put(ingot.BOX, (1, 0, 2)), put(ingot.SPHERE, (0, 4, 2)), put(ingot.BOX, (0, 8, 1))
    hung, roped, twin = put(ingot.SPHERE, (0.5, 12, 2)), put(ingot.SPHERE, (0.5, 16, 2)), put(ingot.BOX, (0.5, 24, 2))
    platform, rider = put(ingot.BOX, (0, 20, 0.5), kind=ingot.KINEMATIC), put(ingot.BOX, (0, 20, 1))
    ghost, dropped = put(ingot.BOX, (8, 0, 1)), put(ingot.BOX, (12, 0, 1))
    sensor = world.add(kind=ingot.IMMOVABLE, shape=ingot.SPHERE, size=(1, 0, 0), r=(12, 0, 0), sensor=1)
    hinge = join(ingot.HINGE, arm, (0, 0, 2), axis=(0, 1, 0), limits=world.limits((-0.5, 0.25)))
    ball = join(ingot.BALL, bob, (0, 4, 3), limits=world.limits(cone=0.5))
    slider = join(ingot.SLIDER, cart, (0, 8, 1), axis=(1, 0, 0), limits=world.limits((0, 0.25)))
    join(ingot.ROD, hung, (0, 12, 3))
    rope = join(ingot.ROPE, roped, (0, 16, 3))
    join(ingot.FIXED, twin, (0, 24, 2))
    world.drive(hinge, ingot.TUNED, stiffness=2, damping=1, target=0.125)
    world.drive_ball(ball, ingot.SPRING, target=(0.25, 0, 0), stiffness=40, damping=4)
    world.drive(slider, ingot.MOTOR, target_rate=0.5, max_torque=4000)
    world.call("set_joint_length", rope, 1.25)
    world.call("set_filter", ghost, 2, 0)
    world.call("set_velocity", platform, (0.5, 0, 0), (0, 0, 0))
    world.call("apply_angular_impulse", hung, (0, 0, 0.125))
    told = []
    for _ in range(90):
        world.call("add_torque", bob, (0, 0, 0.125))
        world.step(1 / 64)
        told += [(event.kind, event.A, event.B) for event in world.events()]
    assert [event for event in told if event[0] == ingot.ENTER] == [(ingot.ENTER, sensor, dropped)], told
    assert abs(world.joint_state(slider).travel - 0.25) < 1e-3 and abs(world.mass(twin) - 125) < 1e-3
    assert [hit.body for hit in world.cast_ray_all((-9, 20, 0.5), (20, 0, 0))] == [platform]
    world.call("set_joint_target", hinge, 1, 0, 0)
    world.call("wake", rider)
    world.call("set_joint_limits", hinge, ctypes.byref(world.limits((-0.5, 0.5))))
    world.call("remove_body", dropped)
    for _ in range(90):
        world.step(1 / 64)
    return world.hash()


def main():
    lib = ingot.load(sys.argv[2])
    told = ["%016x" % story(lib, which) for which in (ingot.SMALL, ingot.MIDDLE, ingot.LARGE) for story in (tell, machines)]
    for program in sys.argv[3:]:
        run = subprocess.run([program], capture_output=True, text=True, check=False)
        if run.returncode != 0 or run.stdout.split() != told:
            sys.exit("c interface: %s ended with %d and printed\n%s%snot\n%s" % (program, run.returncode, run.stdout, run.stderr, "\n".join(told)))
    print(*told)


if __name__ == "__main__":
    main()
