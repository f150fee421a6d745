// usage: plan MAP MISSION: the plan file, by the library for C.
#include <stdio.h>
#include <string.h>
#include <waybreaker.h>

// Zero if it cannot be read, or is too long.
static size_t read_file(const char* path, char* bytes, size_t capacity) {
    FILE* file = fopen(path, "rb");
    if (file == NULL) return 0;
    const size_t size = fread(bytes, 1, capacity, file);
    fclose(file);
    return size < capacity ? size : 0;
}

int main(int count, char** words) {
    static char map_file[1 << 20], mission[1 << 12];
    if (count != 3) return 2;
    const size_t map_size = read_file(words[1], map_file, sizeof map_file);
    const size_t mission_size = read_file(words[2], mission, sizeof mission);

    waybreaker_map* map = NULL;
    waybreaker_text* plan = NULL;
    waybreaker_text* error = NULL;
    waybreaker_planner* planner = waybreaker_planner_new();
    const bool planned =
        waybreaker_map_from_movingai(words[1], map_file, map_size, 4, 0, &map, &error) == WAYBREAKER_OK &&
        waybreaker_plan(planner, map, mission, mission_size, false, &plan, &error) == WAYBREAKER_OK;
    fputs(waybreaker_text_data(plan), stdout);
    fputs(waybreaker_text_data(error), stderr);
    waybreaker_text_free(error);
    waybreaker_text_free(plan);
    waybreaker_planner_free(planner);
    waybreaker_map_free(map);
    return planned ? 0 : 1;
}
