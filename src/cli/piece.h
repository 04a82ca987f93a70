/** Runs command lines one after the other, each in a process of its own, and takes what they write. */
#ifndef JLT_CLI_PIECE_H
#define JLT_CLI_PIECE_H

#include "cli/command.h"

typedef struct {
    int output, error; /* files in memory that the commands write to */
    char *rows, *words; /* what the last one wrote, each ended by a NUL; owned */
    size_t rows_size, words_size;
} jlt_piece;

/** For jlt_piece_close, whatever is returned. Says what is wrong. */
jlt_exit jlt_piece_open(jlt_piece *self);
void jlt_piece_close(jlt_piece *self);

/** Out: *ending, the signal that is to end this program, else 0; *by, the signal that ended the command, else 0. Returns its status; where
 *  it cannot be run, says why. */
jlt_exit jlt_piece_run(jlt_piece *self, int *ending, int *by, const jlt_command *command, char **argv, int argc);

#endif
