"""usage: handles.py LIBRARY OBJECT TABLE FOREIGN POLELESS TOP

Calls the library as another language does, with pointers, numbers, strings and arrays alone, and compares with rows of jellett,
whose numbers read back bit for bit. OBJECT: kernels of TABLE, as ttc build makes them; FOREIGN: those of a table of which a section
is known by name, but which no proof links to it; POLELESS: those of TOP, a table that names no pole."""
import ctypes
import math
import os
import struct
import subprocess
import sys
from ctypes import POINTER, byref, c_char_p, c_double, c_int, c_size_t, c_uint, c_void_p

library_path, object_path, table_path, foreign_path, poleless_path, top_path = sys.argv[1:]
jlt = ctypes.CDLL(library_path)
NUMBERS, NAMES, HANDLE = POINTER(c_double), POINTER(c_char_p), c_void_p
OK, ARG, DOMAIN, NONFINITE, EMPTY, UNSUPPORTED, IO = 0, 1, 2, 3, 7, 8, 10

SIGNATURES = {
    "status_text": (c_char_p, c_int),
    "section_fate_name": (c_char_p, c_int),
    "handle_section_known": (c_int, POINTER(HANDLE), c_char_p, NAMES, NUMBERS, c_size_t, c_double),
    "handle_section_plane": (c_int, POINTER(HANDLE), c_char_p, c_char_p, c_double, c_int, NAMES, NUMBERS, c_size_t, c_double),
    "handle_section_destroy": (None, HANDLE),
    "handle_section_dim": (c_uint, HANDLE),
    "handle_section_coordinate": (c_char_p, HANDLE, c_uint),
    "handle_section_columns": (c_uint, HANDLE),
    "handle_section_column": (c_char_p, HANDLE, c_uint),
    "handle_section_start": (c_int, HANDLE, NUMBERS, c_int),
    "handle_section_returns": (c_int, HANDLE, NUMBERS, NUMBERS, NUMBERS, POINTER(c_size_t), POINTER(c_int), c_size_t),
    "handle_motion_create": (c_int, POINTER(HANDLE), c_char_p, NAMES, NUMBERS, c_size_t, c_double),
    "handle_motion_destroy": (None, HANDLE),
    "handle_motion_dim": (c_uint, HANDLE),
    "handle_motion_state": (c_char_p, HANDLE, c_uint),
    "handle_motion_start": (c_int, HANDLE, NUMBERS),
    "handle_motion_states": (c_int, HANDLE, NUMBERS, NUMBERS, POINTER(c_size_t), POINTER(c_int), NUMBERS, c_size_t),
}
for name, (result, *arguments) in SIGNATURES.items():
    function = getattr(jlt, "jlt_" + name)
    function.restype, function.argtypes = result, arguments


def numbers(values):
    return (c_double * max(1, len(values)))(*values)


def named(values):
    """Arguments names, values, count."""
    return (c_char_p * max(1, len(values)))(*(name.encode() for name in values)), numbers(list(values.values())), len(values)


def expect(status, call):
    got = call
    assert got == status, f"status {got} ({jlt.jlt_status_text(got).decode()}), not {status}"


def same(a, b):
    return struct.pack("d", a) == struct.pack("d", b) or (math.isnan(a) and math.isnan(b))


def rows_of(*command):
    """Columns and rows of jellett, an empty field as NaN; the last column is the fate."""
    environment = {**os.environ, "LD_PRELOAD": ""}
    said = subprocess.run(["jellett", *command], capture_output=True, text=True, env=environment)
    lines = [line for line in said.stdout.splitlines() if not line.startswith("#")]
    assert len(lines) > 1, f"jellett {' '.join(command)}: {said.stderr}"
    rows = [line.split(",") for line in lines[1:]]
    return lines[0].split(","), [[float(field) if field else math.nan for field in row[:-1]] + [row[-1]] for row in rows]


def agree(what, rows, expected, fate):
    assert len(rows) == len(expected), f"{what}: {len(rows)} rows, not {len(expected)}"
    for row, other in zip(rows, expected):
        assert all(same(a, b) for a, b in zip(row, other)), f"{what}: {row}, not {other}"
    name = "invalid" if expected[-1][-1].startswith("lost_") else expected[-1][-1]
    assert jlt.jlt_section_fate_name(fate).decode() == name, f"{what}: fate {fate}, not {name}"
    print(f"{what}: {len(rows)} rows, {jlt.jlt_section_fate_name(fate).decode()}")


def section_rows(section, q, returns, direction=1, at_once=7):
    """Rows return, t, coordinates, columns, asked for a few at a time; and the fate."""
    dim, width = jlt.jlt_handle_section_dim(section), jlt.jlt_handle_section_columns(section)
    points, times, columns = numbers([0] * dim * at_once), numbers([0] * at_once), numbers([0] * width * at_once)
    done, fate, rows = c_size_t(at_once), c_int(), []
    expect(OK, jlt.jlt_handle_section_start(section, numbers(q), direction))
    while done.value == at_once and len(rows) < returns:
        expect(OK, jlt.jlt_handle_section_returns(section, points, times, columns, byref(done), byref(fate),
                                                  min(at_once, returns - len(rows))))
        rows += [[len(rows) + 1 + i, times[i], *points[i * dim:(i + 1) * dim], *columns[i * width:(i + 1) * width]]
                 for i in range(done.value)]
    return rows, fate.value


def check_section(section, q, returns, command, direction=1):
    coordinates = [jlt.jlt_handle_section_coordinate(section, i).decode() for i in range(jlt.jlt_handle_section_dim(section))]
    columns = [jlt.jlt_handle_section_column(section, i).decode() for i in range(jlt.jlt_handle_section_columns(section))]
    assert jlt.jlt_handle_section_coordinate(section, len(coordinates)) is None
    rows, fate = section_rows(section, q, returns, direction)
    start = ",".join(f"{name}={value!r}" for name, value in zip(coordinates, q))
    header, expected = rows_of("section", *command, "--start", start, "--returns", str(returns))
    assert header == ["orbit", "return", "t", *coordinates, *columns, "fate"], header
    agree(" ".join(("section", *command, start)), rows, [row[1:] for row in expected[1:]], fate)


def known(values, tolerance=0.0):
    section = HANDLE()
    expect(OK, jlt.jlt_handle_section_known(byref(section), b"spherical_top", *named(values), tolerance))
    return section


def sections():
    section = known({})
    check_section(section, [0.1, -0.6], 40, [])
    check_section(section, [0.44, -0.62], 7, [])
    check_section(section, [0.1, -0.6], 5, ["--backward"], direction=-1)
    jlt.jlt_handle_section_destroy(section)
    section = known({"a3": 0.4, "E": 2.2}, 1e-10)
    check_section(section, [0.2, -0.3], 12, ["--set", "a3=0.4", "--level", "E=2.2", "--tol", "1e-10"])
    jlt.jlt_handle_section_destroy(section)
    section = known({"E": 4.0, "G": -0.1})
    check_section(section, [2.5, 0.2], 100, ["--level", "E=4,G=-0.1"])
    jlt.jlt_handle_section_destroy(section)
    section = HANDLE()
    expect(OK, jlt.jlt_handle_section_plane(byref(section), b"lorenz", b"z", 27, 1, *named({"rho": 28.5}), 0))
    check_section(section, [-13.76, -19.58], 30, ["lorenz", "--section", "z=27", "--set", "rho=28.5"])
    jlt.jlt_handle_section_destroy(section)
    for direction, name in (-1, "down"), (0, "both"):
        expect(OK, jlt.jlt_handle_section_plane(byref(section), b"lorenz", b"z", 27, direction, *named({}), 0))
        check_section(section, [1.0, 2.0], 10, ["lorenz", "--section", "z=27", "--direction", name])
        jlt.jlt_handle_section_destroy(section)
    # An angle, which passes pi on the way.
    expect(OK, jlt.jlt_handle_section_plane(byref(section), b"lorenz", b"z", 27, 1, *named({}), 0))
    check_section(section, [0.0, 0.0], 5, ["lorenz", "--section", "z=27"])
    jlt.jlt_handle_section_destroy(section)
    expect(OK, jlt.jlt_handle_section_plane(byref(section), b"spherical_top_balanced", b"v_slip", 0, 1, *named({}), 0))
    check_section(section, [-0.5, -3.0], 8, ["spherical_top_balanced", "--section", "v_slip=0"])
    jlt.jlt_handle_section_destroy(section)


def motion_rows(motion, start, times):
    dim, done, fate = jlt.jlt_handle_motion_dim(motion), c_size_t(), c_int()
    x, t = numbers([0] * dim * len(times)), numbers([0] * len(times))
    expect(OK, jlt.jlt_handle_motion_start(motion, numbers(start)))
    for first, count in (0, 1), (1, len(times) - 1):
        made, rest = c_size_t(), ctypes.cast(byref(x, 8 * dim * first), NUMBERS)
        expect(OK, jlt.jlt_handle_motion_states(motion, rest, ctypes.cast(byref(t, 8 * first), NUMBERS), byref(made), byref(fate),
                                                numbers(times[first:]), count))
        done.value += made.value
    rows = [[t[i], *x[i * dim:(i + 1) * dim]] for i in range(done.value)]
    if fate.value not in (0, 3): # ended: there is no more
        expect(OK, jlt.jlt_handle_motion_states(motion, x, t, byref(done), byref(fate), numbers([2 * times[-1]]), 1))
        assert done.value == 0
    return rows, fate.value


def check_motion(model, values, start, times, command, tolerance=0.0):
    motion, done, fate = HANDLE(), c_size_t(), c_int()
    expect(OK, jlt.jlt_handle_motion_create(byref(motion), model, *named(values), tolerance))
    dim = jlt.jlt_handle_motion_dim(motion)
    states = [jlt.jlt_handle_motion_state(motion, i).decode() for i in range(dim)]
    none = numbers([0])
    expect(ARG, jlt.jlt_handle_motion_states(motion, none, none, byref(done), byref(fate), none, 1))
    header, expected = rows_of("simulate", *command, "--start", ",".join(f"{n}={v!r}" for n, v in zip(states, start)),
                               "--times", ",".join(map(repr, times)))
    assert header[:dim + 1] == ["t", *states], header
    for _ in range(2): # the second time anew, wherever the first has ended
        rows, ended = motion_rows(motion, start, times)
        agree(" ".join(("simulate", *command)), rows, [row[:dim + 1] + row[-1:] for row in expected], ended)
    jlt.jlt_handle_motion_destroy(motion)


def motions():
    top = [-0.6, 0.5, 0.3, 1.0, 0.8]
    check_motion(b"spherical_top", {}, top, [0.0, 1.0, 5.0, 10.0, 20.0], [])
    check_motion(b"spherical_top", {"I3": 0.0}, [0.2, 0.6, 0.4, 1.3, -0.8], [0.5, 1.0, 2.0], ["--set", "I3=0"])
    check_motion(b"spherical_top", {}, [0.5, 3.0, 1.0, 5.0, -6.0], [0.25, 0.5, 1.0], ["--tol", "1e-9"], 1e-9)
    check_motion(b"spherical_top", {}, [0.5, 3.0, 1.0, 5.0, -6.0], [0.1, 0.25], [])
    check_motion(b"spherical_top_plane", {}, [0.2, 0.0], [0.5, 1.0, 2.0, 3.0], ["spherical_top_plane"])
    check_motion(b"lorenz", {"rho": 20.0}, [1.0, 2.0, 20.0], [0.25 * i for i in range(40)], ["lorenz", "--set", "rho=20"])
    check_motion(b"lorenz", {}, [1.0, 2.0, 20.0], [-0.01 * i for i in range(1, 5)], ["lorenz"])
    check_motion(poleless_path.encode(), {}, [0.2, 0.4, 0.0, 0.5, -2.0], [1.0, 10.0], [top_path])
    motion = HANDLE()
    expect(OK, jlt.jlt_handle_motion_create(byref(motion), object_path.encode(), *named({}), 0))
    dim = jlt.jlt_handle_motion_dim(motion)
    jlt.jlt_handle_motion_destroy(motion)
    check_motion(object_path.encode(), {}, [0.3 + 0.2 * i for i in range(dim)], [1.0, 2.0], [table_path])


def failures():
    handle, done, fate = HANDLE(), c_size_t(), c_int()
    open_known = lambda model, values, tolerance=0.0: jlt.jlt_handle_section_known(byref(handle), model, *named(values), tolerance)
    expect(ARG, open_known(b"no_such_model", {}))
    expect(ARG, open_known(b"spherical_top", {"no_such_value": 1.0}))
    expect(UNSUPPORTED, open_known(b"lorenz", {}))
    expect(UNSUPPORTED, open_known(foreign_path.encode(), {}))
    expect(IO, open_known(b"./no/such/object.so", {}))
    expect(EMPTY, open_known(b"spherical_top", {"E": -5.0}))
    expect(DOMAIN, open_known(b"spherical_top", {"m": -1.0}))
    expect(NONFINITE, open_known(b"spherical_top", {"E": math.nan}))
    expect(ARG, open_known(b"spherical_top", {}, 2.0))
    assert not handle, "a handle beside a failure"
    expect(ARG, jlt.jlt_handle_section_plane(byref(handle), b"lorenz", b"w", 0, 1, *named({}), 0))
    expect(ARG, jlt.jlt_handle_section_plane(byref(handle), b"lorenz", b"z", 0, 1, *named({"w": 0.0}), 0))
    expect(ARG, jlt.jlt_handle_section_plane(byref(handle), b"lorenz", b"z", 0, 2, *named({}), 0))
    expect(ARG, jlt.jlt_handle_motion_create(byref(handle), b"no_such_model", *named({}), 0))
    expect(ARG, jlt.jlt_handle_motion_create(byref(handle), b"lorenz", *named({"w": 0.0}), 0))
    expect(DOMAIN, jlt.jlt_handle_motion_create(byref(handle), b"spherical_top", *named({"m": -1.0}), 0))
    assert not handle, "a handle beside a failure"
    section, q, t = known({}), numbers([0.1, -0.6]), numbers([0])
    expect(ARG, jlt.jlt_handle_section_returns(section, q, t, None, byref(done), byref(fate), 1))
    expect(ARG, jlt.jlt_handle_section_start(section, q, 0))
    expect(DOMAIN, jlt.jlt_handle_section_start(section, numbers([0.1, 1.5]), 1))
    expect(ARG, jlt.jlt_handle_section_returns(section, q, t, None, byref(done), byref(fate), 1))
    expect(OK, jlt.jlt_handle_section_start(section, q, 1))
    expect(OK, jlt.jlt_handle_section_returns(section, q, t, None, byref(done), byref(fate), 1))
    assert (done.value, fate.value) == (1, 0)
    jlt.jlt_handle_section_destroy(section)
    section = known({"G": 1.2})
    expect(EMPTY, jlt.jlt_handle_section_start(section, numbers([0.1, -0.99]), 1))
    jlt.jlt_handle_section_destroy(section)
    expect(OK, jlt.jlt_handle_motion_create(byref(handle), b"lorenz", *named({}), 0))
    expect(NONFINITE, jlt.jlt_handle_motion_start(handle, numbers([1, math.inf, 0])))
    expect(OK, jlt.jlt_handle_motion_start(handle, numbers([1, 2, 20])))
    x, t = numbers([0] * 9), numbers([0] * 3)
    expect(ARG, jlt.jlt_handle_motion_states(handle, x, t, byref(done), byref(fate), numbers([0.1, 0.2, 0.1]), 3))
    assert (done.value, t[1]) == (2, 0.2)
    expect(NONFINITE, jlt.jlt_handle_motion_states(handle, x, t, byref(done), byref(fate), numbers([math.inf]), 1))
    times = numbers([0.3])
    expect(ARG, jlt.jlt_handle_motion_states(handle, x, t, None, byref(fate), times, 1))
    expect(ARG, jlt.jlt_handle_motion_states(handle, x, t, byref(done), None, times, 1))
    jlt.jlt_handle_motion_destroy(handle)
    section, q = known({}), numbers([0.1, -0.6])
    expect(OK, jlt.jlt_handle_section_start(section, q, 1))
    expect(ARG, jlt.jlt_handle_section_returns(section, q, t, None, None, byref(fate), 1))
    expect(ARG, jlt.jlt_handle_section_returns(section, q, t, None, byref(done), None, 1))
    jlt.jlt_handle_section_destroy(section)
    expect(ARG, jlt.jlt_handle_section_known(None, b"spherical_top", *named({}), 0))
    expect(ARG, jlt.jlt_handle_section_plane(None, b"lorenz", b"z", 27, 1, *named({}), 0))
    expect(ARG, jlt.jlt_handle_motion_create(None, b"lorenz", *named({}), 0))
    for level in 1, 2:
        expect(DOMAIN, jlt.jlt_handle_section_plane(byref(handle), b"spherical_top", b"gamma3", level, 1, *named({}), 0))
    jlt.jlt_handle_section_destroy(None)
    jlt.jlt_handle_motion_destroy(None)


sections()
motions()
failures()
