/* LOFT as a library: decks of conic lofting loaded, cut and measured.
 *
 * Handles are opaque. Every loft_..._free takes the address of a handle, frees what it points to and
 * sets it to NULL; NULL, or the address of a NULL handle, is passed over, so that freeing twice through
 * the same variable does no harm. What a function returns is the caller's to free; what is handed in is
 * only read, and only during the call. A cut, a table and an error stand without their deck.
 *
 * Threads: a deck, a cut and a table do not change once they are there. Any number of threads may load,
 * cut and measure at once, also one deck that they share; none waits for another. Only freeing is for
 * one of them, when no other uses the handle any more. Nothing is kept between calls.
 *
 * What can fail takes the address of a loft_error handle last, or NULL where nobody asks. It is set to
 * NULL at once, and to an error where the call fails, which the caller frees. Nothing is printed, and no
 * call ends the program (but where memory runs out, as Fortran has it).
 *
 * Text is copied into the caller's room: at most SIZE bytes with the null at its end, whole characters of
 * UTF-8 only. The length of the whole text, without the null, is returned; ask with room NULL and size 0.
 *
 * Numbers of bodies, cuts, cards, faults and points count from 1. Lengths are in the deck's unit, angles
 * in degrees. A NULL handle has nothing: counts are 0, texts empty, and what can fail does.
 */
#ifndef LOFT_H
#define LOFT_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The interface of this header; the library has its own, which must be the same. */
#define LOFT_ABI_VERSION 1

int loft_abi_version(void);
size_t loft_version(char *room, size_t size);           /* of LOFT, as `loft --version` has it */

typedef struct loft_deck loft_deck;                     /* a deck, read and built */
typedef struct loft_cut loft_cut;                       /* what a plane cuts from a body */
typedef struct loft_table loft_table;                   /* a table of a conic card */
typedef struct loft_error loft_error;                   /* why a call failed */

/* --- errors ------------------------------------------------------------------------------------- */

enum loft_cause {
    LOFT_NO_ERROR = 0,
    LOFT_FILE_TROUBLE = 1,      /* the deck can't be opened or read */
    LOFT_BAD_ARGUMENT = 2,      /* NULL, a number that is not finite or beyond 1e80, or nothing of that number */
    LOFT_POINTS_COINCIDE = 10,  /* the normal of a plane is zero */
    LOFT_NO_CONVERGENCE = 21,   /* an iteration did not reach its tolerance */
    LOFT_TOO_MANY = 41,         /* more points than LOFT makes */
    LOFT_BEYOND_LINES = 42      /* a cut where the body's lines are not */
};                              /* others may be added; the message says what is wrong */

int loft_error_cause(const loft_error *error);
size_t loft_error_message(const loft_error *error, char *room, size_t size);
void loft_error_free(loft_error **error);

/* --- decks -------------------------------------------------------------------------------------- */

/* Loads a deck from a file, or from text in memory (lines with line feeds). Faults of its cards are no
 * error: they are in the list below, and what is sound is there. Fails with LOFT_FILE_TROUBLE and
 * LOFT_BAD_ARGUMENT; the result is then NULL. */
loft_deck *loft_deck_load(const char *path, loft_error **error);
loft_deck *loft_deck_parse(const char *text, size_t length, loft_error **error);
void loft_deck_free(loft_deck **deck);

enum loft_kind_of_deck { LOFT_NO_DECK = 0, LOFT_DECK_1970 = 1, LOFT_DECK_BODY = 2 };
int loft_deck_kind(const loft_deck *deck);
size_t loft_deck_title(const loft_deck *deck, char *room, size_t size);
size_t loft_deck_units(const loft_deck *deck, char *room, size_t size);    /* INCHES, MM or FEET */

enum loft_severity { LOFT_REMARK = 0, LOFT_WARNING = 1, LOFT_ERROR = 2 };
typedef struct loft_fault {
    int64_t line;       /* line of the deck, from 1; 0: the whole deck */
    int32_t severity;   /* enum loft_severity */
    int32_t first;      /* first column at fault, from 1; 0: the whole card */
    int32_t last;       /* last column at fault */
    int32_t spare;
} loft_fault;
int loft_deck_fault_count(const loft_deck *deck);       /* as `loft check` finds them */
int loft_deck_error_count(const loft_deck *deck);       /* those of severity LOFT_ERROR */
int loft_deck_fault(const loft_deck *deck, int number, loft_fault *fault);      /* 1, or 0: no such fault */
size_t loft_deck_fault_message(const loft_deck *deck, int number, char *room, size_t size);
size_t loft_deck_fault_card(const loft_deck *deck, int number, char *room, size_t size);

int loft_deck_body_count(const loft_deck *deck);
size_t loft_deck_body_name(const loft_deck *deck, int body, char *room, size_t size);
int loft_deck_section_count(const loft_deck *deck, int body);   /* its sections, then patches, then ducts */
size_t loft_deck_section_name(const loft_deck *deck, int body, int section, char *room, size_t size);
int loft_deck_duct_count(const loft_deck *deck, int body);      /* the ducts alone, as they are measured */
size_t loft_deck_duct_name(const loft_deck *deck, int body, int duct, char *room, size_t size);
int loft_deck_cut_count(const loft_deck *deck);         /* numbered as `loft run --format csv` does */
size_t loft_deck_cut_name(const loft_deck *deck, int number, char *room, size_t size);

/* --- cuts --------------------------------------------------------------------------------------- */

enum loft_kind_of_cut {
    LOFT_STATION = 1, LOFT_BUTTOCK = 2, LOFT_WATERLINE = 3, LOFT_OBLIQUE = 4, LOFT_PLANE = 5
};
enum loft_rule {
    LOFT_DEFAULT = 0,           /* 25 points on each arc, equally spaced along it */
    LOFT_NUMBER = 2,            /* `number` points on each arc */
    LOFT_LENGTH = 3,            /* equal lengths, as near to `step` as goes evenly */
    LOFT_CHORD = 4              /* chords within `step` of the curve */
};
/* How the points of a cut are spread, and the side of the flange. All zero, or NULL: the defaults. */
typedef struct loft_spread {
    double step;                /* deck units */
    int32_t rule;               /* enum loft_rule */
    int32_t number;             /* of points */
    int32_t flange_forward;     /* 1: the bevel is that of a flange on the forward side */
    int32_t spare;
} loft_spread;

/* A cut that the deck asks for, or any other. Of a symmetric body the starboard half is cut, unless the
 * plane cuts the halves differently: then the whole is. A plane that misses the body gives a cut
 * without points. The causes of failure are those above; the result is then NULL. */
loft_cut *loft_deck_cut(const loft_deck *deck, int number, loft_error **error);
loft_cut *loft_cut_station(const loft_deck *deck, int body, double sta, const loft_spread *spread,
    loft_error **error);
loft_cut *loft_cut_buttock(const loft_deck *deck, int body, double bl, const loft_spread *spread,
    loft_error **error);
loft_cut *loft_cut_waterline(const loft_deck *deck, int body, double wl, const loft_spread *spread,
    loft_error **error);
loft_cut *loft_cut_plane(const loft_deck *deck, int body, const double point[3], const double normal[3],
    const loft_spread *spread, loft_error **error);
void loft_cut_free(loft_cut **cut);

enum loft_has {
    LOFT_HAS_SLOPE = 1, LOFT_HAS_CURVATURE = 2, LOFT_HAS_NORMAL = 4     /* normal and bevel */
};
typedef struct loft_point {
    double sta, bl, wl;         /* deck units */
    double u, v;                /* true-shape coordinates in the plane, deck units */
    double slope;               /* dWL/dBL of a station, dWL/dSTA of a buttock, dBL/dSTA of a waterline,
                                 * dv/du of any other plane; infinite where vertical */
    double curvature;           /* in the plane, 1/deck unit, positive where the outline turns left */
    double normal[3];           /* outward unit normal of the skin: STA, BL, WL */
    double bevel;               /* degrees, positive where the flange is open */
    int32_t outline;            /* of the cut, from 1 */
    int32_t section;            /* of the cut, from 1: see loft_cut_section_name */
    int32_t has;                /* enum loft_has: which values exist; the others are 0 */
    int32_t spare;
} loft_point;

int loft_cut_kind(const loft_cut *cut);
size_t loft_cut_name(const loft_cut *cut, char *room, size_t size);
int loft_cut_point_count(const loft_cut *cut);
int loft_cut_points(const loft_cut *cut, int first, int count, loft_point *points);  /* how many there were */
int loft_cut_outline_count(const loft_cut *cut);
int loft_cut_outline_is_closed(const loft_cut *cut, int outline);
size_t loft_cut_section_name(const loft_cut *cut, int section, char *room, size_t size);
int loft_cut_note_count(const loft_cut *cut);           /* what the user will want to know of it */
size_t loft_cut_note(const loft_cut *cut, int number, char *room, size_t size);

/* --- measures ----------------------------------------------------------------------------------- */

/* All of these return 1, or 0 where the call fails: with LOFT_BAD_ARGUMENT where there is no such body or
 * duct or the station is not finite, and with LOFT_BEYOND_LINES at a station that a duct has not. What
 * they measure into is then as it was. */

/* Of the whole body, both halves of a symmetric one. What does not exist is 0. */
typedef struct loft_measure {
    double from, to;            /* stations, deck units */
    double volume;              /* deck units cubed */
    double volume_error;        /* estimate of the quadrature */
    double centroid[3];         /* of the volume: STA, BL, WL */
    double wetted_area;         /* of the skin without flat ends, deck units squared */
    double wetted_error;        /* estimate of the quadrature */
    int32_t has_volume;         /* 1: the sections close all along */
    int32_t has_wetted;         /* 1: every section has an arc all along */
    char why[256];              /* where there is no volume: why not */
} loft_measure;
typedef struct loft_section {
    double sta;                 /* deck units */
    double girth;               /* length of the skin */
    double area;                /* deck units squared */
    double centroid[2];         /* BL, WL */
    double inertia[3];          /* about the centroid: of WL squared, BL squared, BL WL */
    int32_t has_girth;          /* 1: every section has an arc there */
    int32_t has_area;           /* 1: the section closes */
    char why[256];              /* where there is no area: why not */
} loft_section;
int loft_deck_measure(const loft_deck *deck, int body, loft_measure *measure, loft_error **error);
int loft_deck_measure_station(const loft_deck *deck, int body, double sta, loft_section *measure,
    loft_error **error);

/* Of a duct, all of it, without its mirror image where it has one. The area curve is the area at stations
 * from its first outline to its last. */
typedef struct loft_duct {
    double from, to;            /* stations of the first and the last outline, deck units */
    double volume;              /* within it, deck units cubed */
} loft_duct;
typedef struct loft_duct_section {
    double sta;                 /* deck units */
    double area;                /* deck units squared */
    double perimeter;           /* deck units */
    double centroid[2];         /* of the area: BL, WL */
    int32_t has_perimeter;      /* 1: quadrature could measure it */
    int32_t spare;
} loft_duct_section;
int loft_deck_measure_duct(const loft_deck *deck, int body, int duct, loft_duct *measure,
    loft_error **error);
int loft_deck_measure_duct_station(const loft_deck *deck, int body, int duct, double sta,
    loft_duct_section *measure, loft_error **error);

/* --- conic cards of a 1970 deck ------------------------------------------------------------------ */

enum loft_axis { LOFT_X = 1, LOFT_Y = 2 };
typedef struct loft_row {
    double x, y;                /* deck units */
    double slope;               /* dy/dx; infinite where vertical */
    double curvature;           /* 1/deck unit, positive where the arc turns left */
} loft_row;

int loft_deck_card_count(const loft_deck *deck);
size_t loft_deck_card_label(const loft_deck *deck, int card, char *room, size_t size);
/* The table of a card by steps of an axis; without rows where the card does not ask for it or has no arc,
 * which is among the faults. Fails with LOFT_BAD_ARGUMENT; the result is then NULL. */
loft_table *loft_deck_table(const loft_deck *deck, int card, int axis, loft_error **error);
void loft_table_free(loft_table **table);
int loft_table_row_count(const loft_table *table);
int loft_table_rows(const loft_table *table, int first, int count, loft_row *rows); /* how many there were */

#ifdef __cplusplus
}
#endif

#endif
