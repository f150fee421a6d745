// A level in, a plan out, in C: a mission document on a map of labels, what an error says, and the check of the plan.
#include <stdio.h>
#include <string.h>
#include <waybreaker.h>

enum { width = 12, height = 5 };

// There is a way around the first wall, and none past the second. Its number is what the level knows a wall by.
static const char* const level[height] = {
    "...7....9...",  //
    "...7....9...",  //
    "...7....9...",  //
    "...7....9...",  //
    "........9...",
};

static const char* const mission =
    "{\"format\": \"waybreaker-mission/1\","
    " \"agents\": [{\"id\": \"rover\", \"kind\": \"ground\", \"start\": [1, 1], \"goal\": [10, 1]},"
    "              {\"id\": \"drone\", \"kind\": \"air\", \"start\": [1, 1], \"goal\": [10, 1], \"speed\": 2}],"
    " \"rules\": {\"removals\": 1, \"breach_time\": 3}}";

static waybreaker_status make_map(waybreaker_map** map, waybreaker_text** error) {
    uint32_t labels[width * height];
    for (int i = 0; i < width * height; ++i) {
        const char cell = level[i / width][i % width];
        labels[i] = cell == '.' ? 0 : (uint32_t)(cell - '0');
    }
    waybreaker_attributes walls[10];
    for (int i = 0; i < 10; ++i) {
        const waybreaker_attributes wall = {.source_id = i, .weight = 1, .breach_time = 0, .destructible = true};
        walls[i] = wall;
    }
    return waybreaker_map_from_labels("level 1", labels, width, height, walls, 10, 0, map, error);
}

static waybreaker_status plan_and_check(waybreaker_planner* planner, const waybreaker_map* map,
                                        waybreaker_text** error) {
    waybreaker_text* plan = NULL;
    waybreaker_status status = waybreaker_plan(planner, map, mission, strlen(mission), false, &plan, error);
    if (status == WAYBREAKER_OK) {
        fputs(waybreaker_text_data(plan), stdout);
        bool valid = false;
        waybreaker_text* report = NULL;
        status = waybreaker_check(map, waybreaker_text_data(plan), waybreaker_text_size(plan), &valid, &report, error);
        if (status == WAYBREAKER_OK) printf("the plan is %s\n", valid ? "valid" : "not valid");
        waybreaker_text_free(report);
    }
    waybreaker_text_free(plan);
    return status;
}

int main(void) {
    waybreaker_map* map = NULL;
    waybreaker_text* error = NULL;
    waybreaker_planner* planner = waybreaker_planner_new();
    waybreaker_status status = make_map(&map, &error);
    if (status == WAYBREAKER_OK) status = plan_and_check(planner, map, &error);
    if (status != WAYBREAKER_OK) fprintf(stderr, "%s\n", waybreaker_text_data(error));

    // What is wrong is said in a line.
    waybreaker_text* none = NULL;
    waybreaker_text* why = NULL;
    if (waybreaker_plan(planner, map, "{}", 2, false, &none, &why) == WAYBREAKER_INPUT_ERROR) {
        printf("%s\n", waybreaker_text_data(why));
    }

    waybreaker_text_free(why);
    waybreaker_text_free(error);
    waybreaker_planner_free(planner);
    waybreaker_map_free(map);
    return status == WAYBREAKER_OK ? 0 : 1;
}
