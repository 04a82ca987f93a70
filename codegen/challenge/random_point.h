/** Random points of a model's domain that meet a claim's conditions, each enclosed in balls of any precision.
 *
 *  A point is a list of rational numbers, one a free symbol; what `when` and a family bind is evaluated from them, and zero
 *  levels are met by solving for as many symbols, with a proof that the balls hold a solution (Krawczyk's test).
 *  Source: R. Krawczyk, Computing 4, 1969; A. Neumaier, Interval Methods for Systems of Equations, 5.1. */
#ifndef TTC_RANDOM_POINT_H
#define TTC_RANDOM_POINT_H

#include "challenge/probe.h"
#include "challenge/sample.h"

enum { TTC_RANDOM_POINT_LISTS = 3 };

/* What a point must meet. */
typedef struct {
    const ttc_model *model;
    const ttc_bindings *bound[TTC_RANDOM_POINT_LISTS];
    size_t bound_count;
    ttc_id levels[TTC_PROBE_SPARE]; /* expressions that are zero */
    size_t level_count;
    ttc_bindings family;            /* of those bound: what may leave the domain by its own fault; empty: nothing may */
    uint32_t claim;                 /* its divisors are not zero; UINT32_MAX: of no claim */
    uint32_t own_root;              /* a root whose radicand is in question; UINT32_MAX: none */
} ttc_situation;

typedef struct {
    fmpq *numbers;         /* by symbol: the value of a free parameter, or where a state lies in its interval */
    unsigned char *bound;  /* by symbol: not free */
    unsigned char *used;   /* by symbol: a definition that belongs to the domain, or is used by the field or the claim */
    size_t symbol_count;
    uint32_t pivots[TTC_PROBE_SPARE]; /* symbols that are solved for, one a level */
} ttc_random_point;

bool ttc_random_point_init(ttc_random_point *point, const ttc_situation *situation); /* false when memory is out */
void ttc_random_point_clear(ttc_random_point *point); /* legal on a zeroed one */

/* Draw numbers for every free symbol. False when there are fewer free symbols than levels. */
bool ttc_random_point_draw(ttc_random_point *point, const ttc_situation *situation, ttc_random *random, ttc_sample_range range);

typedef enum { TTC_INSIDE, TTC_OUTSIDE, TTC_UNCLEAR } ttc_place_in_domain;

/** Set every symbol of the probe at that precision, solve for the levels, and seed the states.
 *  INSIDE: the balls hold a point of the domain that meets every condition; OUTSIDE: they hold none; UNCLEAR: neither is
 *  known. `fault`: of at least `fault_size` bytes; what the family breaks, by its own fault, or empty. */
ttc_place_in_domain ttc_random_point_place(ttc_probe *probe, const ttc_random_point *point, const ttc_situation *situation,
                                           long precision, char *fault, size_t fault_size);

/** Set the free and bound symbols; pivots have the values given, shape (level_count,), and are the spare tangents. False when
 *  something has no value there. */
bool ttc_random_point_set(ttc_probe *probe, const ttc_random_point *point, const ttc_situation *situation, long precision,
                   arb_srcptr pivots);

/* Solve for the levels; the probe then holds the solution. */
bool ttc_level_meet(ttc_probe *probe, const ttc_random_point *point, const ttc_situation *situation, long precision);

/** Where the values of a probe lie, in the domain of its own model: signs, intervals, records `domain`, radicands, arguments of
 *  logarithms. Divisors are not considered.
 *  family: only what depends on a symbol that it binds can be at fault; NULL: everything can. except: a root that is left out, with
 *  all roots below it; UINT32_MAX: none. fault: what is certainly broken, by the family alone; otherwise empty. */
ttc_place_in_domain ttc_domain_locate(ttc_probe *probe, const ttc_model *model, const ttc_bindings *family, uint32_t except,
                                      char *fault, size_t fault_size);

#endif
