// Places beside one another, each as near as can be to where it belongs: the least that they have to move in all (squared).
export function spread(wanted: readonly number[], apart: number): number[] {
  const order = wanted.map((at, i) => ({ at, i })).sort((a, b) => a.at - b.at || a.i - b.i);
  // Runs of places that touch: each where its members want it on average, once their own places in it are taken off.
  const runs: { sum: number; members: number[] }[] = [];
  const start = ({ sum, members }: (typeof runs)[number]) => sum / members.length;
  for (const { at, i } of order) {
    runs.push({ sum: at, members: [i] });
    for (let last = runs.at(-1)!, before = runs.at(-2); before; before = runs.at(-2)) {
      const end = before.members.length * apart;
      if (start(last) >= start(before) + end) break;
      before.sum += last.sum - last.members.length * end;
      before.members.push(...last.members);
      runs.pop();
      last = before;
    }
  }
  const places: number[] = [];
  for (const run of runs) run.members.forEach((member, k) => (places[member] = start(run) + k * apart));
  return places;
}
