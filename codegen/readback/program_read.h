/** Reads a straight-line program back: its outputs as exact ratios of its inputs. */
#ifndef TTC_PROGRAM_READ_H
#define TTC_PROGRAM_READ_H

#include "optimize/program.h"
#include "algebra/valuation.h"

/** outputs: shape (output_count,), initialized by the caller. inputs and parameters: what x[i] and p[i] stand for.
 *  Roots are positive square roots in the valuation's ring; other functions must follow from those of the model. Errors: the
 *  ring's status; an index beyond input_count or parameter_count sets it to TTC_RING_CIRCULAR.
 *  Returns false when memory is out. */
bool ttc_program_read(const ttc_program *program, ttc_valuation *valuation, const ttc_ratio *inputs, size_t input_count,
                      const ttc_ratio *parameters, size_t parameter_count, ttc_ratio *outputs);

#endif
