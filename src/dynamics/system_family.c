/* The maps of a family of systems, each made when it is asked for. */
#include "dynamics/map.h"
#include "dynamics/system.h"

static void clear(jlt_system_member *self)
{
    jlt_map_destroy(self->map);
    jlt_system_destroy(self->system);
    *self = (jlt_system_member){ .map = NULL };
}

/* Set the member to the system and the map of a value, unless it has them. */
static jlt_status find(jlt_system_member *self, jlt_map **map, const jlt_system_family *family, double value,
                       const jlt_system *near)
{
    jlt_status st = JLT_OK;

    if (self->map == NULL || self->value != value) {
        clear(self);
        JLT_TRY(family->make(family->context, &self->system, value, near));
        self->value = value;
        JLT_TRY(jlt_map_create(&self->map, &self->system->flow));
    }
    *map = self->map;
done:
    if (st != JLT_OK) clear(self);
    return st;
}

jlt_status jlt_system_map_at(void *context, jlt_map **map, double value)
{
    jlt_system_family *self = context;

    return find(&self->at, map, self, value, NULL);
}

jlt_status jlt_system_map_near(void *context, jlt_map **map, double value)
{
    jlt_system_family *self = context;

    return find(&self->near, map, self, value, self->at.system);
}

void jlt_system_family_clear(jlt_system_family *self)
{
    clear(&self->at);
    clear(&self->near);
}
