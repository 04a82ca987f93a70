/** Writes C: constants, expressions, kernel bodies, and whole files, as pure functions of the arguments. Writers that return a bool
 *  return false when memory is out, those that take ttc_kernels also, with kernels->failed_claim, when kernels of a claim
 *  cannot be written. */
#ifndef TTC_EMIT_H
#define TTC_EMIT_H

#include "fields/prepared.h"
#include "kernels/catalogue.h"
#include "optimize/program.h"
#include "fields/formula.h"
#include "prove/prove.h"

/** How programs are spelled: the type of temporaries; `input INDEX input_end`, `parameter ARRAY parameter_middle INDEX
 *  parameter_end`; constants as `broadcast NUMBER broadcast_end`; functions; `output INDEX output_middle VALUE output_end`; and
 *  whether temporaries have their formulas as comments. */
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

/* Whether the program has such an instruction. */
bool ttc_emit_uses(const ttc_program *program, ttc_op op);

/** The constant 0 where more than 64 outputs have it, as in the Jacobian of a long chain; TTC_NO_VALUE elsewhere. One loop, before
 *  the other outputs, sets all of these: one statement an output takes the C compiler minutes. */
ttc_value ttc_emit_zeros(const ttc_program *program);

/** The statements of a kernel, with temporaries t0, t1, ...
 *  prepared: what the program's parameters stand for; NULL: raw parameters. parameters: the C name of their array. offset: index
 *  of the first output. */
void ttc_emit_body(ttc_text *text, const ttc_dialect *dialect, const ttc_program *program, const ttc_field *field,
                   const ttc_prepared *prepared, const char *parameters, size_t offset);

/* The whole function `static void NAME(x, PARAMETERS, out) { ... }` of a program. */
void ttc_emit_function(ttc_text *text, const char *name, const ttc_program *program, const ttc_field *field,
                       const ttc_prepared *prepared);

/* A function that computes expressions in the field's symbols from raw parameters, and an empty line. */
bool ttc_emit_outputs(ttc_text *text, const char *name, ttc_field *field, const ttc_id *ids, size_t count);

/* The same with a numbered name, such as section0_lift from "section", 0 and "lift". */
bool ttc_emit_numbered(ttc_text *text, const char *what, size_t number, const char *name, ttc_field *field, const ttc_id *ids,
                       size_t count);

/* The function rhs_complex: the unsimplified field in complex arithmetic. */
void ttc_emit_complex(ttc_text *text, ttc_field *field);

/* Where a kernel may lose digits, from the denominators, roots and sums that it evaluates, item by item. */
#define TTC_LOSS_SEPARATOR "; "
void ttc_emit_losses(ttc_text *text, ttc_kernels *kernels, ttc_kernel_kind kind);

/* The part of ttc_emit_losses about sums and functions of rounded arguments, appended to the text. */
void ttc_emit_cancellations(ttc_text *text, const ttc_kernels *kernels, ttc_kernel_kind kind);

/* Kernels of families of equilibria, and their table, `equilibria`. */
bool ttc_emit_equilibria(ttc_text *text, ttc_kernels *kernels);

/* The name of a field: "general", "balanced_in_regular_on_level_omega3", ... */
void ttc_emit_stem(ttc_text *text, const ttc_field *field);

/* The table of balls that serves a field, "jlt_balls_MODEL_STEM", its stem without the variant. */
void ttc_emit_ball_name(ttc_text *text, const ttc_field *field);

/* The kernels of one descriptor on vectors of lanes, to be compiled once for each instruction set. */
void ttc_emit_lanes(ttc_text *text, const ttc_kernels *kernels);

/* The part of ttc_emit_lanes that writes `stages_varied`: Runge-Kutta stages of the variational equations. The inline kernels
 * `linear` (field and Jacobian) and `clock` must stand above it. */
void ttc_emit_stages_varied(ttc_text *text, const ttc_kernels *kernels);

/* The function `jet`: Taylor coefficients of the solution, scalar and on lanes. Its recurrences are in runtime/kernel_jet.h. */
void ttc_emit_jet(ttc_text *text, const ttc_kernels *kernels);
void ttc_emit_jet_lanes(ttc_text *text, const ttc_kernels *kernels);

enum { TTC_ISA_COUNT = 3 };
extern const char *const ttc_isa_names[TTC_ISA_COUNT], *const ttc_isa_files[TTC_ISA_COUNT];

/* The file that compiles all batched kernels of a model for one instruction set. */
void ttc_emit_batch(ttc_text *text, const ttc_catalogue *catalogue, unsigned isa);

/* Reversors that only change signs of states: arrays of signs by state, and the descriptor's members. Nothing if there are none. */
void ttc_emit_reversors(ttc_text *text, const ttc_field *field);
void ttc_emit_reversor_member(ttc_text *text, const ttc_field *field);

/* An array of quantities; nothing if count is 0. is_angle: which are angles, shape (count,), or NULL. */
void ttc_emit_quantities(ttc_text *text, const char *name, const ttc_model *model, const uint32_t *symbols, size_t count,
                         const bool *is_angle);

/* Kernels of root^2 - radicand for the lifted roots of a field, and of its gradients; the descriptor's members about them and
 * about an eliminated state. */
bool ttc_emit_roots(ttc_text *text, ttc_field *field);
void ttc_emit_root_member(ttc_text *text, const ttc_field *field);

/* The poles of the general field, and the descriptor's members. */
void ttc_emit_poles(ttc_text *text, const ttc_field *field);
void ttc_emit_pole_member(ttc_text *text, const ttc_field *field);

/** Kernels of the general field for sections with coordinates, and their table, `sections`, of length *count. A section whose
 *  table of coordinates does not fit is left out. */
bool ttc_emit_sections(ttc_text *text, ttc_kernels *kernels, size_t *count);

/** What gives a parameter of another table: a jlt_source of kernel_abi.h; -1 when memory is out. name: the parameter's name;
 *  value: its value in this table's names, or with is_root the square of that. */
int ttc_emit_source(const ttc_model *model, const char *name, ttc_id value, bool is_root);

/** For a reduction onto the target, the name of the first parameter of the target that is given as another quantity than the one
 *  with this name here (see jlt_claim); NULL if there is none, if the claim is no such reduction, or if memory is out. */
const char *ttc_emit_renamed(const ttc_model *model, const ttc_claim *claim, const ttc_model *target);

/** For a reduction onto the target, the name of the first state with an interval, or of the first record `domain`, that bounds
 *  motions of the general field and does not bound those of the target: it is none of the target's conditions, written in what the
 *  reduction gives for the target's names. NULL if there is none, or if the claim is no such reduction. Also a name when memory is
 *  out. */
const char *ttc_emit_widened(const ttc_kernels *general, const ttc_claim *claim, const ttc_model *target);

/** Kernels of the general field for ways to tables that serve in place of its own, and their table, `ways`, of length *count. A
 *  way whose table does not fit is left out. */
bool ttc_emit_ways(ttc_text *text, ttc_kernels *kernels, size_t *count);

/* The conditions of `tier` with their kernel, for the general field; the kernel `lifted`, which completes states by lifted roots;
 * and the descriptor's members about these and the ways. */
bool ttc_emit_tier(ttc_text *text, ttc_field *field);
bool ttc_emit_lifted(ttc_text *text, const ttc_field *field);
void ttc_emit_way_members(ttc_text *text, const ttc_field *field, size_t ways);

/** The factors of the equations' divisors that may be zero: the array `divisors`, of length *count, and its kernel. Only for the
 *  general field without lifted roots; else *count is 0. */
bool ttc_emit_divisors(ttc_text *text, ttc_field *field, size_t *count);

/* The file of one descriptor. */
bool ttc_emit_descriptor(ttc_text *text, ttc_kernels *kernels);

/* The command line that writes these kernels. */
void ttc_emit_command(ttc_text *text, const ttc_kernels *kernels);

/* The file table.c: a model's table, its claims with their verdicts, the list of its descriptors; and the declarations of these.
 * report: of the catalogue's own table. */
void ttc_emit_model(ttc_text *text, const ttc_catalogue *catalogue, const ttc_proof_report *report);
void ttc_emit_model_names(ttc_text *text, const ttc_model *model);

/* The ball-arithmetic file of a model, with its fields without variant. */
bool ttc_emit_ball(ttc_text *text, const ttc_catalogue *catalogue);

#endif
