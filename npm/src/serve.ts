// The worker's side: does what it is sent, one call after the other.
import type { MapEdit } from "./maps.js";
import { Planner, type PlannerMap } from "./planner.js";
import type { Call, FromWorker, MapFacts, Recipe, ToWorker } from "./worker_messages.js";

export function server(answer: (message: FromWorker) => void): (message: ToWorker) => void {
  let planner: Planner | undefined;
  const maps = new Map<number, PlannerMap>();

  function keep(id: number, map: PlannerMap): MapFacts {
    maps.set(id, map);
    return { width: map.width, height: map.height, obstacleCount: map.obstacleCount, digest: map.digest };
  }

  function make(id: number, { maker, parameters, edits }: Recipe): MapFacts {
    const make = planner![maker] as (...parameters: unknown[]) => PlannerMap;
    const map = make.apply(planner, parameters);
    if (edits.length === 0) return keep(id, map);
    const edited = map.with(edits);
    map.free();
    return keep(id, edited);
  }

  function run({ map: id, method, parameters }: Call): unknown {
    if (method === "make") return make(id, parameters[0] as Recipe);
    const map = maps.get(id)!;
    switch (method) {
      case "edit":
        return keep(parameters[0] as number, map.with(parameters[1] as MapEdit[]));
      case "free":
        map.free();
        return maps.delete(id);
      case "labels":
        return map.labels();
      case "obstacle":
        return map.obstacle(parameters[0] as number);
      default:
        return (planner![method] as (...parameters: unknown[]) => unknown).call(planner, map, ...parameters);
    }
  }

  return (message) => {
    if (message instanceof WebAssembly.Module) {
      planner = new Planner(message);
      return;
    }
    try {
      answer({ id: message.id, result: run(message) });
    } catch (error) {
      const { name, message: text } = error as Error;
      answer({ id: message.id, error: { name, message: text } });
    }
  };
}
