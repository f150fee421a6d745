// What happened and what it costs, in one sentence: what the person reads first.
import { plainName } from "../domain/plain_name";
import { objectiveOf } from "../domain/plan";
import { clockTime, difference, duration, type Units } from "../domain/units";
import { isWeighed } from "../domain/weights";
import { nameOf } from "../play/story";
import type { News } from "./news";
import type { Step } from "./rehearsal";

// What the words need to know of the page.
export interface Telling {
  units: Units;
  obstacle: (id: number) => string; // its name
}

// “The breach of Town Hall failed at 0:42”
export function newsWords(news: News, { before }: Pick<Step, "before">, { units, obstacle }: Telling): string {
  const at = clockTime(news.at, units);
  const who = (id: string) => capital(nameOf(before.agents.find((agent) => agent.id === id)!));
  switch (news.kind) {
    case "failed":
      return `The breach of ${obstacle(news.obstacle)} failed at ${at}`;
    case "rubble":
      return `Rubble fell on the street at ${at}`;
    case "delayed":
      return `${who(news.agent)} stood still for ${duration(news.by, units)} from ${at} on`;
    case "lost":
      return `${who(news.agent)} was lost at ${at}`;
  }
}

// “the mission ends 1 min 10 s later, at 6:05”
export function costWords(step: Step, units: Units): string {
  const { answer, was, is } = step;
  if (is === null || was === null) return withoutPlan(step, units);
  const isSum = objectiveOf(step.before) === "flowtime";
  const change = changeWords(was, is, units);
  if (isSum && isWeighed(step.before)) return averageWords(step, change, clockTime(is, units));
  if (isSum) return `together the agents need ${change ?? "no longer"}, ${clockTime(is, units)}`;
  const subject = objectiveOf(step.before) === "ground-makespan" ? "the last vehicle arrives" : "the mission ends";
  if (change) return `${subject} ${change}, at ${clockTime(is, units)}`;
  const how = answer.status === "kept" ? "the plan holds, and " : "";
  return `${how}${subject} at ${clockTime(is, units)}, no later than before`;
}

// “the weighted average arrival is 1 min 10 s later, at 6:05; yard is no longer reached”
function averageWords({ before, story }: Step, change: string | null, at: string): string {
  const average = `the weighted average arrival is ${change ? `${change}, at ${at}` : `at ${at}, no later than before`}`;
  const wasReached = new Set(before.agents.flatMap(({ id, reached }) => (reached === false ? [] : [id])));
  const left = story.agents.filter(({ id, reached }) => reached === false && wasReached.has(id)).map(({ id }) => plainName(id));
  if (left.length === 0) return average;
  const who = left.length > 2 ? `${left.length} places` : left.join(" and ");
  return `${average}; ${who} ${left.length === 1 ? "is" : "are"} no longer reached`;
}

export function stepWords(step: Step, telling: Telling): string {
  return `${newsWords(step.news, step, telling)}: ${costWords(step, telling.units)}.`;
}

// What all of it costs; null where one sentence says so already.
export function sumWords(steps: readonly Step[], units: Units): string | null {
  const [first, last] = [steps[0], steps.at(-1)];
  if (steps.length < 2 || !first || !last || first.was === null || last.is === null) return null;
  return `In all ${changeWords(first.was, last.is, units) ?? "no later"} than planned.`;
}

// Null where nobody would notice.
function changeWords(was: number, is: number, units: Units): string | null {
  if (clockTime(was, units) === clockTime(is, units)) return null;
  return is > was ? `${difference(was, is, units)} later` : `${difference(is, was, units)} earlier`;
}

function withoutPlan({ answer, before }: Step, units: Units): string {
  if (answer.status === "broken") {
    const name = (id: string) => nameOf(before.agents.find((agent) => agent.id === id)!);
    const halts = answer.halts.map(({ agent, by }) => `${name(agent)} has to stop by ${clockTime(by, units)}`);
    return halts.length > 0 ? halts.join(", ") : "nobody can keep to the plan until a new one is known";
  }
  return answer.reason === "no_plan" ? "no way is left" : "no plan was found in the time there was";
}

function capital(text: string): string {
  return text.charAt(0).toUpperCase() + text.slice(1);
}
