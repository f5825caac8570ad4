#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""python_story.py <folder of ingot.py> <library> <program>...: the story of c_story.c by ctypes; the programs print the same hashes."""
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


def main():
    lib = ingot.load(sys.argv[2])
    told = ["%016x" % tell(lib, which) for which in (ingot.SMALL, ingot.MIDDLE, ingot.LARGE)]
    for program in sys.argv[3:]:
        run = subprocess.run([program], capture_output=True, text=True, check=False)
        if run.returncode != 0 or run.stdout.split() != told:
            sys.exit("c interface: %s ended with %d and printed\n%s%snot\n%s" % (program, run.returncode, run.stdout, run.stderr, "\n".join(told)))
    print(*told)


if __name__ == "__main__":
    main()
