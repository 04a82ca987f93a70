/** Writing C: constants, expressions, kernel bodies, and whole files. Everything is a pure function of its arguments. */
#ifndef TTC_EMIT_H
#define TTC_EMIT_H

#include "fields/prepared.h"
#include "kernels/catalogue.h"
#include "optimize/program.h"
#include "fields/formula.h"
#include "prove/prove.h"

/** How programs are spelled: the type of temporaries, inputs (input INDEX input_end), parameters (parameter ARRAY
 *  parameter_middle INDEX parameter_end), what makes a constant one of that type, functions, outputs (output INDEX
 *  output_middle VALUE output_end), and whether each temporary carries its formula. */
typedef struct {
    const char *type, *input, *input_end;
    const char *parameter, *parameter_middle, *parameter_end;
    const char *broadcast, *broadcast_end;
    const char *root, *cosine, *sine, *exp, *log;
    const char *output, *output_middle, *output_end;
    bool formulas;
} ttc_dialect;

extern const ttc_dialect ttc_dialect_scalar;

/* The nearest double to pi. */
#define TTC_PI_DOUBLE "0x1.921fb54442d18p+1"

/* The name of a function of one operand in C and in Arb, "sqrt", "cos", ...; "" for other operations. */
const char *ttc_emit_function_name(ttc_op op);

/* True when the program has such an instruction. */
bool ttc_emit_uses(const ttc_program *program, ttc_op op);

/** The statements of a kernel. Temporaries are t0, t1, ...; each carries its formula.
 *  prepared: where p[] points to, NULL for raw parameters; parameters: the C name of that array;
 *  offset: index of the first output. */
void ttc_emit_body(ttc_text *text, const ttc_dialect *dialect, const ttc_program *program, const ttc_field *field,
                   const ttc_prepared *prepared, const char *parameters, size_t offset);

/* The whole function `static void NAME(x, PARAMETERS, out) { ... }` of a program. */
void ttc_emit_function(ttc_text *text, const char *name, const ttc_program *program, const ttc_field *field,
                       const ttc_prepared *prepared);

/* The function that computes expressions in the field's symbols from raw parameters, followed by an empty line. False when memory
 * is out. */
bool ttc_emit_outputs(ttc_text *text, const char *name, ttc_field *field, const ttc_id *ids, size_t count);

/* The same with a numbered name, such as section0_lift from "section", 0 and "lift". */
bool ttc_emit_numbered(ttc_text *text, const char *what, size_t number, const char *name, ttc_field *field, const ttc_id *ids,
                       size_t count);

/* The unsimplified field in complex arithmetic, a function named rhs_complex. */
void ttc_emit_complex(ttc_text *text, ttc_field *field);

/* Where a kernel loses digits, from the denominators, roots and sums it evaluates, item by item; nothing when nowhere. */
#define TTC_LOSS_SEPARATOR "; "
void ttc_emit_losses(ttc_text *text, ttc_kernels *kernels, ttc_kernel_kind kind);

/* The part of that text that is about sums, appended to what the text already holds. */
void ttc_emit_cancellations(ttc_text *text, const ttc_kernels *kernels, ttc_kernel_kind kind);

/* Kernels and table of the equilibria served; the table is named `equilibria`. False: memory, or a claim's expression is
 * not of the form it must have. */
bool ttc_emit_equilibria(ttc_text *text, ttc_kernels *kernels);

/* Name parts: "general", "balanced_in_regular_on_level_omega3", ... */
void ttc_emit_stem(ttc_text *text, const ttc_field *field);

/* The table of balls that serves a field, "jlt_balls_MODEL_STEM": its variant is no part of the stem. */
void ttc_emit_ball_name(ttc_text *text, const ttc_field *field);

/* The kernels of one descriptor on vectors of lanes, to be compiled once for each instruction set. */
void ttc_emit_lanes(ttc_text *text, const ttc_kernels *kernels);

/* Of these `stages_varied`: Runge-Kutta stages of the variational equations. It uses the inline kernels `linear` (field and
 * Jacobian) and `clock` above it. */
void ttc_emit_stages_varied(ttc_text *text, const ttc_kernels *kernels);

/* The function `jet`: Taylor coefficients of the solution, scalar and on lanes. Its recurrences are in runtime/kernel_jet.h. */
void ttc_emit_jet(ttc_text *text, const ttc_kernels *kernels);
void ttc_emit_jet_lanes(ttc_text *text, const ttc_kernels *kernels);

/* The instruction sets of batched kernels. */
enum { TTC_ISA_COUNT = 3 };
extern const char *const ttc_isa_names[TTC_ISA_COUNT], *const ttc_isa_files[TTC_ISA_COUNT];

/* The file that compiles all batched kernels of a model for one instruction set. */
void ttc_emit_batch(ttc_text *text, const ttc_catalogue *catalogue, unsigned isa);

/* What the table's reversors that change signs of states, and no more, make of each: arrays, and the descriptor's members. Nothing
 * where there are none. */
void ttc_emit_reversors(ttc_text *text, const ttc_field *field);
void ttc_emit_reversor_member(ttc_text *text, const ttc_field *field);

/* An array of quantities; nothing when there are none. is_angle: NULL, or shape (count,): states that are angles. */
void ttc_emit_quantities(ttc_text *text, const char *name, const ttc_model *model, const uint32_t *symbols, size_t count,
                         const bool *is_angle);

/* Lifted roots of a field: kernels of their relations; the descriptor's members on them, and on an eliminated state. False when
 * memory is out. */
bool ttc_emit_roots(ttc_text *text, ttc_field *field);
void ttc_emit_root_member(ttc_text *text, const ttc_field *field);

/* The poles of the general field, with all its states: the array, and the descriptor's members. */
void ttc_emit_poles(ttc_text *text, const ttc_field *field);
void ttc_emit_pole_member(ttc_text *text, const ttc_field *field);

/** Kernels and table of the sections that have coordinates, of the general field with all its states; the table is named
 *  `sections`, and *count is its length. One whose table of coordinates does not fit is left out. False when memory is out. */
bool ttc_emit_sections(ttc_text *text, ttc_kernels *kernels, size_t *count);

/** What gives a parameter of another table, as jlt_source of kernel_abi.h says. In: name, of the parameter there; value, in this
 *  table's names, or with is_root its square. -1: memory is out. */
int ttc_emit_source(const ttc_model *model, const char *name, ttc_id value, bool is_root);

/** The name, in the target, of a parameter that a reduction onto it gives by another name or none, see jlt_claim; NULL: there is
 *  none, the claim is no such reduction, or memory is out. */
const char *ttc_emit_renamed(const ttc_model *model, const ttc_claim *claim, const ttc_model *target);

/** Kernels and table of the ways to tables that serve in place of the field's own, of the general field with all its states;
 *  the table is named `ways`, and *count is its length. One whose table does not fit is left out. False when memory is out. */
bool ttc_emit_ways(ttc_text *text, ttc_kernels *kernels, size_t *count);

/* The conditions of `tier`, of such a field, and their kernel; the states with their lifted roots, of any field in a time that
 * lifts some; and the descriptor's members. */
bool ttc_emit_tier(ttc_text *text, ttc_field *field);
bool ttc_emit_lifted(ttc_text *text, const ttc_field *field);
void ttc_emit_way_members(ttc_text *text, const ttc_field *field, size_t ways);

/** What the equations divide by, factor by factor, where it may be zero: the array `divisors`, of *count, and its kernel. Of the
 *  general field without lifted roots; *count is 0 for others. False when memory is out. */
bool ttc_emit_divisors(ttc_text *text, ttc_field *field, size_t *count);

/* The file of one descriptor. */
bool ttc_emit_descriptor(ttc_text *text, ttc_kernels *kernels);

/* The command that writes such kernels. */
void ttc_emit_command(ttc_text *text, const ttc_kernels *kernels);

/* What the descriptors of a model share: its table, its claims with their verdicts, the list of the descriptors; and the
 * declarations of these. report: of the catalogue's own table. */
void ttc_emit_model(ttc_text *text, const ttc_catalogue *catalogue, const ttc_proof_report *report);
void ttc_emit_model_names(ttc_text *text, const ttc_model *model);

/* The ball-arithmetic file of one model, of its fields without variant. */
bool ttc_emit_ball(ttc_text *text, const ttc_catalogue *catalogue);

#endif
