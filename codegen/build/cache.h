/** The cache of compiled tables: shared objects, each under a key that identifies everything it depends on.
 *
 *  It is the folder $XDG_CACHE_HOME/jellett, else $HOME/.cache/jellett. Objects loaded from it run with the user's rights: so the
 *  folder and the files must belong to the user, and nobody else may write to them. */
#ifndef TTC_CACHE_H
#define TTC_CACHE_H

#include "base/text.h"

typedef struct {
    char *folder;
    int lock; /* descriptor of the lock file; -1: no lock is held */
} ttc_cache;

/** Find or create the folder. Returns false on failure; message then says why, and what helps. */
bool ttc_cache_open(ttc_cache *cache, ttc_text *message);
void ttc_cache_close(ttc_cache *cache); /* releases the lock; legal on a zeroed cache */

/** The path FOLDER/KEY.so of an entry, for the caller to free; NULL when memory is out. */
char *ttc_cache_path(const ttc_cache *cache, const char *key);

/** Returns true if the entry exists, belongs to the user, is writable by nobody else, and matches the digest of content and key at
 *  its end: an object that a full disk or a crash cut short could crash the program, and one that was copied or renamed is of
 *  another table. Then also marks it as used. Cost: reads the whole file. */
bool ttc_cache_has(const char *path, const char *key);

/** Lock the key: wait until no other process makes its entry. Returns false if it cannot be locked; errno says why. */
bool ttc_cache_lock(ttc_cache *cache, const char *key);

/** Create an empty temporary folder in which to make an entry, and remove the leftovers of killed runs; the key must be locked. One
 *  of the next two functions removes it and frees its path. Returns NULL on failure; errno says why. */
char *ttc_cache_workshop(const ttc_cache *cache, const char *key);
void ttc_cache_clear_workshop(char *workshop); /* frees the path as well; legal on NULL */

/** Append the digest of content and key to the file `object` in the temporary folder and make it the entry of this key. Also on
 *  failure, the folder is removed and its path freed. Returns false on failure; errno says why. */
bool ttc_cache_publish(const ttc_cache *cache, const char *key, const char *object, char *workshop);

/** Remove entries that have not been used for `days` days. */
void ttc_cache_prune(const ttc_cache *cache, unsigned days);

#endif
