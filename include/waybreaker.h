// The C interface: maps in, missions and plans as documents.
//
//     waybreaker_map* map = NULL;
//     waybreaker_text *plan = NULL, *error = NULL;
//     waybreaker_planner* planner = waybreaker_planner_new();
//     if (waybreaker_map_from_movingai("level.map", bytes, size, 4, 0, &map, &error) == WAYBREAKER_OK &&
//         waybreaker_plan(planner, map, mission, strlen(mission), false, &plan, &error) == WAYBREAKER_OK)
//         puts(waybreaker_text_data(plan));
//     else
//         fprintf(stderr, "%s\n", waybreaker_text_data(error));
//
// Missions, plans and reports are JSON documents (docs/contract.md). The same mission on the same map gives the same
// bytes, and they are what the command `waybreaker plan` writes.
//
// Lifetimes. Whoever receives a handle, through a `**` parameter or from waybreaker_planner_new, owns it and frees it
// once, with the function of its kind. Freeing NULL does nothing. Nothing that is passed in is kept: bytes, names and
// documents may go when the call returns. A text depends on nothing that it was made from. Pointers into a handle (the
// data of a text, the labels of a map) are valid until it is freed.
//
// Errors. A call that can fail returns a status. If that is not WAYBREAKER_OK, the result is NULL and `*error` is a
// message, one line for a person; NULL where there is no memory for it. If it is WAYBREAKER_OK, `*error` is NULL.
// `error` may be NULL. What `*error` and the result were before is neither read nor freed. "No plan" is no error: the
// plan's "status" says so. No C++ exception leaves a call.
//
// Threads. A map never changes: any number of threads may use one. A planner is for one thread at a time, except that
// any thread may call waybreaker_planner_stop while the planner lives. All work is done by the thread that calls.
//
// Sizes are in bytes. Text that is passed in with a size is UTF-8 and needs no NUL at its end.
#ifndef WAYBREAKER_H
#define WAYBREAKER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

// As in waybreaker/version.hpp.
#define WAYBREAKER_VERSION_MAJOR 0
#define WAYBREAKER_VERSION_MINOR 2
#define WAYBREAKER_VERSION_PATCH 0
#define WAYBREAKER_VERSION_STRING "0.2.0"
#define WAYBREAKER_VERSION \
    (WAYBREAKER_VERSION_MAJOR * 10000 + WAYBREAKER_VERSION_MINOR * 100 + WAYBREAKER_VERSION_PATCH)

#ifdef __cplusplus
extern "C" {
#endif

typedef enum waybreaker_status {
    WAYBREAKER_OK = 0,
    WAYBREAKER_INPUT_ERROR = 1,    // what was passed in is wrong: the message says what, and the remedy
    WAYBREAKER_OUT_OF_MEMORY = 2,  // all that was passed in is as before
    WAYBREAKER_INTERNAL_ERROR = 3  // a fault of the library: please report it
} waybreaker_status;

typedef struct waybreaker_map waybreaker_map;
typedef struct waybreaker_planner waybreaker_planner;
typedef struct waybreaker_text waybreaker_text;

// The version of the library that runs, such as "0.2.0". The macros above are the version of this header.
const char* waybreaker_version(void);

// ---- Texts ----

// The bytes of a text, with a NUL behind them. Of NULL: "".
const char* waybreaker_text_data(const waybreaker_text* text);
// Without that NUL.
size_t waybreaker_text_size(const waybreaker_text* text);
void waybreaker_text_free(waybreaker_text* text);

// ---- Maps ----
//
// Cells are counted from the upper left one, (0, 0): x to the right, y down. Arrays hold row after row. A side has 1 to
// 32768 cells, a map at most 268435456.
//
// `name` is what plans call the map's source; NULL stands for "map". `connectivity` says which blocked cells are one
// obstacle: 4: those that share a side; 8: or a corner. `cell_size` is how many metres a cell measures, 0.000001 to
// 1000000; 0: unknown, and plans speak of cells alone.

// From the bytes of a MovingAI map file. Plans on it equal those of the command for a file of that name.
waybreaker_status waybreaker_map_from_movingai(const char* name, const char* bytes, size_t size, int connectivity,
                                               double cell_size, waybreaker_map** map, waybreaker_text** error);

// From width * height bytes, 0 where a cell is free. Equals a map from the MovingAI file that `waybreaker map convert`
// writes of these cells.
waybreaker_status waybreaker_map_from_grid(const char* name, const uint8_t* blocked, int32_t width, int32_t height,
                                           int connectivity, double cell_size, waybreaker_map** map,
                                           waybreaker_text** error);

// What is known of an obstacle beside its cells.
typedef struct waybreaker_attributes {
    int64_t source_id;   // who it is where the map comes from; 0: unknown
    double weight;       // what its removal counts for against a budget, 1e-9 to 1e12; 1 where nobody says it
    double breach_time;  // how long its breach takes, beside what the mission says, 0 to 1e9
    bool destructible;   // whether it can be removed; true where nobody says it
} waybreaker_attributes;

// From width * height labels: 0 where a cell is free; cells of the same number are one obstacle, wherever they lie.
// `attributes[label]` describes the obstacle of that label; entry 0 is not used. Labels that are not below
// `attribute_count` have source id 0, weight 1, breach time 0, and are destructible. NULL if `attribute_count` is 0.
waybreaker_status waybreaker_map_from_labels(const char* name, const uint32_t* labels, int32_t width, int32_t height,
                                             const waybreaker_attributes* attributes, size_t attribute_count,
                                             double cell_size, waybreaker_map** map, waybreaker_text** error);

void waybreaker_map_free(waybreaker_map* map);

// 0 or NULL for NULL.
int32_t waybreaker_map_width(const waybreaker_map* map);
int32_t waybreaker_map_height(const waybreaker_map* map);
uint32_t waybreaker_map_obstacle_count(const waybreaker_map* map);
// Of each cell the id of its obstacle, 0 where it is free. Ids are 1, 2, 3, ... in scan order, whatever the labels were
// that the map was made from; those that edits add come last.
const uint32_t* waybreaker_map_labels(const waybreaker_map* map);
// "sha256:..." of what the map was made from, as plans state it (docs/c.md).
const char* waybreaker_map_digest(const waybreaker_map* map);

typedef struct waybreaker_obstacle {
    uint32_t id;
    uint32_t cells;                      // how many it has
    int32_t min_x, min_y, max_x, max_y;  // its bounding box, all four included
    waybreaker_attributes attributes;
} waybreaker_obstacle;

// False, and nothing is written, unless `id` is 1 to waybreaker_map_obstacle_count. One that edits have taken away has
// no cells, and its bounding box is empty: min_x > max_x.
bool waybreaker_map_obstacle(const waybreaker_map* map, uint32_t id, waybreaker_obstacle* obstacle);

typedef struct waybreaker_cell {
    int32_t x, y;
} waybreaker_cell;

typedef enum waybreaker_edit_kind {
    WAYBREAKER_EDIT_REMOVE = 0,  // all cells of the obstacle are free then, and it is gone
    WAYBREAKER_EDIT_ADD = 1,     // a new obstacle has these cells; its id is the one after the last
    WAYBREAKER_EDIT_EXTEND = 2,  // the obstacle has these cells as well, whatever they were
    WAYBREAKER_EDIT_FREE = 3     // these cells are free
} waybreaker_edit_kind;

// Members that a kind does not name are not read.
typedef struct waybreaker_edit {
    int32_t kind;                      // a waybreaker_edit_kind
    uint32_t obstacle;                 // of remove and extend
    const waybreaker_cell* cells;      // of add, extend and free
    size_t cell_count;                 // of those
    waybreaker_attributes attributes;  // of add
} waybreaker_edit;

// The map with its obstacles changed, one edit after the other; the map that is passed in stays as it is. All other
// obstacles keep their ids, and rows that stay the same are shared: it costs a small part of a new map.
waybreaker_status waybreaker_map_with(const waybreaker_map* map, const waybreaker_edit* edits, size_t edit_count,
                                      waybreaker_map** edited, waybreaker_text** error);

// ---- Planning ----

// NULL if there is no memory for it. A planner keeps its memory from call to call.
waybreaker_planner* waybreaker_planner_new(void);
void waybreaker_planner_free(waybreaker_planner* planner);

// The plan ("waybreaker-plan/1") of a mission ("waybreaker-mission/1"), as `waybreaker plan` writes it for a map and a
// --mission; without `timing_fields` (--no-timing) it holds no measured seconds. A mission that does not limit its
// seconds has 10 of them.
waybreaker_status waybreaker_plan(waybreaker_planner* planner, const waybreaker_map* map, const char* mission,
                                  size_t mission_size, bool timing_fields, waybreaker_text** plan,
                                  waybreaker_text** error);

// What each removal gains: a plan with as many as are worth it, up to the mission's number. Its "front" says what 0, 1,
// 2, ... removals reach.
waybreaker_status waybreaker_front(waybreaker_planner* planner, const waybreaker_map* map, const char* mission,
                                   size_t mission_size, bool timing_fields, waybreaker_text** plan,
                                   waybreaker_text** error);

// The rest of a mission planned anew, from what has happened: the plan ("waybreaker-plan/1") that takes over from
// `plan`, as `waybreaker revise --json` writes it for a `state` ("waybreaker-state/1", docs/live.md). The map is the
// one that the mission began on: what was found since is in the plans. `reaction`: how long it takes until agents know
// of the new plan, 0 to 1e9 units of time. `seconds`: how long to plan at most, as limits of missions have it; INFINITY
// is no limit.
//
// Its "revision" says what has become of `plan`, in "status": "kept", "revised", "no_plan" (and the plan's own "status"
// why), or "broken": then "halts" says who must stop, before which point of its path, by when. A report that `plan`
// knows already gives `plan` once more. "supersedes" is the SHA-256 of the bytes that are passed in as `plan`.
waybreaker_status waybreaker_revise(waybreaker_planner* planner, const waybreaker_map* map, const char* plan,
                                    size_t plan_size, const char* state, size_t state_size, double reaction,
                                    double seconds, bool timing_fields, waybreaker_text** revised,
                                    waybreaker_text** error);

// Lets the call that runs on the planner end soon, with the best plan found by then ("limit_reached"), or with one of
// status "stopped". Does nothing if none runs, nor to calls that begin later.
void waybreaker_planner_stop(waybreaker_planner* planner);

// ---- Plans ----

// Judges a plan from the map alone: the report ("waybreaker-check/1") that `waybreaker check --json -` writes.
// `*valid`, if `valid` is not NULL: whether nothing is wrong.
waybreaker_status waybreaker_check(const waybreaker_map* map, const char* plan, size_t plan_size, bool* valid,
                                   waybreaker_text** report, waybreaker_text** error);

// Judges a plan that revises `before`, from a state: also whether it goes on from there, as `waybreaker check --after`
// does. Everybody keeps to what he was bound to do, nobody is forgotten, and what is open, failed or used up counts.
waybreaker_status waybreaker_check_after(const waybreaker_map* map, const char* plan, size_t plan_size,
                                         const char* before, size_t before_size, const char* state, size_t state_size,
                                         bool* valid, waybreaker_text** report, waybreaker_text** error);

// The picture of a plan that is valid on the map.
waybreaker_status waybreaker_plan_svg(const waybreaker_map* map, const char* plan, size_t plan_size,
                                      waybreaker_text** svg, waybreaker_text** error);

#ifdef __cplusplus
}
#endif

#endif
