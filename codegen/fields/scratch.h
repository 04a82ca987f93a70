/** A graph beside the field's, for forms that are only tried: every order in a program rests on the field's ids, so that a
 *  trial must leave no node behind. What is known of the scratch graph's nodes is kept beside it. */
#ifndef TTC_SCRATCH_H
#define TTC_SCRATCH_H

#include "fields/field.h"

typedef struct ttc_scratch {
    ttc_field *field;
    ttc_graph *graph;
    ttc_id *images, *forms;  /* by the field's id: the same expression here; the form found for a sum, in the field's graph */
    size_t image_capacity;
    ttc_extent *extents;     /* by id of this graph */
    unsigned char *heights;  /* by id, + 1; 0: not known yet */
    size_t capacity;
    unsigned attempts;       /* at other forms, so far: they are counted, for their number is bounded */
    bool failed;             /* memory is out */
} ttc_scratch;

/* The field's scratch graph, made when it is first asked for; an overgrown one is emptied. NULL: memory. */
ttc_scratch *ttc_scratch_of(ttc_field *field);
void ttc_scratch_destroy(ttc_scratch *scratch); /* legal on NULL */

/* An expression of the field's graph in this one, and the other way round. TTC_NONE: the graph refuses, or memory is out. */
ttc_id ttc_scratch_import(ttc_scratch *scratch, ttc_id id);
ttc_id ttc_scratch_export(ttc_scratch *scratch, ttc_id id);

/* What a symbol stands for, as an expression here: a unit's sum, a root's radicand; TTC_NONE for all others. */
ttc_id ttc_scratch_definition(ttc_scratch *scratch, ttc_id symbol, ttc_role role);

ttc_extent ttc_scratch_extent(ttc_scratch *scratch, ttc_id id);

/** Heights of definitions: a sum of plain symbols has height 1, a sum or unit that holds it 2; a root has that of its
 *  radicand's terms. */
unsigned ttc_scratch_height(ttc_scratch *scratch, ttc_id id);
/* The greatest of the heights of an expression's parts. */
unsigned ttc_scratch_height_inside(ttc_scratch *scratch, ttc_id id);

#endif
