/** The domain of a table as conditions on the points of a leaf: signs of parameters, intervals of states, radicands and arguments
 *  of logarithms positive, domain records, and divisors not zero. */
#ifndef TTC_DOMAIN_H
#define TTC_DOMAIN_H

#include "prove/prove_task.h"

/* Add the conditions of the domain to a list, except those on symbols under test (task->tested, task->tested_root) and on roots
 * that depend on them: the claim has to show these. */
void ttc_domain_add(ttc_task *task, ttc_conditions *conditions, ttc_domain_extent extent);

/* Add the signs of the cosine and the sine of an angle, as far as they follow from intervals of states. */
void ttc_domain_add_angle(ttc_task *task, ttc_conditions *conditions, uint32_t cosine);

/* The relation to zero that a parameter's sign condition states. sign is not ANY_SIGN. */
ttc_relation ttc_domain_relation(ttc_sign sign);

/* Require that the value of a symbol meets the conditions of its record. map: the valuation of `model`; NULL: the task's field. */
void ttc_domain_require_symbol(ttc_task *task, ttc_valuation *map, const ttc_model *model, uint32_t symbol, const char *where);

/* Require that the image under `map` lies in the domain of the map's model. where: added to messages. */
void ttc_domain_require_image(ttc_task *task, ttc_valuation *map, const char *where);

/* Require of the expression to which `map` binds a root that it is positive and its square is the radicand; and of all roots that
 * it binds. */
void ttc_domain_require_root(ttc_task *task, ttc_valuation *map, const ttc_symbol_entry *entry);
void ttc_domain_require_roots(ttc_task *task, ttc_valuation *map);

/* Require that, in `map`, no divisor of this role and owner is zero, nor any of the definitions whose symbols `used` flags. */
void ttc_domain_require_divisors(ttc_task *task, ttc_valuation *map, ttc_divisor_role role, uint32_t owner,
                                 const unsigned char *used, const char *where);

/* Return true if a divisor of the table depends on symbols under test; if a domain record does. */
bool ttc_domain_divides_by_tested(const ttc_task *task);
bool ttc_domain_speaks_of_tested(const ttc_task *task);

/* Require that the values of a variant's parameters meet the conditions of their records, and domain records that depend on no
 * state. The second function requires that these values make no divisor of the field zero on a whole part of the domain. */
void ttc_domain_require_tested(ttc_task *task);
void ttc_domain_require_field(ttc_task *task);

/* Returns true if an expression depends on symbols under test and on no state. */
bool ttc_domain_is_of_tested(const ttc_task *task, ttc_id id);

/* Flags, by symbol, of those that the claim and the domain use as the table is written, for free(); NULL when memory is out. */
unsigned char *ttc_domain_support(const ttc_task *task, ttc_domain_extent extent);

/* Flags, by divisor of the table, of those that only the claim brings in, for free(); NULL when memory is out. */
unsigned char *ttc_domain_divisors_of_claim(const ttc_task *task);

#endif
