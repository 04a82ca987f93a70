#include "validated/theorem.h"

#include "validated/theorem_sentence.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bool jlt_theorem_is_proved(const jlt_descriptor *descriptor, const jlt_reversor *reversor)
{
    const jlt_claim *claim = &descriptor->claims[reversor->claim];

    return claim->verdict == JLT_PROVED && claim->condition[0] == '\0';
}

const jlt_reversor *jlt_theorem_reversor(const jlt_descriptor *descriptor)
{
    for (unsigned i = 0; i < descriptor->reversor_count; i++)
        if (jlt_theorem_is_proved(descriptor, &descriptor->reversors[i])) return &descriptor->reversors[i];
    return NULL;
}

json_t *jlt_theorem_flipped(const jlt_descriptor *descriptor, const jlt_reversor *reversor)
{
    json_t *flipped = json_array();

    for (unsigned i = 0; i < descriptor->state_count; i++)
        if (reversor->signs[i] < 0) json_array_append_new(flipped, json_string(descriptor->states[i].name));
    return flipped;
}

const jlt_reversor *jlt_theorem_reversor_of(const jlt_descriptor *descriptor, const json_t *flipped)
{
    const jlt_reversor *found = NULL;

    for (unsigned i = 0; i < descriptor->reversor_count && found == NULL; i++) {
        const jlt_reversor *reversor = &descriptor->reversors[i];
        json_t *names = jlt_theorem_is_proved(descriptor, reversor) ? jlt_theorem_flipped(descriptor, reversor) : NULL;
        if (names != NULL && json_equal(names, flipped)) found = reversor;
        json_decref(names);
    }
    return found;
}

static bool has_radius(const json_t *values)
{
    const char *name;
    json_t *value;

    json_object_foreach((json_t *)(uintptr_t)values, name, value)
        if (json_is_object(value)) return true;
    return false;
}

static void write_setting(FILE *out, const jlt_theorem_subject *s)
{
    const jlt_descriptor *d = s->descriptor;
    const json_t *given = s->given, *section = json_object_get(given, "section"), *levels = json_object_get(given, "levels");

    fprintf(out, "Take the equations of the table %s (%s%sSHA-256 %s)", d->model, d->title, d->title[0] != '\0' ? "; " : "",
            d->sha256);
    if (d->param_count > 0) fputs(" with ", out);
    jlt_theorem_text_named(out, json_object_get(given, "parameters"));
    fputc('.', out);
    if (json_object_size(levels) > 0) {
        fputs(" Levels: ", out);
        jlt_theorem_text_named(out, levels);
        fputc('.', out);
    }
    fprintf(out, " Section: %s = %s, crossed %s.", jlt_theorem_text_of(section, "state"),
            jlt_theorem_text_of(section, "value"),
            json_integer_value(json_object_get(section, "direction")) > 0 ? "upwards" : "downwards");
    if (has_radius(json_object_get(given, "parameters")) || has_radius(levels))
        fputs(" What follows holds for each value that a parameter or level has within its radius, with "
              "balls that hold for all of them.", out);
}

/* The sum of the legs' instants, in doubles. */
static double way(const json_t *legs)
{
    double sum = 0;

    for (size_t i = 0; i < json_array_size(legs); i++)
        sum += strtod(jlt_theorem_text_of(json_array_get(legs, i), "instant"), NULL);
    return sum;
}

static void write_orbit(FILE *out, const jlt_theorem_subject *s)
{
    const jlt_descriptor *d = s->descriptor;
    const json_t *shown = s->shown, *legs = json_object_get(s->given, "legs"), *first = json_array_get(legs, 0);
    const size_t count = json_array_size(legs);

    fputs("Through the box ", out);
    jlt_theorem_text_named(out, json_object_get(first, "box"));
    fputs(" of the section", out);
    if (count > 1) fprintf(out, ", and in turn through %zu more of it that are listed under \"legs\",", count - 1);
    fprintf(out, " there is exactly one orbit%s that is back at its point", jlt_theorem_text_levels(s, " on these levels"));
    jlt_theorem_turns_write_all(out, legs, d);
    fputs(" after a time near ", out);
    if (count > 1) {
        fprintf(out, "%.17g, from box to box in the times listed", way(legs));
        jlt_theorem_turns_write_legs(out, legs, d);
    } else fputs(jlt_theorem_text_of(first, "instant"), out);
    fputs(count > 1 ? ". Its first point is " : ". That point is ", out);
    jlt_theorem_text_named(out, json_array_get(json_object_get(shown, "orbit"), 0));
    fputs(", the time T = ", out);
    jlt_theorem_text_ball(out, json_object_get(shown, "period"));
    fputc('.', out);
    jlt_theorem_turns_write_sense(out, legs, d);
}

static void write_multipliers(FILE *out, const jlt_theorem_subject *s)
{
    const json_t *shown = s->shown, *multipliers = json_object_get(shown, "multipliers");

    fprintf(out, "%sdet DP = exp(integral of div f over the orbit) = ", jlt_theorem_text_levels(s, "On the levels, "));
    jlt_theorem_text_ball(out, json_object_get(shown, "determinant"));
    fputs(", trace DP = ", out);
    jlt_theorem_text_ball(out, json_object_get(shown, "trace"));
    for (size_t i = 0; i < json_array_size(multipliers); i++) {
        const json_t *value = json_array_get(multipliers, i);
        fprintf(out, "; multiplier (");
        jlt_theorem_text_ball(out, json_object_get(value, "re"));
        fputs(") + i (", out);
        jlt_theorem_text_ball(out, json_object_get(value, "im"));
        fputc(')', out);
    }
    fputc('.', out);
}

/* shown: the object with "conditions". */
static void write_conditions_of(FILE *out, const jlt_descriptor *d, const json_t *shown, const char *where)
{
    const char *name;
    json_t *bound;
    bool first = true;

    json_object_foreach(json_object_get(shown, "conditions"), name, bound) {
        const char *meaning = "";
        for (unsigned i = 0; i < d->valid_count; i++)
            if (strcmp(d->valids[i].name, name) == 0) meaning = d->valids[i].meaning;
        const bool is_shown = strtod(jlt_theorem_text(bound), NULL) > 0;
        fprintf(out, "%s%s condition %s", first ? "" : " ", is_shown ? "The" : "Of the", name);
        if (meaning[0] != '\0') fprintf(out, " (%s)", meaning);
        if (is_shown) fprintf(out, " holds %s: its quantity is at least %s.", where, jlt_theorem_text(bound));
        else fputs(" it is not shown that it holds.", out);
        first = false;
    }
}

static void write_image(FILE *out, const jlt_theorem_subject *s)
{
    const jlt_reversor *reversor = jlt_theorem_reversor(s->descriptor);
    json_auto_t *flipped = reversor == NULL ? NULL : jlt_theorem_flipped(s->descriptor, reversor);

    if (flipped == NULL) return;
    fputs("The image of the orbit under the reversor ", out);
    jlt_theorem_text_flips(out, flipped);
    fprintf(out, ", time reversed, is another periodic orbit, which has the inverse multipliers%s: it repels.",
            jlt_theorem_text_levels(s, " on the images of the levels"));
}

static bool add(json_t *words, FILE **out, char **text)
{
    const bool closed = fclose(*out) == 0;
    const bool added = closed && ((*text)[0] == '\0' || json_array_append_new(words, json_string(*text)) == 0);

    free(*text);
    *text = NULL;
    *out = NULL;
    return added;
}

/* Names the reversor if `given` does. */
static void write_saddle(FILE *out, const jlt_theorem_subject *s)
{
    const json_t *flipped = json_object_get(json_object_get(s->given, "homoclinic"), "reversor");

    fputs("Both multipliers are real, one outside the unit circle, one inside: a saddle. Its image under the reversor ", out);
    if (flipped != NULL) {
        jlt_theorem_text_flips(out, flipped);
        fputc(' ', out);
    }
    fputs("passes through the same box after the same time, hence is the orbit itself.", out);
}

static void write_homoclinic(FILE *out, const jlt_theorem_subject *s)
{
    const json_t *asked = json_object_get(s->given, "homoclinic"), *found = json_object_get(s->shown, "homoclinic");

    fputs("In coordinates u, s along the columns of the frame listed under \"homoclinic\" its local unstable manifold is a graph "
          "s = g(u) over |u| <= ", out);
    jlt_theorem_text_ball(out, json_object_get(asked, "reach"));
    fprintf(out,
            ". Through that graph, and in turn through the %zu boxes of the section listed there, there is exactly one orbit that "
            "goes on to meet %s = 0 %s at a point where all states that the reversor flips are 0. It begins at ",
            json_array_size(json_object_get(asked, "legs")),
            jlt_theorem_text_of(json_object_get(s->given, "section"), "state"),
            json_integer_value(json_object_get(asked, "landing")) > 0 ? "upwards" : "downwards");
    jlt_theorem_text_named(out, json_object_get(found, "first"));
    fputs("; the symmetric point is ", out);
    jlt_theorem_text_named(out, json_object_get(found, "point"));
    fputs(". It is not the saddle's. As the reversor takes the unstable manifold to the stable one, the orbit lies on both: it is "
          "homoclinic.", out);
}

static void write_tangent(FILE *out, const jlt_theorem_subject *s)
{
    fputs("At the symmetric point a tangent of the unstable manifold on the section is ", out);
    jlt_theorem_text_named(out, json_object_get(json_object_get(s->shown, "homoclinic"), "tangent"));
    fprintf(out, "; that of the stable manifold has the opposite sign in what the reversor flips. They differ: the manifolds cross "
            "transversally%s.", jlt_theorem_text_levels(s, " in their levels"));
}

static void write_sink_measure(FILE *out, const jlt_theorem_subject *s)
{
    const json_t *legs = json_object_get(s->given, "legs");

    fputs("Hence no measure that has a continuous positive density", out);
    jlt_theorem_turns_write_density(out, " ", legs, s->descriptor, "");
    fputs(" is invariant under this flow, nor one that has a density ", out);
    jlt_theorem_turns_write_density(out, "", legs, s->descriptor, " ");
    fprintf(out, "positive almost everywhere near the orbit and is finite there: a neighbourhood%s shrinks under the flow to the "
            "cycle%s alone, a set of measure zero.",
            jlt_theorem_text_levels(s, ", made up of these basins,"), jlt_theorem_text_levels(s, "s"));
}

static void write_expansion(FILE *out, const jlt_theorem_subject *s)
{
    const json_t *legs = json_object_get(s->given, "legs");

    fputs("The flow over T multiplies volumes at a point x of the orbit by this determinant, which is not 1. Hence no measure "
          "whose density rho", out);
    jlt_theorem_turns_write_density(out, ", ", legs, s->descriptor, ",");
    fprintf(out, " is continuous and positive at that orbit is invariant under this flow%s: rho(phi_T x) det Dphi_T(x) = rho(x) "
            "would hold at ", jlt_theorem_text_levels(s, ", nor one with such a density on its levels"));
    fputs(jlt_theorem_turns_any(legs, s->descriptor) ? "x, and phi_T x is x but for these periods." : "x = phi_T x.", out);
}

static void write_attraction(FILE *out, const jlt_theorem_subject *s)
{
    fprintf(out, "All multipliers lie inside the unit circle, |mu| < 1: the orbit attracts, exponentially and with asymptotic "
            "phase, what begins near it%s.",
            jlt_theorem_text_levels(s, " on its levels, and so do its continuations on all levels nearby"));
}

static void write_horseshoe(FILE *out, const jlt_theorem_subject *s)
{
    const bool has_levels = json_object_size(json_object_get(s->given, "levels")) > 0;

    fprintf(out, "Hence, by the theorem of Smale and Birkhoff, a section across the flow%s has an iterate of its return map with a "
            "horseshoe near this orbit: the flow there has positive topological entropy, and infinitely many periodic orbits of "
            "saddle type. ", jlt_theorem_text_levels(s, " on these levels"));
    fputs(has_levels ? "A transversal crossing remains on all levels nearby, so that no" : "So no", out);
    fprintf(out, " real-analytic function that is defined on a connected neighbourhood of both orbits is a%s integral: it %s (J. "
            "Moser, Stable and Random Motions, 1973).", jlt_theorem_text_levels(s, " further"),
            has_levels ? "depends on those named" : "is constant");
}

static void write_conditions(FILE *out, const jlt_theorem_subject *s)
{
    write_conditions_of(out, s->descriptor, s->shown, s->where);
}

static void write_conditions_of_way(FILE *out, const jlt_theorem_subject *s)
{
    write_conditions_of(out, s->descriptor, json_object_get(s->shown, "homoclinic"),
                        "all along that orbit from its first point to the symmetric one");
}

#define ORBIT write_setting, write_orbit, write_multipliers, write_conditions
#define ALONG "all along the orbit"

/* The sentences of each kind, in their order. */
static const struct {
    const char *kind, *where; /* where: conditions hold */
    jlt_theorem_sentence *sentences[10]; /* until NULL */
} contents[] = {
    { "cycle", ALONG, { ORBIT } },
    { "elliptic", ALONG, { ORBIT, jlt_theorem_symmetry_write, jlt_theorem_symmetry_write_twist } },
    { "equilibria", "at each of them",
      { jlt_theorem_family_setting, jlt_theorem_family_trace, write_conditions, jlt_theorem_family_measure } },
    { "homoclinic", ALONG,
      { ORBIT, write_saddle, write_homoclinic, write_tangent, write_conditions_of_way, write_horseshoe } },
    { "obstruction", ALONG, { ORBIT, write_expansion } },
    { "pole", "all the way", { jlt_theorem_pole_setting, jlt_theorem_pole_end, jlt_theorem_pole_limits, write_conditions } },
    { "symmetric", ALONG, { ORBIT, jlt_theorem_symmetry_write } },
    { "sink", ALONG, { ORBIT, write_attraction, write_image, write_sink_measure } },
};

bool jlt_theorem_is_kind(const char *kind)
{
    for (size_t i = 0; i < sizeof contents / sizeof *contents; i++)
        if (strcmp(contents[i].kind, kind) == 0) return true;
    return false;
}

json_t *jlt_theorem_words(const char *kind, const jlt_descriptor *descriptor, const json_t *given, const json_t *shown)
{
    jlt_theorem_subject s = { descriptor, given, shown, NULL };
    jlt_theorem_sentence *const *which = NULL;
    json_t *words = json_array();

    for (size_t i = 0; i < sizeof contents / sizeof *contents; i++)
        if (strcmp(contents[i].kind, kind) == 0) which = contents[i].sentences, s.where = contents[i].where;
    for (; words != NULL && *which != NULL; which++) {
        char *text = NULL;
        size_t size = 0;
        FILE *out = open_memstream(&text, &size);
        if (out != NULL) (*which)(out, &s);
        if (out == NULL || !add(words, &out, &text)) {
            json_decref(words);
            words = NULL;
        }
    }
    return words;
}
