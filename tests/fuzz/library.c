/* The library under wild calls: a deck, from a file or from memory, then calls of every function with
 * numbers, counts, rooms and handles that a careless caller may give. What comes back is judged.
 *     library SEED DECK
 * Status 1 and a line of words where something is wrong. All memory it lends is as long as it says, so
 * that a sanitizer sees what reaches beyond.
 */
#include <float.h>
#include <limits.h>
#include <loft.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { CALLS = 16, MOST_POINTS = 200000 };
static uint64_t state;
static loft_deck *deck;

static unsigned below(unsigned n)               /* a number from 0 to n - 1 (xorshift64*) */
{
    state ^= state >> 12; state ^= state << 25; state ^= state >> 27;
    return (unsigned)((state * 2685821657736338717u) >> 33) % n;
}

static double wild_number(void)
{
    static const double hard[] = {NAN, INFINITY, -INFINITY, 0., -0., DBL_MAX, -DBL_MAX, DBL_MIN, 4.9e-324,
        1e-310, 1e22, 1e154, -1e154, 1e300, 1e-8, 1.};
    if (below(4) == 0) return hard[below(sizeof hard / sizeof *hard)];
    return (below(2001) - 1000.) / (below(2) ? 4. : 37.);
}

static int wild_int(void)
{
    static const int hard[] = {0, -1, INT_MAX, INT_MIN, 100000, 100001, 65536, -7};
    return below(5) == 0 ? hard[below(sizeof hard / sizeof *hard)] : (int)below(6);
}

static void wrong(const char *what)
{
    printf("wrong: %s\n", what);
    exit(1);
}

/* Judges a text: whole characters, ended by a null within its room, no longer than asked. */
#define TEXT(call) do { \
    size_t size = below(3) ? below(12) : 400, whole; \
    char *room = size || below(2) ? malloc(size ? size : 1) : NULL; \
    whole = call; \
    if (size && room && memchr(room, 0, size) == NULL) wrong("a text without its null"); \
    if (size && room && strlen(room) > whole) wrong("a text longer than it is"); \
    free(room); \
} while (0)

static loft_error **error_of(loft_error **error)        /* sometimes nobody asks */
{
    *error = NULL;
    return below(6) ? error : NULL;
}

/* A call that failed says why; one that did not has no error. */
static void judge_end(int is_done, loft_error **asked, loft_error **error)
{
    if (asked && is_done == (*error != NULL)) wrong(is_done ? "an error of what is done" : "no error of what failed");
    if (*error && loft_error_cause(*error) == LOFT_NO_ERROR) wrong("an error without a cause");
    if (*error && loft_error_message(*error, NULL, 0) == 0) wrong("an error without words");
    TEXT(loft_error_message(*error, room, size));
    loft_error_free(error);
    loft_error_free(error);
}

static int is_number(double value) { return value - value == 0.; }

static void judge_points(const loft_cut *cut)
{
    int count = loft_cut_point_count(cut), first = wild_int(), asked = wild_int(), got, i;
    loft_point *points;
    if (count < 0 || count > 100 * MOST_POINTS) wrong("a count of points that can't be");
    if (below(2)) { first = 1; asked = count; }
    if (asked > count) asked = count;
    points = malloc(asked > 0 ? (size_t)asked * sizeof *points : 1);
    got = loft_cut_points(cut, first, asked, points);
    if (got < 0 || got > (asked > 0 ? asked : 0)) wrong("more points than were asked for");
    for (i = 0; i < got; i++) {
        const loft_point *p = &points[i];
        double length = sqrt(p->normal[0] * p->normal[0] + p->normal[1] * p->normal[1] + p->normal[2] * p->normal[2]);
        if (!is_number(p->sta) || !is_number(p->bl) || !is_number(p->wl) || !is_number(p->u) || !is_number(p->v))
            wrong("a point that is none");
        if (isnan(p->slope) || !is_number(p->curvature) || !is_number(p->bevel)) wrong("a slope, curvature or bevel that is none");
        if (p->has & LOFT_HAS_NORMAL && fabs(length - 1.) > 1e-9) wrong("a normal that is no unit vector");
        if (fabs(p->bevel) > 90.000001) wrong("a bevel beyond a right angle");
        if (p->outline < 1 || p->outline > loft_cut_outline_count(cut)) wrong("a point of no outline");
    }
    free(points);
}

static void judge_cut(loft_cut **cut)
{
    loft_cut_kind(*cut);
    loft_cut_outline_is_closed(*cut, wild_int());
    TEXT(loft_cut_name(*cut, room, size));
    TEXT(loft_cut_section_name(*cut, wild_int(), room, size));
    TEXT(loft_cut_note(*cut, loft_cut_note_count(*cut) - (int)below(2), room, size));
    judge_points(*cut);
    loft_cut_free(cut);
    if (*cut) wrong("a handle after it was freed");
    loft_cut_free(cut);
}

static void make_cut(void)
{
    loft_error *error, **asked = error_of(&error);
    loft_spread wild = {wild_number(), below(6), wild_int(), (int)below(3), wild_int()};
    const loft_spread *spread = below(3) ? NULL : &wild;
    double point[3] = {wild_number(), wild_number(), wild_number()};
    double normal[3] = {wild_number(), wild_number(), wild_number()};
    const loft_deck *of = below(20) ? deck : NULL;
    int body = below(4) ? 1 : wild_int();
    loft_cut *cut;

    switch (below(5)) {
    case 0: cut = loft_deck_cut(of, wild_int(), asked); break;
    case 1: cut = loft_cut_station(of, body, wild_number(), spread, asked); break;
    case 2: cut = loft_cut_buttock(of, body, wild_number(), spread, asked); break;
    case 3: cut = loft_cut_waterline(of, body, wild_number(), spread, asked); break;
    default: cut = loft_cut_plane(of, body, below(20) ? point : NULL, below(20) ? normal : NULL, spread, asked);
    }
    judge_end(cut != NULL, asked, &error);
    judge_cut(&cut);
}

static void make_measure(void)
{
    loft_error *error, **asked = error_of(&error);
    loft_measure body;
    loft_section section;
    int number = below(4) ? 1 : wild_int(), is_done;

    if (below(2)) {
        is_done = loft_deck_measure(deck, number, below(20) ? &body : NULL, asked);
        if (is_done && body.has_volume && !is_number(body.volume)) wrong("a volume that is none");
        if (is_done && body.has_wetted && !is_number(body.wetted_area)) wrong("an area that is none");
        if (is_done && !memchr(body.why, 0, sizeof body.why)) wrong("a reason without its null");
    } else {
        is_done = loft_deck_measure_station(deck, number, wild_number(), below(20) ? &section : NULL, asked);
        if (is_done && section.has_area && !is_number(section.area)) wrong("an area that is none");
        if (is_done && section.has_girth && !is_number(section.girth)) wrong("a girth that is none");
    }
    judge_end(is_done, asked, &error);
}

static void make_table(void)
{
    loft_error *error, **asked = error_of(&error);
    loft_table *table = loft_deck_table(deck, wild_int(), below(4) ? 1 + (int)below(2) : wild_int(), asked);
    int count = loft_table_row_count(table), first = below(2) ? 1 : wild_int(), got, i;
    loft_row *rows = malloc(count > 0 ? (size_t)count * sizeof *rows : 1);

    judge_end(table != NULL, asked, &error);
    got = loft_table_rows(table, first, below(4) ? count : 0, rows);
    if (got < 0 || got > count) wrong("more rows than there are");
    for (i = 0; i < got; i++)
        if (!is_number(rows[i].x) || !is_number(rows[i].y) || isnan(rows[i].slope) || !is_number(rows[i].curvature))
            wrong("a row of numbers that are none");
    free(rows);
    loft_table_free(&table);
    loft_table_free(&table);
}

static void ask_deck(void)
{
    loft_fault fault;
    const loft_deck *of = below(10) ? deck : NULL;
    int number = below(3) ? 1 + (int)below(4) : wild_int();

    if (loft_deck_fault(of, number, &fault) && (fault.line < 0 || fault.first < 0 || fault.last < fault.first))
        wrong("a fault at no place");
    if (loft_deck_error_count(of) > loft_deck_fault_count(of)) wrong("more errors than faults");
    TEXT(loft_deck_title(of, room, size));
    TEXT(loft_deck_units(of, room, size));
    TEXT(loft_deck_fault_message(of, number, room, size));
    TEXT(loft_deck_fault_card(of, number, room, size));
    TEXT(loft_deck_body_name(of, number, room, size));
    TEXT(loft_deck_section_name(of, number, wild_int(), room, size));
    TEXT(loft_deck_cut_name(of, number, room, size));
    TEXT(loft_deck_card_label(of, number, room, size));
}

/* The deck in memory, as long as it is and no longer; sometimes cut short. */
static loft_deck *parsed(const char *path, loft_error **asked)
{
    FILE *file = fopen(path, "rb");
    size_t length;
    char *text, *exact;
    loft_deck *made;

    if (!file) exit(2);
    text = malloc(1 << 21);
    length = fread(text, 1, 1 << 21, file);
    fclose(file);
    if (below(4) == 0 && length > 0) length = below((unsigned)length);
    exact = malloc(length ? length : 1);
    memcpy(exact, text, length);
    free(text);
    made = loft_deck_parse(exact, length, asked);
    free(exact);
    return made;
}

int main(int argc, char **argv)
{
    loft_error *error, **asked;
    int i;

    if (argc != 3) return 2;
    state = strtoull(argv[1], NULL, 10) * 2654435761u + 88172645463325252u;
    asked = error_of(&error);
    deck = below(2) ? loft_deck_load(argv[2], asked) : parsed(argv[2], asked);
    judge_end(deck != NULL, asked, &error);
    for (i = 0; i < CALLS; i++)
        switch (below(8)) {
        case 0: ask_deck(); break;
        case 1: make_measure(); break;
        case 2: make_table(); break;
        default: make_cut();
        }
    loft_deck_free(&deck);
    loft_deck_free(&deck);
    ask_deck();
    make_cut();
    return 0;
}
