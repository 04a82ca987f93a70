/* Follows the saddle of the map as E falls, and prints its bifurcations. */
#include <jellett.h>
#include <stdio.h>

static jlt_status tell(void *context, const jlt_continuation_point *p)
{
    (void)context;
    if (p->kind != JLT_BIFURCATION_NONE) printf("%.12g,%s\n", p->value, jlt_continuation_bifurcation_name(p->kind));
    return JLT_OK;
}

int main(void)
{
    static jlt_continuation_point first = { .value = 2.15 };
    jlt_surface_family top;
    jlt_system_family systems = { .make = jlt_surface_at, .context = &top };
    const jlt_family family = { jlt_system_map_at, &systems, jlt_system_map_near };
    jlt_map *map;
    jlt_continuation_end end;
    jlt_status st;

    JLT_TRY(jlt_surface_family_init(&top, jlt_descriptor_find("spherical_top", NULL, NULL, NULL), "E"));
    JLT_TRY(family.map_at(family.context, &map, first.value));
    JLT_TRY(jlt_periodic_find(map, &first.orbit, (const double[]){ 0, -0.61 }, 1, NULL));
    JLT_TRY(jlt_continuation_run(&end, &family, &first, -1, &(jlt_continuation_options){ .low = 1.9, .high = 2.2 }, tell, NULL));
done:
    jlt_system_family_clear(&systems);
    return st != JLT_OK;
}
