/* All rows of a deck as `loft run --format csv` prints them, without the header.
 *     rows DECK
 */
#include <loft.h>
#include <math.h>
#include <stdio.h>

static const char *const kinds[] = {"", "station", "buttock", "waterline", "oblique", "plane"};

static void number(double value)
{
    printf(",");
    if (isinf(value)) printf("inf"); else printf("%.17g", value);
}

static void print_cut(int i, loft_cut *cut)
{
    int k;
    for (k = 1; k <= loft_cut_point_count(cut); k++) {
        loft_point p;
        char section[16];
        loft_cut_points(cut, k, 1, &p);
        loft_cut_section_name(cut, p.section, section, sizeof section);
        printf("%d,%s,%s", i, kinds[loft_cut_kind(cut)], section);
        number(p.sta); number(p.bl); number(p.wl);
        if (p.has & LOFT_HAS_SLOPE) number(p.slope); else printf(",");
        if (p.has & LOFT_HAS_CURVATURE) number(p.curvature); else printf(",");
        if (p.has & LOFT_HAS_NORMAL) number(p.bevel); else printf(",");
        printf("\n");
    }
    loft_cut_free(&cut);
}

static void print_table(int card, int axis, loft_table *table)
{
    int k;
    for (k = 1; k <= loft_table_row_count(table); k++) {
        loft_row r;
        loft_table_rows(table, k, 1, &r);
        printf("%d,%s", card, axis == LOFT_X ? "X" : "Y");
        number(r.x); number(r.y); number(r.slope); number(r.curvature);
        printf("\n");
    }
    loft_table_free(&table);
}

int main(int argc, char **argv)
{
    loft_deck *deck = argc == 2 ? loft_deck_load(argv[1], NULL) : NULL;
    int i, axis;
    for (i = 1; i <= loft_deck_cut_count(deck); i++) print_cut(i, loft_deck_cut(deck, i, NULL));
    for (i = 1; i <= loft_deck_card_count(deck); i++)
        for (axis = LOFT_X; axis <= LOFT_Y; axis++) print_table(i, axis, loft_deck_table(deck, i, axis, NULL));
    loft_deck_free(&deck);
    return 0;
}
