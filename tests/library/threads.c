/* Eight threads load and cut different decks, over and over, and make errors between; what each gets is
 * compared with what one thread alone gets. Then they share one deck.
 *     threads ROUNDS DECK...
 */
#include <loft.h>
#include <pthread.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { THREADS = 8 };

/* FNV-1a. */
static uint64_t add(uint64_t sum, const void *bytes, size_t count)
{
    const unsigned char *byte = bytes;
    while (count--) sum = (sum ^ *byte++) * UINT64_C(1099511628211);
    return sum;
}

static uint64_t add_cut(uint64_t sum, loft_cut *cut)
{
    int i;
    for (i = 1; i <= loft_cut_point_count(cut); i++) {
        loft_point point;
        loft_cut_points(cut, i, 1, &point);
        sum = add(sum, &point, sizeof point);
    }
    loft_cut_free(&cut);
    return sum;
}

/* What the bodies of a deck measure, and their ducts. */
static uint64_t add_measures(uint64_t sum, const loft_deck *deck)
{
    int body, duct;
    for (body = 1; body <= loft_deck_body_count(deck); body++) {
        loft_measure whole;
        memset(&whole, 0, sizeof whole);
        if (loft_deck_measure(deck, body, &whole, NULL)) {
            sum = add(sum, &whole.volume, sizeof whole.volume);
            sum = add(sum, whole.why, strlen(whole.why));
        }
        for (duct = 1; duct <= loft_deck_duct_count(deck, body); duct++) {
            loft_duct measure;
            loft_duct_section section;
            if (!loft_deck_measure_duct(deck, body, duct, &measure, NULL)) continue;
            sum = add(sum, &measure, sizeof measure);
            loft_deck_measure_duct_station(deck, body, duct, (measure.from + measure.to) / 2, &section, NULL);
            sum = add(sum, &section, sizeof section);
        }
    }
    return sum;
}

/* All that a deck gives: faults, cuts, another cut, an error, measures, tables. */
static uint64_t sum_of(const loft_deck *deck)
{
    uint64_t sum = UINT64_C(14695981039346656037);
    const double point[3] = {10, 0, -10}, normal[3] = {1, 0.25, 0.5};
    char text[400];
    int i;

    for (i = 1; i <= loft_deck_fault_count(deck); i++) {
        size_t length = loft_deck_fault_message(deck, i, text, sizeof text);
        sum = add(sum, text, length < sizeof text ? length : sizeof text - 1);
    }
    for (i = 1; i <= loft_deck_cut_count(deck); i++) sum = add_cut(sum, loft_deck_cut(deck, i, NULL));
    sum = add_cut(sum, loft_cut_plane(deck, 1, point, normal, NULL, NULL));
    for (i = 1; i <= 20; i++) {
        loft_error *error = NULL;
        loft_cut *none = loft_cut_station(deck, 1, -1e5 * i * i, NULL, &error);
        size_t length = loft_error_message(error, text, sizeof text);
        sum = add(sum, text, length < sizeof text ? length : sizeof text - 1);
        loft_error_free(&error);
        loft_cut_free(&none);
    }
    sum = add_measures(sum, deck);
    for (i = 1; i <= loft_deck_card_count(deck); i++) {
        loft_table *table = loft_deck_table(deck, i, LOFT_X, NULL);
        int k;
        for (k = 1; k <= loft_table_row_count(table); k++) {
            loft_row row;
            loft_table_rows(table, k, 1, &row);
            sum = add(sum, &row, sizeof row);
        }
        loft_table_free(&table);
    }
    return sum;
}

static uint64_t load_and_sum(const char *path)
{
    loft_deck *deck = loft_deck_load(path, NULL);
    uint64_t sum = sum_of(deck);
    loft_deck_free(&deck);
    return sum;
}

struct task {
    pthread_t thread;
    char **decks;               /* all decks */
    const uint64_t *sums;       /* of each, as one thread finds them */
    const loft_deck *shared;    /* the first of them, loaded */
    int count, number, rounds;
    long wrong;
};

static void *work(void *argument)
{
    struct task *task = argument;
    int i;
    for (i = 0; i < task->rounds; i++) {
        int k = (task->number + i) % task->count;
        if (load_and_sum(task->decks[k]) != task->sums[k]) task->wrong++;
        if (sum_of(task->shared) != task->sums[0]) task->wrong++;
    }
    return NULL;
}

int main(int argc, char **argv)
{
    struct task tasks[THREADS];
    uint64_t sums[64];
    loft_deck *shared;
    long wrong = 0;
    int i, k, count = argc - 2;

    if (count < 1 || count > 64) return 2;
    for (i = 0; i < count; i++) {
        sums[i] = load_and_sum(argv[2 + i]);
        for (k = 0; k < i; k++) if (sums[k] == sums[i]) return 3;
    }
    shared = loft_deck_load(argv[2], NULL);
    for (i = 0; i < THREADS; i++) {
        tasks[i].decks = argv + 2;
        tasks[i].sums = sums;
        tasks[i].shared = shared;
        tasks[i].count = count;
        tasks[i].number = i;
        tasks[i].rounds = atoi(argv[1]);
        tasks[i].wrong = 0;
        if (pthread_create(&tasks[i].thread, NULL, work, &tasks[i])) return 4;
    }
    for (i = 0; i < THREADS; i++) {
        pthread_join(tasks[i].thread, NULL);
        wrong += tasks[i].wrong;
    }
    loft_deck_free(&shared);
    printf("%d threads, %d rounds, %ld wrong\n", THREADS, atoi(argv[1]), wrong);
    return wrong > 0;
}
