#include "validated/said.h"

#include "validated/numerals.h"

#include <stdint.h>
#include <string.h>

/* Whether these legs have no unknown members; that all known ones are present is checked when they are read. */
static bool are_legs(const json_t *legs)
{
    bool good = true;

    for (size_t i = 0; good && i < json_array_size(legs); i++) {
        const json_t *leg = json_array_get(legs, i);
        good = json_object_size(leg) <= (json_object_get(leg, "turns") == NULL ? 2 : 3);
    }
    return good;
}

bool jlt_said_is_form(const char *kind, const json_t *given)
{
    const json_t *homoclinic = json_object_get(given, "homoclinic");
    const bool has_homoclinic = strcmp(kind, "homoclinic") == 0;

    if (json_object_size(json_object_get(given, "table")) > 2) return false;
    if (strcmp(kind, "equilibria") == 0) return json_object_size(given) <= 5;
    if (strcmp(kind, "pole") == 0) return json_object_size(given) <= 7;
    return json_object_size(given) <= (has_homoclinic ? 8 : 7) && json_object_size(json_object_get(given, "section")) <= 3
           && are_legs(json_object_get(given, "legs"))
           && (!has_homoclinic
               || (json_object_size(homoclinic) <= (json_object_get(homoclinic, "reversor") == NULL ? 5 : 6)
                   && are_legs(json_object_get(homoclinic, "legs"))));
}

/* A precision that suffices for all digits of a ball's middle. */
static slong bits_of(const json_t *ball)
{
    const char *middle = json_string_value(json_object_get(ball, "middle"));

    return 64 + 4 * (slong)(middle == NULL ? 0 : strlen(middle));
}

static bool holds_ball(const json_t *said, const json_t *proved)
{
    const slong bits = bits_of(proved);
    JLT_SCOPED(arb, inner);

    return jlt_numerals_ball(inner, proved, bits) && jlt_numerals_hold(said, inner, bits);
}

/* Whether lower bounds of conditions are not above those that were proved. "-inf" says nothing. */
static bool bounds_follow(const json_t *said, const json_t *proved)
{
    const char *name;
    json_t *bound;
    bool good = json_is_object(said) && json_object_size(said) == json_object_size(proved);
    JLT_SCOPED(arb, least, found);

    json_object_foreach((json_t *)(uintptr_t)said, name, bound) {
        const json_t *other = json_object_get(proved, name);
        const char *text = json_string_value(bound);
        if (text == NULL || other == NULL) return false;
        if (strcmp(text, "-inf") == 0 || json_equal(bound, other)) continue;
        good = good && jlt_numerals_read(least, text, 64) && jlt_numerals_read(found, json_string_value(other), 64)
               && arb_le(least, found);
    }
    return good;
}

static bool follows(const json_t *said, const json_t *proved, bool is_part);

/* is_part: members have names of ours, as those of `shown` and of its part "homoclinic" have; others have names of the table, which
 * may be "conditions", too. */
static bool all_follow(const json_t *said, const json_t *proved, bool is_part)
{
    const char *name;
    json_t *member;
    bool good = json_object_size(said) == json_object_size(proved);

    json_object_foreach((json_t *)(uintptr_t)said, name, member) {
        const json_t *other = json_object_get(proved, name);
        good = good && other != NULL
               && (is_part && strcmp(name, "conditions") == 0 ? bounds_follow(member, other)
                                                              : follows(member, other, is_part && strcmp(name, "homoclinic") == 0));
    }
    return good;
}

static bool follows(const json_t *said, const json_t *proved, bool is_part)
{
    bool good = true;

    if (json_typeof(said) != json_typeof(proved)) return false;
    if (json_is_array(said)) {
        good = json_array_size(said) == json_array_size(proved);
        for (size_t i = 0; good && i < json_array_size(said); i++)
            good = follows(json_array_get(said, i), json_array_get(proved, i), false);
        return good;
    }
    if (!json_is_object(said)) return json_equal(said, proved);
    if (jlt_numerals_is_ball(proved)) return json_equal(said, proved) || holds_ball(said, proved);
    return all_follow(said, proved, is_part);
}

bool jlt_said_follows(const json_t *said, const json_t *proved)
{
    /* for a family no number is a ball, and its point has names from the table */
    return json_object_get(proved, "point") != NULL ? json_equal(said, proved) : follows(said, proved, true);
}

/* ---- the words ---- */

/* Read a ball of `shown` by its name, as it is written. */
static void read_number(arb_t out, const json_t *shown, const char *name)
{
    const json_t *ball = json_object_get(shown, name);

    if (!jlt_numerals_ball(out, ball, bits_of(ball))) arb_indeterminate(out);
}

/* The side of an integer on which a ball lies: 1 above, -1 below, 0 if it may contain the integer. */
static int side(const json_t *shown, const char *name, slong of)
{
    const slong bits = bits_of(json_object_get(shown, name)) + 64;
    JLT_SCOPED(arb, value);

    read_number(value, shown, name);
    arb_sub_si(value, value, of, bits);
    return arb_sgn_nonzero(value);
}

/* The side of the unit circle on which a multiplier lies: 1 outside, -1 inside, 0 if undecided. */
static int side_of_circle(const json_t *multiplier)
{
    const slong bits = bits_of(json_object_get(multiplier, "re")) + bits_of(json_object_get(multiplier, "im"));
    JLT_SCOPED(arb, re, im);

    read_number(re, multiplier, "re");
    read_number(im, multiplier, "im");
    arb_mul(re, re, re, bits);
    arb_addmul(re, im, im, bits);
    arb_sub_ui(re, re, 1, bits);
    return arb_sgn_nonzero(re);
}

/* The number of multipliers that certainly lie on this side of the unit circle. */
static size_t count_multipliers(const json_t *shown, int wanted)
{
    const json_t *multipliers = json_object_get(shown, "multipliers");
    size_t count = 0;

    for (size_t i = 0; i < json_array_size(multipliers); i++) count += side_of_circle(json_array_get(multipliers, i)) == wanted;
    return count;
}

/* Whether the radii of a point of the orbit, as written, are at most four times those of its box. */
static bool is_near(const json_t *point, const json_t *leg)
{
    const json_t *box = json_object_get(leg, "box");
    const char *name;
    json_t *ball;
    bool near = true;
    JLT_SCOPED(arb, radius, room);

    json_object_foreach((json_t *)(uintptr_t)point, name, ball) {
        const json_t *around = json_object_get(box, name);
        near = near && jlt_numerals_read(radius, json_string_value(json_object_get(ball, "radius")), 64)
               && jlt_numerals_read(room, json_string_value(json_object_get(around, "radius")), 64);
        arb_mul_2exp_si(room, room, 2);
        near = near && !arb_gt(radius, room);
    }
    return near;
}

static const char *judge_cycle(const json_t *given, const json_t *shown)
{
    const json_t *legs = json_object_get(given, "legs"), *orbit = json_object_get(shown, "orbit");

    if (side(shown, "period", 0) <= 0) return "the period, as it is written, may be 0";
    for (size_t i = 0; i < json_array_size(orbit); i++)
        if (!is_near(json_array_get(orbit, i), json_array_get(legs, i)))
            return "a point of the orbit is written with much more room than its box has";
    return NULL;
}

static const char *judge_sink(const json_t *shown)
{
    const size_t count = json_array_size(json_object_get(shown, "multipliers"));
    const bool is_small = side(shown, "determinant", 1) < 0 && side(shown, "determinant", -1) > 0;

    return is_small && count_multipliers(shown, -1) == count
               ? NULL
               : "the multipliers, as they are written, are not all inside the unit circle";
}

static const char *judge_symmetric(const json_t *shown)
{
    const char *type = json_string_value(json_object_get(json_object_get(shown, "symmetry"), "type"));
    const int above = side(shown, "trace", 2), below = side(shown, "trace", -2);
    const bool fits = type != NULL
                      && (strcmp(type, "elliptic") == 0             ? above < 0 && below > 0
                          : strcmp(type, "hyperbolic") == 0         ? above > 0
                          : strcmp(type, "inverse hyperbolic") == 0 ? below < 0
                                                                    : true);

    return fits ? NULL : "the trace, as it is written, does not tell the type of the orbit";
}

static const char *judge_elliptic(const json_t *shown)
{
    const char *problem = judge_symmetric(shown);

    if (problem != NULL) return problem;
    if (side(shown, "trace", 0) == 0 || side(shown, "trace", -1) == 0)
        return "the trace, as it is written, may be that of a multiplier which is a root of unity";
    return side(json_object_get(shown, "twist"), "coefficient", 0) != 0 ? NULL : "the twist, as it is written, may be 0";
}

/* The tangent has the component 1 in the state that the reversor flips; another component must differ from 0. */
static const char *judge_homoclinic(const json_t *given, const json_t *shown)
{
    const json_t *part = json_object_get(shown, "homoclinic"), *tangent = json_object_get(part, "tangent");
    const json_t *first = json_array_get(json_object_get(json_object_get(given, "homoclinic"), "legs"), 0);
    const char *name;
    json_t *ball;
    size_t count = 0;

    if (count_multipliers(shown, 1) != 1 || count_multipliers(shown, -1) != 1)
        return "the multipliers, as they are written, are not one outside and one inside the unit circle";
    if (side(part, "start", 0) == 0) return "the homoclinic orbit, as its start is written, may be the saddle";
    if (!is_near(json_object_get(part, "first"), first)) return "the homoclinic orbit's first point is written with much more room "
                                                                "than its box has";
    json_object_foreach((json_t *)(uintptr_t)tangent, name, ball) count += side(tangent, name, 0) != 0;
    return count > 1 ? NULL : "the manifolds, as their tangents are written, may be tangent";
}

const char *jlt_said_problem(const char *kind, const json_t *given, const json_t *shown)
{
    const char *problem;

    if (strcmp(kind, "equilibria") == 0) return NULL;
    if (strcmp(kind, "pole") == 0) return side(shown, "time", 0) > 0 ? NULL : "the time, as it is written, may be 0";
    problem = judge_cycle(given, shown);

    if (problem != NULL) return problem;
    if (strcmp(kind, "obstruction") == 0 && side(shown, "determinant", 1) == 0)
        return "the determinant, as it is written, may be 1";
    if (strcmp(kind, "sink") == 0) return judge_sink(shown);
    if (strcmp(kind, "symmetric") == 0) return judge_symmetric(shown);
    if (strcmp(kind, "elliptic") == 0) return judge_elliptic(shown);
    return strcmp(kind, "homoclinic") == 0 ? judge_homoclinic(given, shown) : NULL;
}
