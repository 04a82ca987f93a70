/** Random points of a model's domain that meet a claim's conditions, each enclosed in balls of any precision.
 *
 *  A point is a list of rational numbers, one for each free symbol. What `when` and a family bind is evaluated from them; zero
 *  levels are met by solving for as many symbols, with a proof that the balls contain a solution (Krawczyk's test), or exactly,
 *  even where they are singular. Special points lie where a proof that holds at most points may fail: at zeros of quantities, and
 *  of sums that the table forms.
 *  Source: R. Krawczyk, Computing 4, 1969; A. Neumaier, Interval Methods for Systems of Equations, 5.1. */
#ifndef TTC_RANDOM_POINT_H
#define TTC_RANDOM_POINT_H

#include "challenge/probe.h"
#include "challenge/sample.h"

enum { TTC_RANDOM_POINT_LISTS = 3 };

/* The conditions that a point must meet. */
typedef struct {
    const ttc_model *model;
    const ttc_bindings *bound[TTC_RANDOM_POINT_LISTS];
    size_t bound_count;
    ttc_id levels[TTC_PROBE_SPARE]; /* expressions that are zero */
    size_t level_count;
    ttc_bindings family;            /* bindings of a family, which may leave the domain; empty: none */
    ttc_divisor_role role;          /* of a record whose divisors, and those of claims that it names, are not zero */
    uint32_t owner;
    uint32_t own_root;              /* the root or logarithm whose argument is in question; UINT32_MAX: none */
} ttc_situation;

/* Whether the divisors of a record are not zero in the situation. */
bool ttc_situation_has_record(const ttc_situation *situation, ttc_divisor_role role, uint32_t owner);

typedef struct {
    fmpq *numbers;         /* by symbol: the value of a free parameter, or where a state lies in its interval */
    unsigned char *bound;  /* by symbol: 1 if it is not free */
    unsigned char *used;   /* by symbol: 1 if the domain, the field or the claim uses its definition */
    size_t symbol_count;
    ttc_id *sums;          /* what special points may make zero: sums, and sines and cosines */
    size_t sum_count;
    ttc_id levels[TTC_PROBE_SPARE]; /* what is solved: the levels of the situation, a sum, or both */
    size_t level_count;
    bool solves_levels;    /* whether those of the situation are among them */
    uint32_t pivots[TTC_PROBE_SPARE]; /* symbols that are solved for, one for each level */
} ttc_random_point;

bool ttc_random_point_init(ttc_random_point *point, const ttc_situation *situation); /* false when memory is out */
void ttc_random_point_clear(ttc_random_point *point); /* legal on a zeroed one */

/* Draw numbers for all free symbols and, one time in two if they are special, a sum that is to vanish. Returns false if the levels
 * depend on too few symbols. */
bool ttc_random_point_draw(ttc_random_point *point, const ttc_situation *situation, ttc_random *random, ttc_sample_range range);

typedef enum { TTC_INSIDE, TTC_OUTSIDE, TTC_UNCLEAR } ttc_place_in_domain;

/** Set every symbol of the probe at this precision, solve for the levels, and seed the states.
 *  INSIDE: the balls contain a point of the domain that meets every condition; OUTSIDE: they contain none, or none was found;
 *  UNCLEAR: neither is known. fault, of `fault_size` bytes: what the family itself breaks, or "". */
ttc_place_in_domain ttc_random_point_place(ttc_probe *probe, const ttc_random_point *point, const ttc_situation *situation,
                                           long precision, char *fault, size_t fault_size);

/** Set the free and bound symbols. pivots: their values, shape (level_count,), seeded on the spare tangents; NULL: as drawn.
 *  Returns false if something has no value. */
bool ttc_random_point_set(ttc_probe *probe, const ttc_random_point *point, const ttc_situation *situation, long precision,
                   arb_srcptr pivots);

/* Solve for the levels; the probe then encloses the solution. Returns false if none was found, or if it is not shown to lie on all
 * levels of the situation. */
bool ttc_level_meet(ttc_probe *probe, const ttc_random_point *point, const ttc_situation *situation, long precision);

/** Where the values of a probe lie in the domain of its own model: signs, intervals, records `domain`, radicands, arguments of
 *  logarithms. Divisors are not considered.
 *  family: only conditions that depend on a symbol that it binds can be its fault; NULL: all can. except: a root that is left out,
 *  with all roots and logarithms below it; UINT32_MAX: none. fault: a condition that the family certainly breaks, if nothing else
 *  is broken or unclear; otherwise "". */
ttc_place_in_domain ttc_domain_locate(ttc_probe *probe, const ttc_model *model, const ttc_bindings *family, uint32_t except,
                                      char *fault, size_t fault_size);

/* Whether something is exactly zero that records of this role and owner divide by, or definitions that the first `use_count` of
 * their names need. */
bool ttc_domain_divides_by_zero(ttc_probe *probe, const ttc_model *model, ttc_divisor_role role, uint32_t owner,
                                size_t use_count);

/* The same as ttc_domain_locate, of the image of a point, which divisors of the domain keep outside if they are exactly zero. */
ttc_place_in_domain ttc_domain_locate_image(ttc_probe *probe, const ttc_model *model, char *fault, size_t fault_size);

#endif
