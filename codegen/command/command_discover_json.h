/** The output of `ttc discover --json` for a table, collected in an object as it is found:
 *
 *      {"file", "ok": true, "model", "sha256", "when", "degree", "quantities": [NAME...], "prime",
 *       "known": [NAME...]           proved claims of the table: products with them are not found again
 *       "claims": [{"kind", "name", "text"}...]     proved finds, as the text of records
 *       "settled": [{"seek", "form", "degree", "complete", "monomials", "rank"}...]   how far the search went, and if that is all
 *       "unproved": [{"text", "reason"}...], "unlifted"      finds that are not proved; their number, with finds at numbers alone
 *       "remarks": [TEXT...],        what comments say in addition
 *       "problems": [...]}           as in `ttc check`, and those of the command line
 *
 *  Members of an entry of `settled` that do not apply are absent. When memory is out, what cannot be kept is left out. */
#ifndef TTC_COMMAND_DISCOVER_JSON_H
#define TTC_COMMAND_DISCOVER_JSON_H

#include "discover/discover.h"

#include <jansson.h>

/* Make the object. sha256: of the table's file. when: the list of --when, or NULL. */
json_t *ttc_command_discover_json(const ttc_discovery *d, const char *path, const char *sha256, const char *when);

/* Add a problem of the command line, which has no place in the table. */
void ttc_command_discover_add_problem(json_t *problems, const char *path, const char *message);

/* text: one claim, with the records that it needs. */
void ttc_command_discover_add_claim(json_t *out, const char *text);
void ttc_command_discover_add_unproved(json_t *out, const char *text, const char *reason);
/* text: lines that begin with "# ". */
void ttc_command_discover_add_remark(json_t *out, const char *text);
void ttc_command_discover_add_settled(json_t *out, const ttc_discovery_settled *settled);

#endif
