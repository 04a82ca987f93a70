/** What `ttc discover --json` says of a table, kept in an object as it is found:
 *
 *      {"file", "ok": true, "model", "sha256", "when", "degree", "quantities": [NAME...], "prime",
 *       "known": [NAME...]           claims of the table that are proved: products with them are not found again
 *       "claims": [{"kind", "name", "text"}...]     finds, proved; the text is that of records
 *       "settled": [{"seek", "form", "degree", "complete", "monomials", "rank"}...]   how far was looked, and whether that was all
 *       "unproved": [{"text", "reason"}...], "unlifted"      finds that are not proved; finds at numbers alone, how many
 *       "remarks": [TEXT...],        what is said in comments beside
 *       "problems": [...]}           as of `ttc check`, and of the command line
 *
 *  Members of an entry of `settled` that do not apply are not there. Without memory what could not be kept is left out. */
#ifndef TTC_COMMAND_DISCOVER_JSON_H
#define TTC_COMMAND_DISCOVER_JSON_H

#include "discover/discover.h"

#include <jansson.h>

/* A new reference; sha256: of the table as it is on file. when: the list of --when, or NULL. */
json_t *ttc_command_discover_json(const ttc_discovery *d, const char *path, const char *sha256, const char *when);

/* A problem of the command line, which has no place in the table, among those of ttc_command_add_problems. */
void ttc_command_discover_add_problem(json_t *problems, const char *path, const char *message);

/* text: one claim, with the records that it needs. */
void ttc_command_discover_add_claim(json_t *out, const char *text);
void ttc_command_discover_add_unproved(json_t *out, const char *text, const char *reason);
/* text: lines that begin with "# ". */
void ttc_command_discover_add_remark(json_t *out, const char *text);
void ttc_command_discover_add_settled(json_t *out, const ttc_discovery_settled *settled);

#endif
