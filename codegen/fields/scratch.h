/** A second graph, for trying other forms of expressions. Programs are ordered by ids of the field's graph, so that
 *  a trial must not add nodes to it. Extents and heights of scratch nodes are stored with the scratch graph. */
#ifndef TTC_SCRATCH_H
#define TTC_SCRATCH_H

#include "fields/field.h"

typedef struct ttc_scratch {
    ttc_field *field;
    ttc_graph *graph;
    ttc_id *images, *forms;  /* by id of the field's graph: the copy in this graph; the form found for a sum, in the field's */
    size_t image_capacity;
    ttc_extent *extents;     /* by id of this graph; signs = 0: not computed */
    unsigned char *heights;  /* by id of this graph, height + 1; 0: not computed */
    size_t capacity;
    unsigned attempts;       /* number of other forms that were tried, which is bounded */
    bool failed;             /* memory is out */
} ttc_scratch;

/* The field's scratch graph, created at the first call; one with too many nodes is replaced by an empty one, and its ids become
 * invalid. Returns NULL when memory is out. */
ttc_scratch *ttc_scratch_of(ttc_field *field);
void ttc_scratch_destroy(ttc_scratch *scratch); /* legal on NULL */

/* Copy a node from one graph to another, parts first; TTC_DEPTH_LIMIT bounds the recursion. In/out: images, the copies by id in
 * `from`, TTC_NONE for those not made yet; a symbol without one keeps its number. Returns TTC_NONE if the graph fails or memory is
 * out. */
ttc_id ttc_carry(ttc_graph *to, const ttc_graph *from, ttc_id id, ttc_id *images);

/* Copy an expression from the field's graph to the scratch graph, and back. Return TTC_NONE if a graph fails or memory is out. */
ttc_id ttc_scratch_import(ttc_scratch *scratch, ttc_id id);
ttc_id ttc_scratch_export(ttc_scratch *scratch, ttc_id id);

/* The definition, in the scratch graph, of a symbol of this role: UNIT, its sum; ROOT, its radicand; TTC_NONE for other nodes. */
ttc_id ttc_scratch_definition(ttc_scratch *scratch, ttc_id symbol, ttc_role role);

ttc_extent ttc_scratch_extent(ttc_scratch *scratch, ttc_id id);

/** The height of an expression: the depth to which sums and units nest in it. A sum or unit of plain symbols has height 1, one
 *  that contains it 2; a root has the greatest height of its radicand's terms. */
unsigned ttc_scratch_height(ttc_scratch *scratch, ttc_id id);
/* The greatest height of an expression's parts; of a symbol its own. */
unsigned ttc_scratch_height_inside(ttc_scratch *scratch, ttc_id id);

#endif
