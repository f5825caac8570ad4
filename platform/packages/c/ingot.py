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
BALL, HINGE, SLIDER, UNIVERSAL, FIXED, ROD, ROPE = range(1, 8)
NO_DRIVE, SPRING, TUNED, MOTOR = range(4)
BEGIN, END, HIT, ENTER, LEAVE = range(5)
HITS_MAX = 64


class Refused(Exception):
    pass


def load(path):
    """The library, with the structs of ingot_c.h as its scalar makes them: BodyDef, State, Hit, Contact, Event, JointDef, Drive and so on."""
    lib = ctypes.CDLL(path)
    size, i32, u32, u64, pointer = ctypes.c_size_t, ctypes.c_int32, ctypes.c_uint32, ctypes.c_uint64, ctypes.c_void_p
    lib.ingot_scalar_size.restype = size
    real = ctypes.c_double if lib.ingot_scalar_size() == 8 else ctypes.c_float
    three, nine = real * 3, real * 9

    def struct(name, *fields):
        return type(name, (ctypes.Structure,), {"_fields_": [(field, kind) for names, kind in fields for field in names.split()]})

    lib.Real, lib.Vector, lib.Matrix = real, three, nine
    lib.BodyDef = struct("BodyDef", ("kind shape", i32), ("size", three), ("offset density", real), ("r", three), ("A", nine), ("v omega", three),
                         ("restitution friction", real), ("sensor", i32), ("category mask", u32))
    lib.State = struct("State", ("r v", three), ("A", nine), ("L", three))
    lib.Report = struct("Report", ("contacts contacts_lost bodies_frozen sweeps sweeps_unfinished", i32), ("residual", real), ("clean", i32))
    lib.Hit = struct("Hit", ("body", u64), ("fraction", real), ("P n", three))
    lib.Contact = struct("Contact", ("A B", u64), ("n", three), ("separation j", real), ("point_count", i32), ("P", three * 4))
    lib.Event = struct("Event", ("kind", i32), ("A B", u64), ("P n", three), ("speed", real))
    lib.Range = struct("Range", ("limited", i32), ("lower upper", real))
    lib.Limits = struct("Limits", ("range", lib.Range * 2), ("cone restitution", real))
    lib.JointDef = struct("JointDef", ("kind", i32), ("A B", u64), ("P axis axis_B P_B", three), ("length", real), ("limits", lib.Limits),
                          ("bodies_meet", i32))
    lib.Drive = struct("Drive", ("kind", i32), ("stiffness damping target target_rate feedforward max_torque", real))
    lib.JointState = struct("JointState", ("angle rate", real * 2), ("travel speed length distance", real), ("torque", three), ("gap", real))
    for name, result, *arguments in (
            ("status_name", ctypes.c_char_p, i32), ("determinism_version", ctypes.c_uint32), ("world_size", size, i32), ("world_alignment", size),
            ("world_begin", pointer, i32, pointer, size), ("set_gravity", i32, pointer, three), ("step", i32, pointer, real, pointer),
            ("state_hash", u64, pointer), ("kinetic_energy", real, pointer), ("snapshot_size", size, i32),
            ("save_snapshot", size, pointer, pointer, size), ("load_snapshot", i32, pointer, pointer, size), ("body_def", None, pointer),
            ("add_body", i32, pointer, pointer, pointer), ("remove_body", i32, pointer, u64), ("body_count", i32, pointer),
            ("state", i32, pointer, u64, pointer), ("set_state", i32, pointer, u64, pointer), ("move_to", i32, pointer, u64, three, nine),
            ("set_velocity", i32, pointer, u64, three, three), ("mass", i32, pointer, u64, pointer), ("set_filter", i32, pointer, u64, u32, u32),
            ("add_force", i32, pointer, u64, three, three), ("add_torque", i32, pointer, u64, three),
            ("apply_impulse", i32, pointer, u64, three, three), ("apply_angular_impulse", i32, pointer, u64, three),
            ("is_asleep", i32, pointer, u64), ("wake", i32, pointer, u64), ("sleep", i32, pointer, u64),
            ("cast_ray_all", i32, pointer, three, three, pointer, i32, pointer), ("event_count", i32, pointer), ("event", i32, pointer, i32, pointer),
            ("joint_state", i32, pointer, u64, pointer), ("set_joint_limits", i32, pointer, u64, pointer),
            ("set_joint_drive", i32, pointer, u64, pointer, i32), ("set_ball_drive", i32, pointer, u64, pointer, three),
            ("set_joint_target", i32, pointer, u64, real, real, i32), ("set_joint_length", i32, pointer, u64, real),
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

    def call(self, name, *arguments):
        """A call that answers with a status, by its name without ingot_: world.call("add_torque", body, (0, 0, 1)). Sequences are vectors."""
        def passed(value):
            return (self.lib.Real * len(value))(*value) if isinstance(value, (tuple, list)) else value
        self.check(getattr(self.lib, "ingot_" + name)(self.at, *map(passed, arguments)))

    def read(self, name, kind, which):
        """What is read of a body, a joint, a contact or an event, as the struct `kind` of the library."""
        there = kind()
        self.check(getattr(self.lib, "ingot_" + name)(self.at, which, ctypes.byref(there)))
        return there

    def limits(self, *ranges, cone=0, restitution=0):
        """Of a joint: pairs of lower and upper, or None."""
        limits = self.lib.Limits(cone=cone, restitution=restitution)
        for i, ends in enumerate(ranges):
            if ends is not None:
                limits.range[i] = self.lib.Range(1, *ends)
        return limits

    def drive(self, joint, kind, which=0, **fields):
        self.call("set_joint_drive", joint, ctypes.byref(self.lib.Drive(kind=kind, **fields)), which)

    def drive_ball(self, joint, kind, target=(0, 0, 0), **fields):
        self.call("set_ball_drive", joint, ctypes.byref(self.lib.Drive(kind=kind, **fields)), target)

    def joint_state(self, joint):
        return self.read("joint_state", self.lib.JointState, joint)

    def mass(self, body):
        return self.read("mass", self.lib.Real, body).value

    def events(self):
        return [self.read("event", self.lib.Event, index) for index in range(self.lib.ingot_event_count(self.at))]

    def is_asleep(self, body):
        return self.lib.ingot_is_asleep(self.at, body) == 1

    def cast_ray_all(self, start, way):
        """At most HITS_MAX bodies, as they are met."""
        hits, count = (self.lib.Hit * HITS_MAX)(), ctypes.c_int32()
        self.call("cast_ray_all", start, way, hits, HITS_MAX, ctypes.byref(count))
        return list(hits[:min(count.value, HITS_MAX)])

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
