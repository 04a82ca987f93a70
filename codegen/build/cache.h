/** The cache of compiled tables: shared objects under keys that say all they depend on.
 *
 *  $XDG_CACHE_HOME/jellett, else $HOME/.cache/jellett. What is loaded from there runs as the user: so the folder and the files
 *  belong to the user, and nobody else may write to them. */
#ifndef TTC_CACHE_H
#define TTC_CACHE_H

#include "base/text.h"

typedef struct {
    char *folder;
    int lock; /* descriptor; -1: none is held */
} ttc_cache;

/** Find or make the folder. message: on failure why, and what helps. Returns false on failure. */
bool ttc_cache_open(ttc_cache *cache, ttc_text *message);
void ttc_cache_close(ttc_cache *cache); /* legal on a zeroed one; releases the lock */

/** Path of an entry, KEY.so, for the caller to free; NULL when memory is out. */
char *ttc_cache_path(const ttc_cache *cache, const char *key);

/** Whether there is such an entry, the user's own, writable by nobody else, and whole by its digest: what a full disk or a crash
 *  cut off would end whoever loads it. It is then marked as used. Cost: the file is read. */
bool ttc_cache_has(const char *path);

/** Wait until no other process makes an entry of this key. False: the lock cannot be had, errno says why. */
bool ttc_cache_lock(ttc_cache *cache, const char *key);

/** A folder for work on an entry, empty, removed by one of the next two functions; what killed runs left is removed. To be called
 *  with the lock. NULL: errno says why. */
char *ttc_cache_workshop(const ttc_cache *cache, const char *key);
void ttc_cache_clear_workshop(char *workshop); /* frees the name as well; legal on NULL */

/** Make an object from the workshop the entry of this key, with a digest of what it holds, and clear the workshop, also on
 *  failure. False: errno says why. */
bool ttc_cache_publish(const ttc_cache *cache, const char *key, const char *object, char *workshop);

/** Remove entries that nobody has used for so many days. */
void ttc_cache_prune(const ttc_cache *cache, unsigned days);

#endif
