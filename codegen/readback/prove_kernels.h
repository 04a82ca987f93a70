/** Proofs of translation: what the emitted kernels compute is what the table says.
 *
 *  Every kernel of every field (variant, time, elimination) is read back from its straight-line program, instruction by
 *  instruction, as exact ratios, and compared with the model evaluated by the prover, which shares no code with the passes
 *  that made the program. Jacobians, gradients and divergences are compared with derivatives of the ratios themselves. In a
 *  lifted time the root is a coordinate of its own: the field is compared on root^2 = radicand, its derivatives off it as well. */
#ifndef TTC_PROVE_KERNELS_H
#define TTC_PROVE_KERNELS_H

#include "kernels/catalogue.h"
#include "prove/prove.h"

/** Append to `report` one proof for each kernel, kind "kernel", name "FIELD KERNEL", and update its totals.
 *  Returns false when memory is out; the report is then still valid. Cost: seconds for tables of a dozen states. */
bool ttc_prove_kernels(const ttc_catalogue *catalogue, ttc_proof_report *report);

#endif
