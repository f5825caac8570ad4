# SPDX-License-Identifier: MIT
"""ingot for Python, by ctypes: no compiler, no package.

    import ingot
    lib = ingot.load("libingot_c.so")
    world = ingot.World(lib, ingot.SMALL, gravity=(0, 0, -9.81))
    world.add(shape=ingot.HALF_SPACE, kind=ingot.IMMOVABLE, size=(0, 0, 1))
    crate = world.add(shape=ingot.BOX, size=(0.5, 0.5, 0.5), r=(0, 0, 2))
    for _ in range(60):
        world.step(1 / 60)
    print(world.state(crate).r[2], world.hash())

Names and units are those of ingot_c.h. A call that is refused raises ingot.Refused with the sentence of its status.
"""
import ctypes

SMALL, MIDDLE, LARGE = range(3)
SPHERE, CAPSULE, BOX, CYLINDER, HALF_SPACE = 1, 2, 3, 4, 6
MOVABLE, IMMOVABLE, KINEMATIC = range(3)
BALL, HINGE, SLIDER, UNIVERSAL, FIXED = range(1, 6)


class Refused(Exception):
    pass


def load(path):
    """The library, with the structs of ingot_c.h as its scalar makes them: BodyDef, State, Report, Hit, Contact, JointDef."""
    lib = ctypes.CDLL(path)
    size, i32, u64, pointer = ctypes.c_size_t, ctypes.c_int32, ctypes.c_uint64, ctypes.c_void_p
    lib.ingot_scalar_size.restype = size
    real = ctypes.c_double if lib.ingot_scalar_size() == 8 else ctypes.c_float
    three, nine = real * 3, real * 9

    def struct(name, *fields):
        return type(name, (ctypes.Structure,), {"_fields_": [(field, kind) for names, kind in fields for field in names.split()]})

    lib.Real, lib.Vector, lib.Matrix = real, three, nine
    lib.BodyDef = struct("BodyDef", ("kind shape", i32), ("size", three), ("offset density", real), ("r", three), ("A", nine), ("v omega", three),
                         ("restitution friction", real), ("sensor", i32))
    lib.State = struct("State", ("r v", three), ("A", nine), ("L", three))
    lib.Report = struct("Report", ("contacts contacts_lost bodies_frozen sweeps sweeps_unfinished", i32), ("residual", real), ("clean", i32))
    lib.Hit = struct("Hit", ("body", u64), ("fraction", real), ("P n", three))
    lib.Contact = struct("Contact", ("A B", u64), ("n", three), ("separation j", real), ("point_count", i32), ("P", three * 4))
    lib.JointDef = struct("JointDef", ("kind", i32), ("A B", u64), ("P axis", three))
    for name, result, *arguments in (
            ("status_name", ctypes.c_char_p, i32), ("determinism_version", ctypes.c_uint32), ("world_size", size, i32), ("world_alignment", size),
            ("world_begin", pointer, i32, pointer, size), ("set_gravity", i32, pointer, three), ("step", i32, pointer, real, pointer),
            ("state_hash", u64, pointer), ("kinetic_energy", real, pointer), ("snapshot_size", size, i32),
            ("save_snapshot", size, pointer, pointer, size), ("load_snapshot", i32, pointer, pointer, size), ("body_def", None, pointer),
            ("add_body", i32, pointer, pointer, pointer), ("remove_body", i32, pointer, u64), ("body_count", i32, pointer),
            ("state", i32, pointer, u64, pointer), ("set_state", i32, pointer, u64, pointer), ("move_to", i32, pointer, u64, three, nine),
            ("add_force", i32, pointer, u64, three, three), ("apply_impulse", i32, pointer, u64, three, three), ("is_asleep", i32, pointer, u64),
            ("contact_count", i32, pointer), ("contact", i32, pointer, i32, pointer), ("cast_ray", i32, pointer, three, three, pointer),
            ("add_joint", i32, pointer, pointer, pointer), ("remove_joint", i32, pointer, u64), ("joint_gap", i32, pointer, u64, pointer)):
        function = getattr(lib, "ingot_" + name)
        function.restype, function.argtypes = result, arguments
    return lib


class World:
    def __init__(self, lib, which, gravity=(0, 0, 0)):
        self.lib, self.which = lib, which
        bytes_needed, alignment = lib.ingot_world_size(which), lib.ingot_world_alignment()
        self.memory = ctypes.create_string_buffer(bytes_needed + alignment)
        first = -ctypes.addressof(self.memory) % alignment
        self.at = lib.ingot_world_begin(which, ctypes.addressof(self.memory) + first, bytes_needed)
        if not self.at:
            raise Refused("no such world")
        self.check(lib.ingot_set_gravity(self.at, lib.Vector(*gravity)))

    def check(self, status):
        if status != 0:
            raise Refused(self.lib.ingot_status_name(status).decode())

    def filled(self, struct, fields):
        for name, value in fields.items():
            kind = dict(struct._fields_)[name]
            setattr(struct, name, kind(*value) if isinstance(value, (tuple, list)) else value)
        return struct

    def add(self, **fields):
        definition, body = self.lib.BodyDef(), ctypes.c_uint64()
        self.lib.ingot_body_def(ctypes.byref(definition))
        self.check(self.lib.ingot_add_body(self.at, ctypes.byref(self.filled(definition, fields)), ctypes.byref(body)))
        return body.value

    def add_joint(self, **fields):
        definition, joint = self.lib.JointDef(), ctypes.c_uint64()
        self.check(self.lib.ingot_add_joint(self.at, ctypes.byref(self.filled(definition, fields)), ctypes.byref(joint)))
        return joint.value

    def step(self, h):
        report = self.lib.Report()
        self.check(self.lib.ingot_step(self.at, h, ctypes.byref(report)))
        return report

    def state(self, body):
        state = self.lib.State()
        self.check(self.lib.ingot_state(self.at, body, ctypes.byref(state)))
        return state

    def apply_impulse(self, body, j, P):
        self.check(self.lib.ingot_apply_impulse(self.at, body, self.lib.Vector(*j), self.lib.Vector(*P)))

    def cast_ray(self, start, way):
        hit = self.lib.Hit()
        self.check(self.lib.ingot_cast_ray(self.at, self.lib.Vector(*start), self.lib.Vector(*way), ctypes.byref(hit)))
        return hit

    def contacts(self):
        for index in range(self.lib.ingot_contact_count(self.at)):
            contact = self.lib.Contact()
            self.check(self.lib.ingot_contact(self.at, index, ctypes.byref(contact)))
            yield contact

    def save(self):
        room = ctypes.create_string_buffer(self.lib.ingot_snapshot_size(self.which))
        size = self.lib.ingot_save_snapshot(self.at, room, len(room))
        return room.raw[:size]

    def load(self, snapshot):
        self.check(self.lib.ingot_load_snapshot(self.at, snapshot, len(snapshot)))

    def hash(self):
        return self.lib.ingot_state_hash(self.at)
