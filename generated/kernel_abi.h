/** What a generated kernel is, and the one descriptor through which the world sees it. Edited in codegen/runtime/; ttc writes
 *  copies.
 *
 *  Layout: x holds the states in table order (with a lifted root after them, without an eliminated state); p holds
 *  the prepared values, filled once by `prepare` from the parameters in table order (levels of eliminated integrals after
 *  them); those parameters themselves come first in it. Matrices are row-major. Units are the table's.
 *  Kernels are pure and reentrant: no allocation, no globals, no errors; out of the model's domain they give what IEEE
 *  arithmetic gives (infinities, NaN), which callers test for. x, p and out must not overlap. */
#ifndef JLT_KERNEL_ABI_H
#define JLT_KERNEL_ABI_H

#include <stddef.h>

#ifndef __cplusplus
#include <complex.h>
/* C++ includes this header as well. It has no restrict, but its compilers have a word of their own for it. */
#define JLT_RESTRICT restrict
/* C++ has not C's complex numbers: they are a real part and an imaginary part after it, just as std::complex<double> is. */
typedef double complex jlt_complex;
#else
#if defined(__GNUC__) || defined(_MSC_VER)
#define JLT_RESTRICT __restrict
#else
#define JLT_RESTRICT
#endif
typedef double jlt_complex[2];
#endif

/* A kernel at the state x with prepared values p: the field, a matrix, or other values, as the descriptor says. */
typedef void (*jlt_kernel_function)(const double *JLT_RESTRICT x, const double *JLT_RESTRICT p, double *JLT_RESTRICT out);
/* Fills the prepared values from parameters in table order. */
typedef void (*jlt_kernel_prepare)(const double *JLT_RESTRICT params, double *JLT_RESTRICT prepared);

/* The field written from the terms as they stand, unsimplified, in complex arithmetic, on unprepared parameters: for
 * differentiation by complex step, independent of the symbolic derivative. */
typedef void (*jlt_kernel_complex)(const jlt_complex *JLT_RESTRICT x, const double *JLT_RESTRICT params,
                                   jlt_complex *JLT_RESTRICT out);

enum { JLT_JET_ORDER_MAX = 40 };

/* Taylor coefficients of the solution through x: coefficients[k*columns + i] = (d/dtau)^k x_i / k!, k = 0 .. order, with
 * columns = states in the model's own time, and states + 1 in a time of its own, where the last column is t (0 in row 0).
 * 1 <= order <= JLT_JET_ORDER_MAX. Cost: O(order^2). */
typedef void (*jlt_kernel_jet)(const double *JLT_RESTRICT x, const double *JLT_RESTRICT p, unsigned order,
                               double *JLT_RESTRICT coefficients);

typedef enum { JLT_ANY_SIGN, JLT_POSITIVE, JLT_NONNEGATIVE, JLT_NONZERO } jlt_sign;

typedef struct {
    const char *name;
    const char *unit;    /* "" when dimensionless or not said */
    const char *meaning; /* "" when not said */
    double low, high;    /* states: open interval of the domain, -INFINITY and INFINITY where unbounded, or where the
                            bound is no number, see domain_count; parameters: -INFINITY and INFINITY */
    jlt_sign sign;       /* parameters: their sign condition; states: JLT_ANY_SIGN */
    double value;        /* parameters: the default, NaN when the table gives none */
    double period;       /* states: what the table claims to be a period, see the claim `periodic`; 0 when nothing */
} jlt_quantity;

typedef struct {
    unsigned add, multiply, fma, divide, root, elementary; /* fma counts one operation of two flops */
    unsigned depth; /* longest chain, in operations */
    unsigned live;  /* most temporaries alive at once */
} jlt_operation_count;

typedef struct {
    jlt_kernel_function call; /* NULL when the model gives nothing to compute */
    unsigned outputs;
    jlt_operation_count optimized, naive;
    const char *loses_digits; /* where, and why; "" when nowhere */
} jlt_kernel;

/* Batches are structures of arrays: entry i of lane j at x[i*stride + j] and out[i*stride + j], lane j < lanes; rows are
 * aligned to 8*lanes bytes. Lanes have prepared values of their own: value i of lane j at p[i*lanes + j], so that orbits under
 * different parameters go side by side; p has shape (prepared, lanes), and is aligned as rows are. */
typedef void (*jlt_kernel_lanes)(const double *JLT_RESTRICT x, const double *JLT_RESTRICT p, double *JLT_RESTRICT out,
                                 size_t stride);

/* The argument of a stage, less the state and in units of the step: the sum of weight[l] * (slope number slope[l]). */
typedef struct {
    unsigned count; /* >= 1 */
    unsigned char slope[16];
    double weight[16];
} jlt_stage_sum;

enum { JLT_BATCH_VECTORS = 2 };

/* All stages of an explicit one-step method, on JLT_BATCH_VECTORS vectors side by side: a row is JLT_BATCH_VECTORS * lanes
 * long. For i = 1 .. count: z = x + h * sum i - 1, slope i = f(z). x and z have shape (states, row), k has (count + 1,
 * states, row) and holds slope 0, h has (row,), p (JLT_BATCH_VECTORS, prepared, lanes): a vector's behind the other's. z is left
 * at the last one. stages_clock carries t as one more column after the states, in x, k and z alike: its slope is dt/dtau, 1 in the
 * model's own time; z has it for the last stage alone. */
typedef void (*jlt_kernel_stages)(const double *JLT_RESTRICT x, double *JLT_RESTRICT k, const jlt_stage_sum *JLT_RESTRICT sums,
                                  unsigned count, const double *JLT_RESTRICT h, const double *JLT_RESTRICT p,
                                  double *JLT_RESTRICT z);

/* The same with the variational equations of so many tangent vectors. Columns are the states, the vectors one after another,
 * the integral of the divergence, and t; x, z and k hold states*(1 + tangents) + 2 of them. The last two are integrals along
 * the way, which z has for the last stage alone. */
typedef void (*jlt_kernel_stages_varied)(const double *JLT_RESTRICT x, double *JLT_RESTRICT k,
                                         const jlt_stage_sum *JLT_RESTRICT sums, unsigned count, const double *JLT_RESTRICT h,
                                         const double *JLT_RESTRICT p, double *JLT_RESTRICT z, unsigned tangents);

/* jlt_kernel_jet on lanes: coefficient k of column i of lane j at coefficients[(k*columns + i)*stride + j]. */
typedef void (*jlt_kernel_lanes_jet)(const double *JLT_RESTRICT x, const double *JLT_RESTRICT p, unsigned order,
                                     double *JLT_RESTRICT coefficients, size_t stride);

/* The batched kernels for one instruction set: every lane does what the scalar kernel does, in the same order; functions of the C
 * library may have other last bits there. */
typedef struct {
    const char *isa; /* "baseline", "avx2" (with FMA) or "avx512": what the processor must have */
    unsigned lanes;
    unsigned prepared; /* values of p, for each lane; 0: there are none, or p is what whoever made these kernels passes through */
    jlt_kernel_lanes rhs, jacobian, rhs_jacobian, divergence, integral_values, integral_gradients, measure_values,
        measure_divergences, time_factor, eliminated, observe_values, valid_values, domain_values,
        domain_gradients; /* NULL where the scalar kernel is */
    jlt_kernel_stages stages, stages_clock;
    jlt_kernel_stages_varied stages_varied;
    jlt_kernel_lanes_jet jet;
} jlt_kernel_batch;

enum { JLT_ISA_COUNT = 3 };

/* The batched kernels called `name`, of every instruction set; with JLT_LANES_ALONE defined, as 2, 4 or 8, of that with so many
 * lanes: the other files batch_*.c are then not needed. */
#ifndef JLT_LANES_ALONE
#define JLT_BATCHES(name) &name##_baseline, &name##_avx2, &name##_avx512
#elif JLT_LANES_ALONE == 2
#define JLT_BATCHES(name) [0] = &name##_baseline
#elif JLT_LANES_ALONE == 4
#define JLT_BATCHES(name) [1] = &name##_avx2
#else
#define JLT_BATCHES(name) [2] = &name##_avx512
#endif

typedef struct {
    const char *name;
    const char *condition; /* the `when` clause, "" when it holds always */
} jlt_named;

typedef struct {
    const char *name, *unit, *meaning; /* unit and meaning "" when not said */
} jlt_validity;

/* A condition of the table's domain, from its record `domain`: outside of it the field means nothing. */
typedef struct {
    const char *name;
    const char *text; /* as the table writes it, "1 - x*y > 0"; of a divisor "r - w != 0" */
    int of_params;    /* 1: no state is in it */
} jlt_region;

/** A family of equilibria: some states given in terms of the others, under conditions on parameters. All its kernels
 *  take unprepared parameters that already satisfy the condition (see `impose`). */
typedef struct {
    const char *name, *condition;
    const unsigned char *is_free;  /* shape (states,): 1 where the state may be chosen */
    jlt_kernel_function impose;    /* x, params -> params (params,): the condition's substitutions made */
    jlt_kernel_function point;     /* x (free entries read), params -> x (states,) */
    jlt_kernel_function trace;     /* -> (1,), the table's formula; NULL when it gives none */
    jlt_kernel_function charpoly;  /* -> (states + 1,), the table's formula, highest power first, not normalized; or NULL */
    jlt_kernel_function matrix;    /* -> (states, states), the table's formula; or NULL */
    unsigned left_null_count;
    const jlt_named *left_null;    /* the integrals claimed to give left null vectors (those of `leftnull`) */
    jlt_kernel_function left_null_gradients; /* x, params -> (left_null_count, states): their gradients; NULL when none */
    int obstructs;                 /* the table claims that the trace excludes an invariant measure */
} jlt_equilibria;

typedef enum { JLT_PROVED, JLT_REFUTED, JLT_UNSETTLED } jlt_proof;

/* A claim of the table, or one that follows from it (root, variant, time, eliminate), and what the prover says of it. */
typedef struct {
    const char *kind, *name; /* kind as written in the table: "integral", "reduction", ... */
    const char *condition;   /* the `when` clause, of what leads to another table with the zero levels of `modulo`; "" when it holds
                                always */
    jlt_proof verdict;
    const char *reason;      /* refuted: what is not zero; not settled: why; "" when proved */
    const char *target;      /* of what leads to another table: its SHA-256; NULL of other kinds, */
    const char *file;        /* and the name of its file beside the model's */
    const char *renames;     /* of a reduction onto another table: a parameter of that table whose value here has another name, or
                                none (see jlt_source); NULL: there is none, or the claim is of another kind */
    const char *widens;      /* of the same: a state with an interval, or a record `domain`, that bounds motions here and is no
                                condition there; NULL as above */
} jlt_claim;

typedef struct {
    const signed char *signs; /* shape (states,): what it makes of each, +1 or -1 */
    unsigned claim;           /* which of the model's `claims` it is */
} jlt_reversor;

/* An end of a state's interval at which orbits end, from the record `pole`. */
typedef struct {
    unsigned state;
    const char *meaning; /* "" when not said */
} jlt_pole;

/* A point of a section to begin with, from the record `start` of its coordinates' table. */
typedef struct {
    const char *name;
    const double *point; /* (coordinates,) */
} jlt_section_point;

/** A section x[column] = level on levels of integrals, in coordinates of its own: from the record `section` of the table, and from
 *  the table of its coordinates, whose record `lift` says which state a point is. Kernels take unprepared parameters with the
 *  levels after them, values = (params, levels); q has shape (coordinates,), x all states of the field. */
typedef struct {
    const char *name;   /* of the record */
    const char *chart;  /* model name of the coordinates' table, */
    const char *file;   /* its file beside the model's table, */
    const char *sha256; /* its digest, */
    const char *table;  /* and its text */
    unsigned claim;     /* which of the model's `claims` says that lift and back are inverse to each other, and on the levels */
    unsigned column;
    double level;
    unsigned coordinate_count;
    const jlt_quantity *coordinates; /* with interval and period */
    const unsigned char *is_angle;   /* (coordinates,): 1 where it is an atan2 of the state, in radians */
    unsigned level_count;
    const jlt_quantity *levels;      /* parameters of the coordinates' table that are values of integrals; the default too */
    const unsigned *integrals;       /* (levels,): which of the general field's integrals, as in `integrals` */
    jlt_kernel_function lift;        /* q, values -> x (states,) */
    jlt_kernel_function lift_slopes; /* q, values -> dx/dq and dx/dlevels, (states, coordinates + levels) */
    unsigned region_count;
    jlt_kernel_function region;      /* q, values -> (regions,): there is a state where all are > 0; NULL: everywhere */
    jlt_kernel_function back;        /* x, values -> (coordinates, 2): sine and cosine of an angle times one positive number; else
                                        the coordinate, and 1 */
    jlt_kernel_function back_slopes; /* x, values -> (coordinates, 2, states) */
    unsigned beside_count, ending_count; /* quantities to show at returns, and at the end of an orbit */
    const jlt_quantity *beside, *ending;
    jlt_kernel_function beside_values, ending_values; /* x, values -> (beside,), (ending,) */
    unsigned start_count;
    const jlt_section_point *starts;
    jlt_kernel_function turn; /* q, values -> (1,): an orbit that begins where it is < 0 and ends where it is > 0 has turned; or
                                 NULL */
    const char *turn_meaning; /* what starts are called where it is < 0 */
} jlt_section_chart;

/* A condition, as the table writes it. */
typedef struct {
    const char *text; /* "v_slip > 0", "a3 = 0" */
    int is_zero;      /* 1: its value must be 0; 0: > 0 */
} jlt_way_condition;

/* What gives a parameter of another table: the parameter of its name here; other parameters; states, that is the level of the
 * integral of its name here, or of one whose name nothing has; states, though something else has its name. */
typedef enum { JLT_SOURCE_OWN, JLT_SOURCE_PARAMS, JLT_SOURCE_LEVEL, JLT_SOURCE_OTHER_LEVEL } jlt_source;

/** A way to another table that may serve in place of this one, and back: from a record `reduction NAME : by FILE` (the other
 *  table has fewer states), or `lift NAME : into FILE` (it has more). Kernels take unprepared parameters. The other table's
 *  field is meant in the time of the same name as this field's where it has one, else in its own; y are all its states
 *  there, with lifted roots. */
typedef struct {
    const char *name, *kind;           /* of the record; "reduction" or "lift" */
    const char *model, *file, *sha256; /* of the other table: its model's name, its file beside this one's, its digest */
    const char *time;                  /* of the other table's field, "" its own */
    unsigned claim;                    /* which of the model's `claims` it is */
    unsigned state_count, param_count; /* of the other table's field: y has state_count entries, */
    unsigned coordinate_count;         /* the first of which are not lifted roots */
    const unsigned char *is_angle;     /* (coordinates,): 1 where it is an atan2 of the two values */
    const unsigned char *is_root;      /* (params,): 1 where the value is the parameter's square */
    const unsigned char *sources;      /* (params,): a jlt_source each */
    jlt_kernel_function coordinates;   /* x, params -> (coordinates, 2): sine and cosine of an angle times one positive
                                          number; else the state, and 1 */
    jlt_kernel_function params;        /* x, params -> the other table's parameters, (params,) */
    unsigned condition_count;
    const jlt_way_condition *conditions;  /* of `when` and `where` */
    jlt_kernel_function condition_values; /* x, params -> (conditions,); NULL when there is none */
    jlt_kernel_function back;             /* y, the other table's parameters -> x (states of this field) */
} jlt_way;

typedef struct jlt_descriptor {
    const char *model, *variant, *time, *elimination; /* "" for the general field, its own time, all states */
    const char *title, *source;
    const char *sha256;    /* of the table */
    const char *generator; /* "ttc VERSION" and flags that change kernels */
    const char *table;     /* the table's text */
    const char *unproved;  /* claims that these kernels rest on and that are not proved, "KIND NAME, ..."; NULL: none */
    const struct jlt_descriptor *const *family; /* all descriptors of the model, the general one first; ends with NULL */
    const jlt_claim *claims; /* of the model: those of its table in their order, then what follows; ends with kind NULL */

    int scales; /* 1: by the units of its quantities these are the same equations in any multiples of kg, m and s */
    unsigned state_count, param_count, prepared_count;
    const jlt_quantity *states, *params; /* params: the same, in the same order, in every variant of a model */
    jlt_kernel_function impose; /* x (may be NULL), params -> params (params,): the variant's substitutions made, so that
                                   a variant serves parameters that this leaves unchanged; NULL for the general field */
    jlt_kernel_prepare prepare;

    jlt_kernel rhs;                /* f, shape (states,) */
    jlt_kernel jacobian;           /* df/dx, shape (states, states) */
    jlt_kernel rhs_jacobian;       /* f, then df/dx */
    jlt_kernel divergence;         /* trace of df/dx, shape (1,) */
    unsigned integral_count;
    const jlt_named *integrals;    /* those whose condition this variant satisfies */
    jlt_kernel integral_values;    /* shape (integrals,) */
    jlt_kernel integral_gradients; /* shape (integrals, states) */
    unsigned measure_count;
    const jlt_named *measures;
    jlt_kernel measure_values;      /* densities rho, shape (measures,) */
    jlt_kernel measure_divergences; /* div(rho f), shape (measures,) */
    jlt_kernel time_factor;         /* dt/dtau, shape (1,); call NULL in the model's own time */
    jlt_kernel eliminated;          /* the eliminated state, shape (1,); call NULL when none is */
    unsigned observe_count;         /* these four on the general field with all its states, in any of its times */
    const jlt_quantity *observes;   /* what the table says to look at along orbits; bounds -INFINITY and INFINITY */
    jlt_kernel observe_values;      /* shape (observes,) */
    unsigned valid_count;
    const jlt_validity *valids;     /* conditions under which the model holds */
    jlt_kernel valid_values;        /* shape (valids,); the model holds where all are > 0 */
    unsigned domain_count;          /* conditions of the domain, without those that follow from intervals of states, signs of */
    const jlt_region *domains;      /* parameters and lifted roots; with ends of intervals that are no numbers; on all fields */
    jlt_kernel domain_values;       /* shape (domains,); the field means nothing where one is not > 0 */
    jlt_kernel domain_gradients;    /* shape (domains, states) */
    unsigned divisor_count;         /* what the equations divide by as written, factor by factor, where it may be 0, and integrals
                                       and densities by parameters: on the general field, in times without lifted roots */
    const jlt_region *divisors;     /* the field means nothing where one is 0, also where kernels cancel it */
    jlt_kernel_function divisor_values; /* x, params -> (divisors, 2): the value, and the sum of squares of what it adds up */
    unsigned reversor_count;        /* reversors that the table claims without a condition and that change signs of states, no
                                       more; */
    const jlt_reversor *reversors;  /* on fields with a time or an elimination there are none */
    unsigned pole_count;            /* these four on the general field with all its states, in any of its times */
    const jlt_pole *poles;
    unsigned section_count;
    const jlt_section_chart *sections;
    const char *tier, *tier_meaning; /* these six as the four above; record `tier`, NULL without one */
    unsigned tier_condition_count;
    const jlt_way_condition *tier_conditions;
    jlt_kernel_function tier_values; /* x, params -> (tier_conditions,): its coordinates are good while all are > 0; or NULL */
    unsigned way_count;
    const jlt_way *ways;
    jlt_kernel_function lifted; /* states in the model's own time, params -> (states,): the same with its lifted roots;
                                   NULL where the field's time lifts none; on all fields */
    unsigned lifted_count;      /* of those roots */
    jlt_kernel_function root_relations, root_relation_gradients; /* x, params -> (lifted,), (lifted, states): root^2 - radicand, 0
                                   on orbits, and its gradient */
    unsigned eliminated_state, level_integral; /* with an elimination: which of the general field's states goes, and by which of its
                                   integrals, whose level is the last parameter */
    jlt_kernel_jet jet;
    jlt_kernel_complex rhs_complex;
    const jlt_kernel_batch *batches[JLT_ISA_COUNT]; /* widest last; call only what the processor has. NULL where the file
                                                       was compiled with JLT_WITHOUT_LANES, or JLT_LANES_ALONE
                                                       names another */

    const struct jlt_ball_table *balls; /* kernel_ball.h: of this time and elimination, for all variants; NULL where the file was
                                           compiled with JLT_WITHOUT_BALLS */

    unsigned equilibria_count;     /* on the general field in its own time only */
    const jlt_equilibria *equilibria;
} jlt_descriptor;

#endif
