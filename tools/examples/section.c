/* Five returns of the spherical top to the section that its tables describe, at the values of (5.1) of the paper. */
#include <jellett.h>
#include <stdio.h>

int main(void)
{
    const double start[] = { 0.1, -0.6 }; /* eta, gamma3 */
    jlt_surface surface;
    const jlt_claim *broken;
    jlt_system *system = NULL;
    jlt_section *section = NULL;
    jlt_return at;
    jlt_status st;

    JLT_TRY(jlt_surface_find(&surface, &broken, jlt_descriptor_find("spherical_top", NULL, NULL, NULL), NULL, NULL));
    JLT_TRY(jlt_surface_system(&system, &surface, surface.defaults, NULL));
    JLT_TRY(jlt_section_create(&section, &system->flow));
    JLT_TRY(jlt_section_start(section, &at, start, +1));
    while (at.fate == JLT_FATE_ALIVE && at.number < 5) {
        JLT_TRY(jlt_section_next(section, &at));
        printf("%zu,%.15g,%.15g,%.15g,%s\n", at.number, at.t, at.q[0], at.q[1], jlt_section_fate_name(at.fate));
    }
done:
    if (st != JLT_OK) fprintf(stderr, "section: %s\n", jlt_status_text(st));
    jlt_section_destroy(section);
    jlt_system_destroy(system);
    return st != JLT_OK;
}
