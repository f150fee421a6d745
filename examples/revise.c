// A plan that meets the field, in C: a breach fails, the rest of the mission is planned anew, and the check says
// whether it goes on from where everybody is. Then the wall falls after all, and the map changes by an edit.
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <waybreaker.h>

static const char* const level =
    "type octile\nheight 4\nwidth 9\nmap\n"
    "....@....\n"
    "....@....\n"
    "....@....\n"
    ".........\n";

static const char* const mission =
    "{\"format\": \"waybreaker-mission/1\","
    " \"agents\": [{\"id\": \"rover\", \"kind\": \"ground\", \"start\": [0, 1], \"goal\": [8, 1]},"
    "              {\"id\": \"drone\", \"kind\": \"air\", \"start\": [0, 1], \"goal\": [0, 1]}],"
    " \"rules\": {\"removals\": 1, \"breach_time\": 1}}";

// What the drone reports: the wall, obstacle 1, still stands.
static const char* const state =
    "{\"format\": \"waybreaker-state/1\", \"sequence\": 1, \"now\": 4,"
    " \"failed\": [{\"obstacle\": 1, \"at\": 4}]}";

static waybreaker_status revise_and_check(waybreaker_planner* planner, const waybreaker_map* map,
                                          waybreaker_text** error) {
    waybreaker_text* plan = NULL;
    waybreaker_text* next = NULL;
    waybreaker_text* report = NULL;
    bool valid = false;
    waybreaker_status status = waybreaker_plan(planner, map, mission, strlen(mission), false, &plan, error);
    const char* const before = waybreaker_text_data(plan);
    const size_t before_size = waybreaker_text_size(plan);
    if (status == WAYBREAKER_OK) {
        status = waybreaker_revise(planner, map, before, before_size, state, strlen(state), 0, INFINITY, false, &next,
                                   error);
    }
    if (status == WAYBREAKER_OK) {
        fputs(waybreaker_text_data(next), stdout);
        status = waybreaker_check_after(map, waybreaker_text_data(next), waybreaker_text_size(next), before,
                                        before_size, state, strlen(state), &valid, &report, error);
    }
    if (status == WAYBREAKER_OK) printf("the plan %s\n", valid ? "goes on from the one before" : "is not valid");
    waybreaker_text_free(report);
    waybreaker_text_free(next);
    waybreaker_text_free(plan);
    return status;
}

static waybreaker_status let_fall(const waybreaker_map* map, waybreaker_text** error) {
    const waybreaker_edit falls = {.kind = WAYBREAKER_EDIT_REMOVE, .obstacle = 1};
    waybreaker_map* edited = NULL;
    const waybreaker_status status = waybreaker_map_with(map, &falls, 1, &edited, error);
    waybreaker_obstacle wall;
    if (waybreaker_map_obstacle(edited, 1, &wall))
        printf("wall %u has %u cells\n", (unsigned)wall.id, (unsigned)wall.cells);
    waybreaker_map_free(edited);
    return status;
}

int main(void) {
    waybreaker_map* map = NULL;
    waybreaker_text* error = NULL;
    waybreaker_planner* planner = waybreaker_planner_new();
    waybreaker_status status = waybreaker_map_from_movingai("level 1", level, strlen(level), 4, 0, &map, &error);
    if (status == WAYBREAKER_OK) status = revise_and_check(planner, map, &error);
    if (status == WAYBREAKER_OK) status = let_fall(map, &error);
    if (status != WAYBREAKER_OK) fprintf(stderr, "%s\n", waybreaker_text_data(error));
    waybreaker_text_free(error);
    waybreaker_planner_free(planner);
    waybreaker_map_free(map);
    return status == WAYBREAKER_OK ? 0 : 1;
}
