/** Views of a model: definitions, equations and the Jacobian. Each returns false when an expression is too large or memory is out;
 *  what was written before stays. */
#ifndef TTC_SHOW_H
#define TTC_SHOW_H

#include "read/model.h"

typedef bool (*ttc_show_writer)(FILE *stream, const ttc_model *model);

bool ttc_show_text(FILE *stream, const ttc_model *model);  /* in the language of tables */
bool ttc_show_latex(FILE *stream, const ttc_model *model); /* align environments, for a document that loads amsmath */
bool ttc_show_dot(FILE *stream, const ttc_model *model);   /* the graph of the equations, shared nodes once (Graphviz) */

#endif
