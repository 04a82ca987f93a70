/** Writes the sentences of a certificate about a symmetric orbit. */
#ifndef JLT_VALIDATED_THEOREM_SYMMETRY_H
#define JLT_VALIDATED_THEOREM_SYMMETRY_H

#include <jansson.h>
#include <stdio.h>

/** In: given; symmetry, as jlt_shown_symmetry makes it. */
void jlt_theorem_symmetry_write(FILE *out, const json_t *given, const json_t *symmetry);

/** In: twist, as jlt_shown_twist makes it. */
void jlt_theorem_symmetry_write_twist(FILE *out, const json_t *twist);

#endif
