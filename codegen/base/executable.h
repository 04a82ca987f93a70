/* Finding programs that this one calls. */
#ifndef TTC_EXECUTABLE_H
#define TTC_EXECUTABLE_H

/* Path of the program of this name, looked up in $PATH unless the name contains a slash, for the caller to free. NULL: not found,
 * or no memory. */
char *ttc_executable_find(const char *name);

#endif
